// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A library in place of libEGL.so.1, which it needs and which does all the work, but that a context
// is lost, as a reset of a graphics card would lose it: the one in which launch
// LINESPACE_LOST_LAUNCH, counted over all, is made. From then on that context tells about it by every
// error (LINESPACE_LOST_BY=error), or by its reset status alone (status).

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>

namespace {

int launches = 0;
void* lost = nullptr; //!< context

template<class Function>
Function real(const char* name)
{
    typedef void* (*GetProcAddress)(const char*);
    static const auto find = (GetProcAddress)dlsym(RTLD_NEXT, "eglGetProcAddress");
    return (Function)find(name);
}

bool isLost(const char* by)
{
    static const auto current = (void* (*)())dlsym(RTLD_NEXT, "eglGetCurrentContext");
    const char* const wanted = std::getenv("LINESPACE_LOST_BY");
    return lost && lost == current() && wanted && std::strcmp(wanted, by) == 0;
}

unsigned getError()
{
    const unsigned contextLost = 0x0507;
    return isLost("error") ? contextLost : real<unsigned (*)()>("glGetError")();
}

unsigned getGraphicsResetStatus()
{
    const unsigned unknownContextReset = 0x8255;
    return isLost("status") ? unknownContextReset
                            : real<unsigned (*)()>("glGetGraphicsResetStatus")();
}

void dispatchCompute(unsigned x, unsigned y, unsigned z)
{
    const char* const launch = std::getenv("LINESPACE_LOST_LAUNCH");
    if (launch && ++launches == std::atoi(launch))
        lost = ((void* (*)())dlsym(RTLD_NEXT, "eglGetCurrentContext"))();
    real<void (*)(unsigned, unsigned, unsigned)>("glDispatchCompute")(x, y, z);
}

} // namespace

extern "C" void* eglGetProcAddress(const char* name)
{
    return std::strcmp(name, "glGetError") == 0                 ? (void*)getError
           : std::strcmp(name, "glGetGraphicsResetStatus") == 0 ? (void*)getGraphicsResetStatus
           : std::strcmp(name, "glDispatchCompute") == 0        ? (void*)dispatchCompute
                                                                : real<void*>(name);
}
