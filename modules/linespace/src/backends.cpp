// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "backends.hpp"

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

bool isAvailable(int backend)
{
    return backend == BACKEND_REFERENCE || backend == BACKEND_CPU;
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

Ptr<Executor> executorFor(int backend, const Ptr<Executor>& kept)
{
    if (backend == BACKEND_AUTO)
    {
        backend = defaultBackend;
        if (!isAvailable(backend))
            backend = BACKEND_CPU;
    }
    if (!isAvailable(backend))
        CV_Error_(Error::StsNotImplemented, ("backend = %s is not part of this build: must be "
                                             "BACKEND_AUTO, BACKEND_REFERENCE or BACKEND_CPU",
                                             nameOf(backend)));
    if (kept && kept->backend() == backend)
        return kept;
    return backend == BACKEND_REFERENCE ? createReferenceExecutor() : createCpuExecutor();
}

} // namespace linespace
} // namespace cv
