// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the OpenGL path takes of OpenGL 4.3 and OpenGL ES 3.1: types, numbers and functions, with
// the names and values of their specifications. They are declared here and found at run time, so
// that the module is built without any header or library of OpenGL and loads on a machine without.

#ifndef OPENCV_LINESPACE_GL_FUNCTIONS_HPP
#define OPENCV_LINESPACE_GL_FUNCTIONS_HPP

#include "precomp.hpp"

namespace cv {
namespace linespace {
namespace gl {

#ifdef _WIN32
#define LINESPACE_GL_CALL __stdcall
#else
#define LINESPACE_GL_CALL
#endif

typedef unsigned int GLenum, GLbitfield, GLuint;
typedef int GLint, GLsizei;
typedef unsigned char GLubyte, GLboolean;
typedef char GLchar;
typedef ptrdiff_t GLsizeiptr, GLintptr;
typedef int64 GLint64;
typedef uint64 GLuint64;
typedef struct Sync* GLsync;
typedef void(LINESPACE_GL_CALL* GLDEBUGPROC)(GLenum source, GLenum type, GLuint id, GLenum severity,
                                             GLsizei length, const GLchar* message,
                                             const void* user);

enum
{
    NO_ERROR = 0,
    OUT_OF_MEMORY = 0x0505,
    CONTEXT_LOST = 0x0507,
    TEXTURE_2D = 0x0DE1,
    TEXTURE_WIDTH = 0x1000,
    TEXTURE_HEIGHT = 0x1001,
    TEXTURE_INTERNAL_FORMAT = 0x1003,
    RENDERER = 0x1F01,
    VERSION = 0x1F02,
    NEAREST = 0x2600,
    TEXTURE_MAG_FILTER = 0x2800,
    TEXTURE_MIN_FILTER = 0x2801,
    TEXTURE_BINDING_2D = 0x8069,
    R8 = 0x8229,
    R8UI = 0x8232,
    TEXTURE_BASE_LEVEL = 0x813C,
    MAJOR_VERSION = 0x821B,
    MINOR_VERSION = 0x821C,
    TEXTURE0 = 0x84C0,
    ACTIVE_TEXTURE = 0x84E0,
    QUERY_RESULT = 0x8866,
    STREAM_READ = 0x88E1,
    DYNAMIC_COPY = 0x88EA,
    SAMPLER_BINDING = 0x8919,
    COMPILE_STATUS = 0x8B81,
    LINK_STATUS = 0x8B82,
    CURRENT_PROGRAM = 0x8B8D,
    TIMESTAMP = 0x8E28,
    SHADER_STORAGE_BUFFER = 0x90D2,
    SHADER_STORAGE_BUFFER_BINDING = 0x90D3,
    SHADER_STORAGE_BUFFER_START = 0x90D4,
    SHADER_STORAGE_BUFFER_SIZE = 0x90D5,
    MAX_COMPUTE_SHADER_STORAGE_BLOCKS = 0x90DB,
    MAX_SHADER_STORAGE_BLOCK_SIZE = 0x90DE,
    SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT = 0x90DF,
    SYNC_GPU_COMMANDS_COMPLETE = 0x9117,
    TIMEOUT_EXPIRED = 0x911B,
    WAIT_FAILED = 0x911D,
    COMPUTE_SHADER = 0x91B9,
    MAX_COMPUTE_WORK_GROUP_COUNT = 0x91BE,
    DEBUG_OUTPUT_SYNCHRONOUS = 0x8242,
    DEBUG_OUTPUT = 0x92E0,
    DEBUG_SEVERITY_NOTIFICATION = 0x826B,

    MAP_READ_BIT = 1,
    SYNC_FLUSH_COMMANDS_BIT = 1,
    TEXTURE_FETCH_BARRIER_BIT = 0x0008,
    BUFFER_UPDATE_BARRIER_BIT = 0x0200,
    SHADER_STORAGE_BARRIER_BIT = 0x2000
};

//! What every context has: F(result, name, parameters).
#define LINESPACE_GL_FUNCTIONS(F)                                                                  \
    F(GLenum, GetError, ())                                                                        \
    F(const GLubyte*, GetString, (GLenum))                                                         \
    F(void, GetIntegerv, (GLenum, GLint*))                                                         \
    F(void, GetInteger64v, (GLenum, GLint64*))                                                     \
    F(void, GetIntegeri_v, (GLenum, GLuint, GLint*))                                               \
    F(void, GetInteger64i_v, (GLenum, GLuint, GLint64*))                                           \
    F(void, GenBuffers, (GLsizei, GLuint*))                                                        \
    F(void, DeleteBuffers, (GLsizei, const GLuint*))                                               \
    F(GLboolean, IsBuffer, (GLuint))                                                               \
    F(void, BindBuffer, (GLenum, GLuint))                                                          \
    F(void, BindBufferBase, (GLenum, GLuint, GLuint))                                              \
    F(void, BindBufferRange, (GLenum, GLuint, GLuint, GLintptr, GLsizeiptr))                       \
    F(void, BufferData, (GLenum, GLsizeiptr, const void*, GLenum))                                 \
    F(void, BufferSubData, (GLenum, GLintptr, GLsizeiptr, const void*))                            \
    F(void*, MapBufferRange, (GLenum, GLintptr, GLsizeiptr, GLbitfield))                           \
    F(GLboolean, UnmapBuffer, (GLenum))                                                            \
    F(GLuint, CreateShader, (GLenum))                                                              \
    F(void, ShaderSource, (GLuint, GLsizei, const GLchar* const*, const GLint*))                   \
    F(void, CompileShader, (GLuint))                                                               \
    F(void, GetShaderiv, (GLuint, GLenum, GLint*))                                                 \
    F(void, GetShaderInfoLog, (GLuint, GLsizei, GLsizei*, GLchar*))                                \
    F(void, DeleteShader, (GLuint))                                                                \
    F(GLuint, CreateProgram, ())                                                                   \
    F(void, AttachShader, (GLuint, GLuint))                                                        \
    F(void, LinkProgram, (GLuint))                                                                 \
    F(void, GetProgramiv, (GLuint, GLenum, GLint*))                                                \
    F(void, GetProgramInfoLog, (GLuint, GLsizei, GLsizei*, GLchar*))                               \
    F(void, UseProgram, (GLuint))                                                                  \
    F(void, DeleteProgram, (GLuint))                                                               \
    F(void, Uniform1iv, (GLint, GLsizei, const GLint*))                                            \
    F(void, Uniform4iv, (GLint, GLsizei, const GLint*))                                            \
    F(void, DispatchCompute, (GLuint, GLuint, GLuint))                                             \
    F(void, MemoryBarrier, (GLbitfield))                                                           \
    F(GLsync, FenceSync, (GLenum, GLbitfield))                                                     \
    F(GLenum, ClientWaitSync, (GLsync, GLbitfield, GLuint64))                                      \
    F(void, DeleteSync, (GLsync))                                                                  \
    F(void, ActiveTexture, (GLenum))                                                               \
    F(void, BindTexture, (GLenum, GLuint))                                                         \
    F(GLboolean, IsTexture, (GLuint))                                                              \
    F(void, GetTexParameteriv, (GLenum, GLenum, GLint*))                                           \
    F(void, GetTexLevelParameteriv, (GLenum, GLint, GLenum, GLint*))                               \
    F(void, GenSamplers, (GLsizei, GLuint*))                                                       \
    F(void, DeleteSamplers, (GLsizei, const GLuint*))                                              \
    F(void, BindSampler, (GLuint, GLuint))                                                         \
    F(void, SamplerParameteri, (GLuint, GLenum, GLint))                                            \
    F(void, GenQueries, (GLsizei, GLuint*))                                                        \
    F(void, DeleteQueries, (GLsizei, const GLuint*))

//! What some lack: of OpenGL ES, the first two are in extensions; the last is of OpenGL 4.5 and
//! ES 3.2.
#define LINESPACE_GL_OPTIONAL_FUNCTIONS(F)                                                         \
    F(void, QueryCounter, (GLuint, GLenum))                                                        \
    F(void, GetQueryObjectui64v, (GLuint, GLenum, GLuint64*))                                      \
    F(void, Enable, (GLenum))                                                                      \
    F(void, DebugMessageCallback, (GLDEBUGPROC, const void*))                                      \
    F(GLenum, GetGraphicsResetStatus, ())

//! Finds a function of OpenGL by its name; null if there is none.
typedef void* (*FindFunction)(const char* name);

//! The functions of a context; null is what the machine's OpenGL lacks.
struct Functions
{
#define LINESPACE_GL_MEMBER(Result, name, parameters) Result(LINESPACE_GL_CALL* name) parameters;
    LINESPACE_GL_FUNCTIONS(LINESPACE_GL_MEMBER)
    LINESPACE_GL_OPTIONAL_FUNCTIONS(LINESPACE_GL_MEMBER)
#undef LINESPACE_GL_MEMBER

    //! Throws DeviceFailure if a function that every context has is missing.
    void load(FindFunction find);
};

} // namespace gl
} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GL_FUNCTIONS_HPP
