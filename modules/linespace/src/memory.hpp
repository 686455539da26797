// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Memory that is kept between calls, and what a user is told when there is none.

#ifndef OPENCV_LINESPACE_MEMORY_HPP
#define OPENCV_LINESPACE_MEMORY_HPP

#include "precomp.hpp"

#include <new>

namespace cv {
namespace linespace {

//! Grows when needed; its contents are not initialised.
class Buffer
{
public:
    Buffer() : data_(0), size_(0) {}
    ~Buffer() { release(); }
    //! Makes at least `size` bytes available; the old contents are lost. Throws std::bad_alloc.
    void allocate(size_t size)
    {
        if (size <= size_)
            return;
        release();
        try
        {
            data_ = (uchar*)fastMalloc(size);
        }
        catch (const Exception&)
        {
            throw std::bad_alloc();
        }
        size_ = size;
    }
    void release()
    {
        fastFree(data_);
        data_ = 0;
        size_ = 0;
    }
    uchar* data() const { return data_; }

private:
    Buffer(const Buffer&);
    Buffer& operator=(const Buffer&);
    uchar* data_;
    size_t size_;
};

//! Runs work() and turns a failed allocation into a cv::Exception that names the image `name` and
//! its size.
template<class Work>
void withMemoryFor(const char* name, Size size, Work work)
{
    bool failed = false;
    try
    {
        work();
    }
    catch (const std::bad_alloc&)
    {
        failed = true;
    }
    catch (const Exception& error)
    {
        // What cv::Mat throws; other exceptions of that code are messages of our own.
        if (error.code != Error::StsNoMem || error.func != "OutOfMemoryError")
            throw;
        failed = true;
    }
    if (failed)
        CV_Error_(Error::StsNoMem,
                  ("%s has %d x %d pixels: there is not enough memory for it, it must be smaller",
                   name, size.width, size.height));
}

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_MEMORY_HPP
