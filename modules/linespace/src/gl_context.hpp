// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Contexts of OpenGL: the caller's own, or one without a window through EGL, which is loaded at run
// time. What is done in a context is a matter of gl_device.hpp.
//
// A context belongs to one thread at a time, the one in which it is current. The caller's stays
// where it is and is used there alone. One of our own is current only as long as a GlBinding
// lives, in the thread that made that, so it can serve one thread after another.
//
// Environment: LINESPACE_EGL_LIBRARY names the library in place of libEGL.so.1, and
// LINESPACE_OPENGL_API=es asks for OpenGL ES 3.1 where OpenGL 4.3 would be taken.

#ifndef OPENCV_LINESPACE_GL_CONTEXT_HPP
#define OPENCV_LINESPACE_GL_CONTEXT_HPP

#include "gl_functions.hpp"

namespace cv {
namespace linespace {

//! Owns a context of its own, and refers to one of the caller's. Movable, not copyable.
class GlContext
{
public:
    GlContext();
    GlContext(GlContext&& other);
    GlContext& operator=(GlContext&& other);
    ~GlContext();

    //! The one that is current in this thread; none if there is none.
    static GlContext current();
    /** A new one without a window: of the first display that has any, of the EGL devices, then
    without a surface, then the default display; OpenGL 4.3, else OpenGL ES 3.1. Throws
    DeviceFailure if there is none. */
    static GlContext headless();

    bool isNone() const { return !handle_; }
    bool isCallers() const { return isCallers_; }
    bool isCurrent() const;
    //! Whether it is the one that `other` refers to (or was: handles may come again).
    bool isSame(const GlContext& other) const { return handle_ == other.handle_; }
    gl::FindFunction functions() const { return find_; }

private:
    friend class GlBinding;
    GlContext(const GlContext&);
    GlContext& operator=(const GlContext&);

    void* handle_;
    void *display_, *surface_; //!< of EGL, of a context of its own
    gl::FindFunction find_;
    bool isCallers_;
};

/** Makes a context current in the calling thread for as long as it lives, then what was current
before, with its surfaces and its API. The caller's context is current already, or DeviceFailure
is thrown. */
class GlBinding
{
public:
    explicit GlBinding(const GlContext& context);
    ~GlBinding();

private:
    GlBinding(const GlBinding&);
    GlBinding& operator=(const GlBinding&);

    void* display_; //!< of ours; null: nothing is to be restored
    void *previousDisplay_, *previousContext_, *previousDraw_, *previousRead_;
    unsigned int previousApi_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GL_CONTEXT_HPP
