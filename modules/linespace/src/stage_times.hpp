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
