// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "test_gl.hpp"

#include <stdexcept>

#ifdef _WIN32
#define LINESPACE_NO_EGL
#else
#include <dlfcn.h>
#endif

namespace opencv_test {

namespace {

struct TestEgl
{
    void* (*getProcAddress)(const char*);
    void* (*getPlatformDisplay)(unsigned, void*, const int*);
    unsigned (*initialize)(void*, int*, int*);
    unsigned (*bindApi)(unsigned);
    void* (*createContext)(void*, void*, void*, const int*);
    unsigned (*destroyContext)(void*, void*);
    unsigned (*makeCurrent)(void*, void*, void*, void*);
    void* (*getCurrentContext)();
    void* display;

    TestEgl() : getProcAddress(0), display(0)
    {
#ifndef LINESPACE_NO_EGL
        void* const library = dlopen("libEGL.so.1", RTLD_LAZY);
        if (!library)
            return;
        getProcAddress = (void* (*)(const char*))dlsym(library, "eglGetProcAddress");
        initialize = (unsigned (*)(void*, int*, int*))dlsym(library, "eglInitialize");
        bindApi = (unsigned (*)(unsigned))dlsym(library, "eglBindAPI");
        createContext =
            (void* (*)(void*, void*, void*, const int*))dlsym(library, "eglCreateContext");
        destroyContext = (unsigned (*)(void*, void*))dlsym(library, "eglDestroyContext");
        makeCurrent = (unsigned (*)(void*, void*, void*, void*))dlsym(library, "eglMakeCurrent");
        getCurrentContext = (void* (*)())dlsym(library, "eglGetCurrentContext");
        getPlatformDisplay =
            (void* (*)(unsigned, void*, const int*))getProcAddress("eglGetPlatformDisplayEXT");
        const unsigned surfaceless = 0x31DD; // EGL_PLATFORM_SURFACELESS_MESA
        display = getPlatformDisplay ? getPlatformDisplay(surfaceless, 0, 0) : 0;
        if (display && !initialize(display, 0, 0))
            display = 0;
#endif
    }
};

const TestEgl& egl()
{
    static const TestEgl instance;
    return instance;
}

template<class Function>
void load(Function& function, const char* name)
{
    function = (Function)egl().getProcAddress(name);
}

} // namespace

TestContext::TestContext(bool isEmbedded)
{
    if (!egl().display)
        throw std::runtime_error("EGL has no display without a surface");
    const unsigned embedded = 0x30A0, desktop = 0x30A2; // EGL_OPENGL_ES_API, EGL_OPENGL_API
    const int version[] = {0x3098, isEmbedded ? 3 : 4, 0x30FB, isEmbedded ? 1 : 3, 0x3038};
    egl().bindApi(isEmbedded ? embedded : desktop);
    context_ = egl().createContext(egl().display, 0, 0, version);
    egl().bindApi(embedded); // the initial one
    if (!context_)
        throw std::runtime_error("EGL gives no context");
    makeCurrent();
#define LINESPACE_TEST_LOAD(Result, name, parameters) load(gl_.name, "gl" #name);
    LINESPACE_GL_FUNCTIONS(LINESPACE_TEST_LOAD)
#undef LINESPACE_TEST_LOAD
    load(gl_.GenTextures, "glGenTextures");
    load(gl_.DeleteTextures, "glDeleteTextures");
    load(gl_.TexImage2D, "glTexImage2D");
    load(gl_.PixelStorei, "glPixelStorei");
}

TestContext::~TestContext()
{
    if (current() == context_)
        release();
    egl().destroyContext(egl().display, context_);
}

void TestContext::makeCurrent()
{
    if (!egl().makeCurrent(egl().display, 0, 0, context_))
        throw std::runtime_error("eglMakeCurrent failed");
}

void TestContext::release()
{
    egl().makeCurrent(egl().display, 0, 0, 0);
}

void* TestContext::current()
{
    return egl().getCurrentContext();
}

unsigned int TestContext::textureOf(const cv::Mat& image, bool isInteger) const
{
    using namespace cv::linespace::gl;
    const GLenum unpackAlignment = 0x0CF5, red = 0x1903, redInteger = 0x8D94, bytes = 0x1401;
    const cv::Mat continuous = image.clone();
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    gl_.BindTexture(TEXTURE_2D, texture);
    gl_.PixelStorei(unpackAlignment, 1);
    gl_.TexImage2D(TEXTURE_2D, 0, isInteger ? R8UI : R8, image.cols, image.rows, 0,
                   isInteger ? redInteger : red, bytes, continuous.data);
    gl_.PixelStorei(unpackAlignment, 4);
    gl_.BindTexture(TEXTURE_2D, 0);
    return texture;
}

std::string headlessRenderer()
{
    using namespace cv::linespace::gl;
    try
    {
        const TestContext context;
        return std::string((const char*)context.gl().GetString(RENDERER)) + ", OpenGL " +
               (const char*)context.gl().GetString(VERSION);
    }
    catch (const std::runtime_error& error)
    {
        return error.what();
    }
}

} // namespace opencv_test
