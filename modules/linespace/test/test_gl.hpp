// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A context of OpenGL of the tests' own, as an application has one: EGL without a window, loaded at
// run time. Programs without OpenCV's test module use it as well.

#ifndef OPENCV_LINESPACE_TEST_GL_HPP
#define OPENCV_LINESPACE_TEST_GL_HPP

#include "../src/gl_functions.hpp"

namespace opencv_test {

//! The functions of OpenGL that tests call beyond those of the library.
struct TestFunctions : cv::linespace::gl::Functions
{
    typedef cv::linespace::gl::GLenum GLenum;
    typedef cv::linespace::gl::GLuint GLuint;
    typedef cv::linespace::gl::GLint GLint;
    typedef cv::linespace::gl::GLsizei GLsizei;
    void (*GenTextures)(GLsizei, GLuint*);
    void (*DeleteTextures)(GLsizei, const GLuint*);
    void (*TexImage2D)(GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*);
    void (*PixelStorei)(GLenum, GLint);
};

//! Throws std::runtime_error where there is none.
class TestContext
{
public:
    explicit TestContext(bool isEmbedded = false);
    ~TestContext();

    void makeCurrent();
    //! No context is current in this thread then.
    static void release();
    static void* current();
    const TestFunctions& gl() const { return gl_; }
    //! A texture of GL_R8, or of GL_R8UI if isInteger.
    unsigned int textureOf(const cv::Mat& image, bool isInteger) const;

private:
    TestContext(const TestContext&);
    TestContext& operator=(const TestContext&);
    void* context_;
    TestFunctions gl_;
};

//! GL_RENDERER and GL_VERSION of a context without a window; why not, if there is none.
std::string headlessRenderer();

} // namespace opencv_test

#endif // OPENCV_LINESPACE_TEST_GL_HPP
