// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What all stages on an OpenCL device share: memory, and launches of kernels. Only for files that
// are compiled with HAVE_OPENCL.
//
// Environment: LINESPACE_OPENCL_KERNELS=processor or graphics chooses the variants of kernels, so
// that tests run both on any device.

#ifndef OPENCV_LINESPACE_OCL_LAUNCH_HPP
#define OPENCV_LINESPACE_OCL_LAUNCH_HPP

#include "stages.hpp"

#include <opencv2/core/ocl.hpp>

#include <cstring>
#include <functional>

namespace cv {
namespace linespace {

//! The type of votes of so many bytes, in OpenCL C.
const char* typeOf(int depth);

//! Throws DeviceFailure if the device does not give so many bytes at once.
void checkAllocation(double bytes);

//! Makes a row of at least so many bytes on the device; what it held may be lost.
void allocateOn(UMat& memory, size_t bytes);

//! Throws DeviceFailure if what was allocated is on the host.
void checkIsOnDevice(const UMat& memory);

//! Does it; an exception of OpenCV's becomes a DeviceFailure.
void copyOnDevice(const std::function<void()>& copy);

void uploadBytes(const void* from, size_t bytes, UMat& memory);
template<class Element>
void upload(const std::vector<Element>& from, UMat& memory)
{
    uploadBytes(from.data(), from.size() * sizeof(Element), memory);
}

/** Uploads a list, unless the memory has it already.
@param known what it has. An upload waits for what is queued. */
template<class Element>
void uploadNew(const std::vector<Element>& list, std::vector<Element>& known, UMat& memory)
{
    const size_t bytes = list.size() * sizeof(Element);
    if (list.size() == known.size() && !std::memcmp(list.data(), known.data(), bytes))
        return;
    known.clear();
    upload(list, memory);
    known = list;
}

//! Waits for the device.
void download(const UMat& memory, size_t bytes, void* to);

inline ocl::KernelArg in(const UMat& memory)
{
    return ocl::KernelArg::PtrReadOnly(memory);
}
inline ocl::KernelArg out(const UMat& memory)
{
    return ocl::KernelArg::PtrWriteOnly(memory);
}
inline ocl::KernelArg inOut(const UMat& memory)
{
    return ocl::KernelArg::PtrReadWrite(memory);
}

//! The programs of opencl/, each after chords.cl, which all use, some after pixels.cl or
//! segments.cl as well.
enum DeviceProgram
{
    ASCENT_PROGRAM,
    CASCADE_PROGRAM,
    DIRECTIONS_PROGRAM,
    HOUGHLINES_PROGRAM,
    MAXIMA_PROGRAM,
    PRUNING_PROGRAM,
    TABLE_PROGRAM
};

/** A kernel of a program. Each launch has one of its own: one that is in flight cannot be launched
again. */
class Launch
{
public:
    enum
    {
        GROUP = 64, //!< most work items of a group
        GROUP_OF_ROWS =
            8 //!< where each has so much to do that few groups would keep few cores busy
    };

    Launch(DeviceProgram program, const char* name, const String& options);

    //! The next arguments of the kernel.
    template<class Argument, class... Arguments>
    Launch& with(const Argument& argument, const Arguments&... others)
    {
        next_ = kernel_.set(next_, argument);
        return with(others...);
    }
    Launch& with() { return *this; }

    /** Queues it, without waiting.
    @param alongRows whether the work items of a group follow one another in the second dimension.
    (A group's shape is always one of these two: some devices build a kernel for each.) */
    void run(size_t width, size_t height, bool alongRows = false);

private:
    const char* name_;
    ocl::Kernel kernel_;
    int next_; //!< argument
};

//! What votes, on the device: arguments of kernels, and what pixels.cl is compiled for.
struct DevicePixels
{
    UMat image, mask, directions;
    String options; //!< of image and mask

    void giveTo(Launch& launch) const;
    void giveDirectionsTo(Launch& launch) const;
    //! For chords that have the votes of their bin.
    String directionOptions() const;
};

//! For kernels that ask for the bin of a chord.
String directionBinOptions();

/** Whether kernels are those for a processor, as the device is one or LINESPACE_OPENCL_KERNELS says
so: a work item takes a run of consecutive chords there, does what they share once, and reads on in
the lines of its cache; on other devices neighbouring work items read neighbouring bytes. */
bool isProcessor();

//! A row of chords (s, e) on the device, an int4 there.
struct BorderRow
{
    int firstChord, count, segments, firstEnd;
};

//! Throws DeviceFailure if the number does not fit 32 bits.
int asInt(double value);

//! Throws DeviceFailure if products of chords.cl's rasters do not fit 32 bits.
void checkRasters(const Cell& frame);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_LAUNCH_HPP
