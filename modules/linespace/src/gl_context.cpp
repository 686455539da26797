// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "gl_context.hpp"

#ifdef LINESPACE_OPENGL

#include "stages.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <utility>

namespace cv {
namespace linespace {

namespace {

//! Of EGL, with the names and values of its specification.
typedef int EGLint;
typedef unsigned int EGLenum, EGLBoolean;
typedef void *EGLDisplay, *EGLContext, *EGLSurface, *EGLConfig, *EGLDevice;
enum
{
    EGL_PBUFFER_BIT = 0x0001,
    EGL_OPENGL_ES3_BIT = 0x0040,
    EGL_OPENGL_BIT = 0x0008,
    EGL_SURFACE_TYPE = 0x3033,
    EGL_NONE = 0x3038,
    EGL_RENDERABLE_TYPE = 0x3040,
    EGL_EXTENSIONS = 0x3055,
    EGL_HEIGHT = 0x3056,
    EGL_WIDTH = 0x3057,
    EGL_DRAW = 0x3059,
    EGL_READ = 0x305A,
    EGL_CONTEXT_MAJOR_VERSION = 0x3098,
    EGL_OPENGL_ES_API = 0x30A0,
    EGL_OPENGL_API = 0x30A2,
    EGL_CONTEXT_MINOR_VERSION = 0x30FB,
    EGL_CONTEXT_OPENGL_PROFILE_MASK = 0x30FD,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT = 1,
    EGL_PLATFORM_DEVICE = 0x313F,
    EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT = 0x3138,
    EGL_CONTEXT_OPENGL_DEBUG = 0x31B0,
    EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY = 0x31BD,
    EGL_LOSE_CONTEXT_ON_RESET = 0x31BF,
    EGL_PLATFORM_SURFACELESS = 0x31DD
};

#define LINESPACE_EGL_FUNCTIONS(F)                                                                 \
    F(EGLint, eglGetError, ())                                                                     \
    F(void*, eglGetProcAddress, (const char*))                                                     \
    F(EGLDisplay, eglGetDisplay, (void*))                                                          \
    F(EGLBoolean, eglInitialize, (EGLDisplay, EGLint*, EGLint*))                                   \
    F(const char*, eglQueryString, (EGLDisplay, EGLint))                                           \
    F(EGLBoolean, eglChooseConfig, (EGLDisplay, const EGLint*, EGLConfig*, EGLint, EGLint*))       \
    F(EGLContext, eglCreateContext, (EGLDisplay, EGLConfig, EGLContext, const EGLint*))            \
    F(EGLBoolean, eglDestroyContext, (EGLDisplay, EGLContext))                                     \
    F(EGLSurface, eglCreatePbufferSurface, (EGLDisplay, EGLConfig, const EGLint*))                 \
    F(EGLBoolean, eglDestroySurface, (EGLDisplay, EGLSurface))                                     \
    F(EGLBoolean, eglMakeCurrent, (EGLDisplay, EGLSurface, EGLSurface, EGLContext))                \
    F(EGLContext, eglGetCurrentContext, ())                                                        \
    F(EGLDisplay, eglGetCurrentDisplay, ())                                                        \
    F(EGLSurface, eglGetCurrentSurface, (EGLint))                                                  \
    F(EGLBoolean, eglBindAPI, (EGLenum))                                                           \
    F(EGLenum, eglQueryAPI, ())

struct Egl
{
#define LINESPACE_EGL_MEMBER(Result, name, parameters) Result(*name) parameters;
    LINESPACE_EGL_FUNCTIONS(LINESPACE_EGL_MEMBER)
#undef LINESPACE_EGL_MEMBER
    String failure; //!< why there is none; empty: there is

    Egl()
    {
        const char* const wanted = std::getenv("LINESPACE_EGL_LIBRARY");
        const char* const name = wanted ? wanted : "libEGL.so.1";
        // Never closed: its drivers keep threads, and the process ends in an order of its own.
        void* const library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
        if (!library)
        {
            failure = format("%s cannot be loaded", name);
            return;
        }
#define LINESPACE_EGL_LOAD(Result, function, parameters)                                           \
    function = (Result(*) parameters)dlsym(library, #function);                                    \
    if (!function)                                                                                 \
        failure = format("%s has no %s", name, #function);
        LINESPACE_EGL_FUNCTIONS(LINESPACE_EGL_LOAD)
#undef LINESPACE_EGL_LOAD
    }

    //! Throws DeviceFailure with the name of what failed, if it did.
    void check(bool succeeded, const char* what) const
    {
        if (!succeeded)
            throw DeviceFailure(format("%s failed with EGL error 0x%04x", what, eglGetError()));
    }
};

const Egl& egl()
{
    static const Egl instance;
    return instance;
}

void* findByEgl(const char* name)
{
    return egl().eglGetProcAddress(name);
}

//! Of an application that draws through GLX. Nothing is loaded that it has not loaded itself.
struct Glx
{
    void* (*glXGetCurrentContext)();
    void* (*glXGetProcAddressARB)(const gl::GLubyte*);

    Glx() : glXGetCurrentContext(0), glXGetProcAddressARB(0)
    {
        static const char* const names[] = {"libGLX.so.0", "libGL.so.1"};
        for (int i = 0; i < 2 && !glXGetProcAddressARB; ++i)
            if (void* const library = dlopen(names[i], RTLD_LAZY | RTLD_NOLOAD))
            {
                glXGetCurrentContext = (void* (*)())dlsym(library, "glXGetCurrentContext");
                glXGetProcAddressARB =
                    (void* (*)(const gl::GLubyte*))dlsym(library, "glXGetProcAddressARB");
            }
    }
    void* current() const
    {
        return glXGetCurrentContext && glXGetProcAddressARB ? glXGetCurrentContext() : 0;
    }
};

void* findByGlx(const char* name)
{
    return Glx().glXGetProcAddressARB((const gl::GLubyte*)name);
}

//! Whether a list of words with blanks between them has one.
bool hasWord(const char* list, const char* word)
{
    const size_t length = std::strlen(word);
    for (const char* at = list; at && (at = std::strstr(at, word)) != 0; at += length)
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0))
            return true;
    return false;
}

//! Displays to try, each in its turn: visit(display) tells whether it will do.
template<class Visit>
bool forEachDisplay(Visit visit)
{
    typedef EGLDisplay (*GetPlatformDisplay)(EGLenum, void*, const EGLint*);
    typedef EGLBoolean (*QueryDevices)(EGLint, EGLDevice*, EGLint*);
    const char* const extensions = egl().eglQueryString(0, EGL_EXTENSIONS);
    if (!extensions)
        egl().eglGetError(); // an EGL without them
    const GetPlatformDisplay getDisplay = (GetPlatformDisplay)findByEgl("eglGetPlatformDisplayEXT");
    const QueryDevices queryDevices = (QueryDevices)findByEgl("eglQueryDevicesEXT");
    if (getDisplay && queryDevices && hasWord(extensions, "EGL_EXT_platform_device"))
    {
        EGLDevice devices[16];
        EGLint count = 0;
        if (!queryDevices(16, devices, &count))
            count = 0;
        for (EGLint i = 0; i < count; ++i)
            if (visit(getDisplay(EGL_PLATFORM_DEVICE, devices[i], 0)))
                return true;
    }
    return (getDisplay && hasWord(extensions, "EGL_MESA_platform_surfaceless") &&
            visit(getDisplay(EGL_PLATFORM_SURFACELESS, 0, 0))) ||
           visit(egl().eglGetDisplay(0));
}

//! A context and what it draws to, which nobody looks at.
bool createOn(EGLDisplay display, bool isEmbedded, EGLContext& context, EGLSurface& surface)
{
    if (!display || !egl().eglBindAPI(isEmbedded ? EGL_OPENGL_ES_API : EGL_OPENGL_API))
        return false;
    const char* const extensions = egl().eglQueryString(display, EGL_EXTENSIONS);
    const bool needsSurface = !hasWord(extensions, "EGL_KHR_surfaceless_context");
    EGLConfig config = 0;
    if (needsSurface || !hasWord(extensions, "EGL_KHR_no_config_context"))
    {
        const EGLint wanted[] = {EGL_SURFACE_TYPE, needsSurface ? EGL_PBUFFER_BIT : 0,
                                 EGL_RENDERABLE_TYPE,
                                 isEmbedded ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
        EGLint count = 0;
        if (!egl().eglChooseConfig(display, wanted, &config, 1, &count) || count == 0)
            return false;
    }
    std::vector<EGLint> attributes;
    const auto set = [&](EGLint name, EGLint value)
    {
        attributes.push_back(name);
        attributes.push_back(value);
    };
    set(EGL_CONTEXT_MAJOR_VERSION, isEmbedded ? 3 : 4);
    set(EGL_CONTEXT_MINOR_VERSION, isEmbedded ? 1 : 3);
    if (!isEmbedded)
        set(EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT);
#ifdef _DEBUG
    set(EGL_CONTEXT_OPENGL_DEBUG, 1);
#endif
    // Else nobody would be told that results are lost.
    if (hasWord(extensions, "EGL_EXT_create_context_robustness"))
        set(isEmbedded ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT
                       : EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
            EGL_LOSE_CONTEXT_ON_RESET);
    attributes.push_back(EGL_NONE);
    context = egl().eglCreateContext(display, config, 0, attributes.data());
    if (!context)
        return false;
    surface = 0;
    if (needsSurface)
    {
        const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        surface = egl().eglCreatePbufferSurface(display, config, size);
        if (!surface)
        {
            egl().eglDestroyContext(display, context);
            return false;
        }
    }
    return true;
}

bool isEmbeddedWanted()
{
    const char* const api = std::getenv("LINESPACE_OPENGL_API");
    return api && std::strcmp(api, "es") == 0;
}

} // namespace

GlContext::GlContext() : handle_(0), display_(0), surface_(0), find_(0), isCallers_(false)
{
}

GlContext::GlContext(GlContext&& other)
    : handle_(other.handle_), display_(other.display_), surface_(other.surface_),
      find_(other.find_), isCallers_(other.isCallers_)
{
    other.handle_ = 0;
}

GlContext& GlContext::operator=(GlContext&& other)
{
    std::swap(handle_, other.handle_);
    std::swap(display_, other.display_);
    std::swap(surface_, other.surface_);
    std::swap(find_, other.find_);
    std::swap(isCallers_, other.isCallers_);
    return *this;
}

GlContext::~GlContext()
{
    if (!handle_ || isCallers_)
        return;
    egl().eglDestroyContext(display_, handle_);
    if (surface_)
        egl().eglDestroySurface(display_, surface_);
}

GlContext GlContext::current()
{
    GlContext result;
    if (egl().failure.empty())
    {
        result.handle_ = egl().eglGetCurrentContext();
        result.find_ = findByEgl;
    }
    if (!result.handle_)
    {
        result.handle_ = Glx().current();
        result.find_ = findByGlx;
    }
    result.isCallers_ = true;
    return result;
}

GlContext GlContext::headless()
{
    if (!egl().failure.empty())
        throw DeviceFailure(egl().failure);
    GlContext result;
    const EGLenum api = egl().eglQueryAPI();
    // Displays are shared by the whole process, so none is ever terminated here.
    const bool isFound = forEachDisplay(
        [&](EGLDisplay display)
        {
            if (!display || !egl().eglInitialize(display, 0, 0) ||
                (!(!isEmbeddedWanted() &&
                   createOn(display, false, result.handle_, result.surface_)) &&
                 !createOn(display, true, result.handle_, result.surface_)))
                return false;
            result.display_ = display;
            return true;
        });
    egl().eglGetError(); // of what was tried in vain
    egl().eglBindAPI(api);
    if (!isFound)
        throw DeviceFailure("no display of EGL has OpenGL 4.3 or OpenGL ES 3.1");
    result.find_ = findByEgl;
    return result;
}

bool GlContext::isCurrent() const
{
    return handle_ && GlContext::current().handle_ == handle_;
}

GlBinding::GlBinding(const GlContext& context) : display_(0)
{
    if (context.isCallers())
    {
        if (!context.isCurrent())
            throw DeviceFailure("the context is not current in this thread any more");
        return;
    }
    previousApi_ = egl().eglQueryAPI();
    previousContext_ = egl().eglGetCurrentContext();
    previousDisplay_ = egl().eglGetCurrentDisplay();
    previousDraw_ = egl().eglGetCurrentSurface(EGL_DRAW);
    previousRead_ = egl().eglGetCurrentSurface(EGL_READ);
    egl().check(egl().eglMakeCurrent(context.display_, context.surface_, context.surface_,
                                     context.handle_) != 0,
                "eglMakeCurrent");
    display_ = context.display_;
}

GlBinding::~GlBinding()
{
    if (!display_)
        return;
    if (!egl().eglMakeCurrent(previousContext_ ? previousDisplay_ : display_, previousDraw_,
                              previousRead_, previousContext_))
        egl().eglMakeCurrent(display_, 0, 0, 0); // it was lost meanwhile
    egl().eglBindAPI(previousApi_);
}

} // namespace linespace
} // namespace cv

#endif // LINESPACE_OPENGL
