// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "backends.hpp"

#include "gl_cascade.hpp"
#include "ocl_cascade.hpp"

#include <opencv2/core/ocl.hpp>
#include <opencv2/core/utils/logger.hpp>

#include <atomic>

namespace cv {
namespace linespace {

namespace {

std::atomic<int> defaultBackend(BACKEND_AUTO);

const char* nameOf(int backend)
{
    static const char* const names[] = {"BACKEND_AUTO", "BACKEND_REFERENCE", "BACKEND_CPU",
                                        "BACKEND_OPENCL", "BACKEND_OPENGL"};
    return names[backend];
}

//! What OpenGL there is shows when it is used.
bool isAvailable(int backend)
{
    return backend != BACKEND_OPENCL || isOpenClActive();
}

Ptr<Executor> create(int backend)
{
    return backend == BACKEND_REFERENCE ? createReferenceExecutor()
           : backend == BACKEND_OPENCL  ? createOpenClExecutor()
           : backend == BACKEND_OPENGL  ? createOpenGlExecutor()
                                        : createCpuExecutor();
}

Ptr<Executor> usableOf(const std::vector<Ptr<Executor>>& executors, int backend)
{
    for (const Ptr<Executor>& executor : executors)
        if (executor && executor->backend() == backend && executor->isUsable())
            return executor;
    return Ptr<Executor>();
}

} // namespace

void setDefaultBackend(int backend)
{
    if (backend < BACKEND_AUTO || backend > BACKEND_OPENGL)
        CV_Error_(Error::StsOutOfRange,
                  ("backend = %d: must be one of enum Backend, 0 to 4", backend));
    defaultBackend = backend;
}

int getDefaultBackend()
{
    return defaultBackend;
}

int chosenBackend(int backend, bool isUMat)
{
    if (backend != BACKEND_AUTO)
        return backend;
    backend = defaultBackend;
    if (backend == BACKEND_AUTO && isUMat)
        backend = BACKEND_OPENCL;
    return backend != BACKEND_AUTO && isAvailable(backend) ? backend : (int)BACKEND_CPU;
}

Ptr<Executor> executorFor(int backend, bool isUMat, const std::vector<Ptr<Executor>>& kept)
{
    const bool isNamed = backend != BACKEND_AUTO;
    backend = chosenBackend(backend, isUMat);
    if (!isAvailable(backend))
        CV_Error(Error::OpenCLInitError,
                 "backend = BACKEND_OPENCL: OpenCV uses no OpenCL device here "
                 "(cv::ocl::useOpenCL() is false); must be another one");
    const Ptr<Executor> found = usableOf(kept, backend);
    if (found)
        return found;
    try
    {
        return create(backend);
    }
    catch (const DeviceFailure& failure)
    {
        if (isNamed)
            return substituteFor(backend, failure);
        const Ptr<Executor> other = usableOf(kept, BACKEND_CPU);
        return other ? other : createCpuExecutor();
    }
}

UMat onDevice(InputArray array)
{
    if (!array.isUMat())
        return UMat();
    const UMat result = array.getUMat();
    return result.u && result.u->currAllocator == ocl::getOpenCLAllocator() ? result : UMat();
}

Ptr<Executor> substituteFor(int backend, const DeviceFailure& failure)
{
    if (backend == BACKEND_AUTO)
        backend = defaultBackend;
    if (backend != BACKEND_AUTO)
        CV_Error_(backend == BACKEND_OPENGL ? Error::OpenGlApiCallError : Error::OpenCLApiCallError,
                  ("backend = %s: %s; must be another one, or BACKEND_AUTO", nameOf(backend),
                   failure.reason.c_str()));
    CV_LOG_WARNING(NULL, "linespace: the CPU path runs, not the device: " << failure.reason);
    return createCpuExecutor();
}

} // namespace linespace
} // namespace cv
