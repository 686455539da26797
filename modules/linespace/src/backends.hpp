// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Which back end runs.

#ifndef OPENCV_LINESPACE_BACKENDS_HPP
#define OPENCV_LINESPACE_BACKENDS_HPP

#include "stages.hpp"

namespace cv {
namespace linespace {

/** What runs for one of enum Backend: for BACKEND_AUTO the process-wide default where it can run,
else the device for what lies there, else the CPU path. */
int chosenBackend(int backend, bool isUMat);

/** The executor of a back end.
@param backend one of enum Backend.
@param isUMat whether the edge map is a UMat.
@param kept executors from earlier calls, of which one is returned again if it is of the right kind;
each may be empty. Throws cv::Exception with the reason if a back end that was named cannot run. */
Ptr<Executor> executorFor(int backend, bool isUMat, const std::vector<Ptr<Executor>>& kept);

//! The CPU's executor, in place of a device that failed, with a warning; throws if the device was
//! asked for by name, for the call or for the process.
Ptr<Executor> substituteFor(int backend, const DeviceFailure& failure);

//! The array, where it is a UMat on OpenCV's device; else an empty one.
UMat onDevice(InputArray array);

//! The time in which an executor works.
class WorkingTime
{
public:
    explicit WorkingTime(Executor& executor) : executor_(executor) { executor_.begin(); }
    ~WorkingTime() { executor_.end(); }

private:
    WorkingTime(const WorkingTime&);
    WorkingTime& operator=(const WorkingTime&);
    Executor& executor_;
};

/** Calls work(executor), and once more with another one if a device fails that was not asked for by
name (which `backend` tells). Returns the executor that did it. */
template<class Work>
Ptr<Executor> runOn(int backend, Ptr<Executor> executor, Work work)
{
    try
    {
        const WorkingTime time(*executor);
        work(*executor);
    }
    catch (const DeviceFailure& failure)
    {
        executor = substituteFor(backend, failure);
        work(*executor);
    }
    return executor;
}

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_BACKENDS_HPP
