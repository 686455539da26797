// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// How long the stages of one call took.

#ifndef OPENCV_LINESPACE_STAGE_TIMES_HPP
#define OPENCV_LINESPACE_STAGE_TIMES_HPP

#include "precomp.hpp"

namespace cv {
namespace linespace {

//! A stopwatch with a list of laps; reading the clock costs some tens of nanoseconds.
class StageTimes
{
public:
    StageTimes() : last_(0) {}

    //! Forgets all stages; the first one begins now.
    void restart()
    {
        names_.clear();
        milliseconds_.clear();
        last_ = getTickCount();
    }
    //! Ends a stage; the next one begins now.
    void end(const String& name)
    {
        const int64 now = getTickCount();
        names_.push_back(name);
        milliseconds_.push_back((double)(now - last_) * 1e3 / getTickFrequency());
        last_ = now;
    }
    //! The last stages took so long; what that is more or less than was measured, the next one did
    //! not.
    void correctLast(const std::vector<double>& milliseconds)
    {
        CV_DbgAssert(milliseconds.size() <= milliseconds_.size());
        double more = 0;
        double* const last = milliseconds_.data() + milliseconds_.size() - milliseconds.size();
        for (size_t i = 0; i < milliseconds.size(); ++i)
        {
            more += milliseconds[i] - last[i];
            last[i] = milliseconds[i];
        }
        last_ += (int64)(more * getTickFrequency() * 1e-3);
    }
    const std::vector<String>& names() const { return names_; }
    const std::vector<double>& milliseconds() const { return milliseconds_; }

private:
    std::vector<String> names_;
    std::vector<double> milliseconds_;
    int64 last_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_STAGE_TIMES_HPP
