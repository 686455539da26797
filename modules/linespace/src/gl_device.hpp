// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A context of OpenGL at work: its limits, programs and buffers, and launches of compute shaders.
// Everything here throws DeviceFailure with the call that failed.
//
// A device works between begin() and end(), in one thread. In the caller's context end() restores
// what was changed: the program, the storage buffers and their indexed bindings, the active texture
// unit, and of unit 0 the texture and the sampler. Errors that the caller left pending are lost.
//
// Environment, for tests: LINESPACE_OPENGL_LIMITS=BYTES,GROUPS,BLOCKS lowers the limits of the
// driver: bytes of a storage block, work groups of a dimension, storage blocks of a shader.

#ifndef OPENCV_LINESPACE_GL_DEVICE_HPP
#define OPENCV_LINESPACE_GL_DEVICE_HPP

#include "gl_context.hpp"
#include "stages.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>

namespace cv {
namespace linespace {

class GlDevice;

//! Memory of a device. It may outlive the work, in any thread: what it had is freed when that goes
//! on.
class GlBuffer : public DeviceMemory
{
public:
    GlBuffer() : name_(0), bytes_(0) {}
    ~GlBuffer() { release(); }
    void release();
    size_t bytes() const CV_OVERRIDE { return bytes_; }

private:
    friend class GlDevice;
    GlBuffer(const GlBuffer&);
    GlBuffer& operator=(const GlBuffer&);

    Ptr<GlDevice> device_;
    gl::GLuint name_;
    size_t bytes_;
};

struct GlLimits
{
    size_t blockBytes; //!< a power of two
    unsigned groups;   //!< of a dimension
    int blocks;        //!< of a shader
    size_t alignment;  //!< of where a block begins in a buffer
};

//! The programs of glsl/, each after chords.glsl, which all use; from GL_EXACT on after pixels.glsl
//! as well. What options tell is compiled before them, see GlLaunch.
enum GlProgram
{
    GL_PLANES,
    GL_FIRST_CELLS,
    GL_MERGE,
    GL_MAXIMA,
    GL_TEXTURE,
    GL_EXACT,
    GL_BITS,
    GL_ASCENT
};

class GlDevice : public std::enable_shared_from_this<GlDevice>
{
public:
    enum
    {
        GROUP = 64,  //!< invocations of a work group
        NUMBERS = 12 //!< most that a launch takes
    };

    /** The device for this thread: the caller's context if one is current, else one without a
    window; one that was given back, or a new one. */
    static Ptr<GlDevice> take();
    //! For the next one that asks; frees the buffers that are not needed any more.
    static void giveBack(const Ptr<GlDevice>& device);

    ~GlDevice();

    //! Whether its context is the one to use in this thread, by its handle.
    bool isForThisThread() const;
    //! Then: whether it is the same context still.
    bool works();
    bool isCallers() const { return context_.isCallers(); }
    const GlLimits& limits() const { return limits_; }
    //! What the driver calls itself; between begin() and end().
    String renderer();

    void begin();
    //! Throws nothing.
    void end();

    //! At least so many bytes; what the buffer held may be lost.
    void allocate(GlBuffer& buffer, size_t bytes);
    void upload(const void* from, size_t bytes, GlBuffer& buffer);
    template<class Element>
    void upload(const std::vector<Element>& from, GlBuffer& buffer)
    {
        upload(from.data(), from.size() * sizeof(Element), buffer);
    }

    //! Notes the time at which the device comes here, if it has a clock.
    void stamp();
    //! After finish(): milliseconds between one stamp and the next, since begin().
    std::vector<double> laps();

    //! Waits for the device, if it was given something to do since the last time.
    void finish();
    //! After finish(): reads what is there.
    void read(const GlBuffer& buffer, size_t bytes, void* to);
    //! The same, read(part, offset, bytes) in parts of at most a mebibyte.
    template<class Read>
    void readParts(const GlBuffer& buffer, size_t bytes, Read readPart)
    {
        const size_t most = 1 << 20;
        for (size_t offset = 0; offset < bytes; offset += most)
        {
            const size_t count = std::min(most, bytes - offset);
            readPart(map(buffer, offset, count), offset, count);
            unmap();
        }
    }

    /** Checks the texture and binds it for GL_TEXTURE. Throws cv::Exception if it is none of the
    formats that detectTexture() takes.
    @return its size. */
    Size bindTexture(unsigned int texture, bool& isInteger);

private:
    friend class GlLaunch;
    struct Saved
    {
        bool isSaved;
        gl::GLint name;
        gl::GLint64 start, size;
        Saved() : isSaved(false), name(0), start(0), size(0) {}
    };

    explicit GlDevice(GlContext&& context);
    friend class GlBuffer;
    void dropErrors();
    void checkReset();
    [[noreturn]] void lose(const char* reason);
    void discard(gl::GLuint buffer);
    void freeDiscarded();
    void markContext();
    bool hasMark();
    void bind(gl::GLuint buffer);
    void bindBlock(unsigned index, const GlBuffer& buffer, size_t offset, size_t bytes);
    void use(gl::GLuint program);
    void restore();
    const void* map(const GlBuffer& buffer, size_t offset, size_t bytes);
    void unmap();
    gl::GLuint program(const char* source, bool readsPixels, const std::string& options);
    gl::GLuint compiled(const char* source, bool readsPixels, const std::string& options);
    String messages();
    void check(const char* call);
    static void LINESPACE_GL_CALL collect(gl::GLenum, gl::GLenum, gl::GLuint, gl::GLenum severity,
                                          gl::GLsizei, const gl::GLchar* message, const void* user);

    //! Calls a function of OpenGL and throws if that is an error.
    template<class Function, class... Arguments>
    auto call(const char* name, Function function, Arguments... arguments) ->
        typename std::enable_if<std::is_void<decltype(function(arguments...))>::value>::type
    {
        function(arguments...);
        check(name);
    }
    //! The same of a function that returns something.
    template<class Function, class... Arguments>
    auto call(const char* name, Function function, Arguments... arguments) ->
        typename std::enable_if<!std::is_void<decltype(function(arguments...))>::value,
                                decltype(function(arguments...))>::type
    {
        const auto result = function(arguments...);
        check(name);
        return result;
    }

    GlContext context_;
    gl::Functions gl_;
    bool isEmbedded_;
    bool isLost_; //!< the caller has destroyed the context, or a reset has
    bool isBusy_; //!< with launches, as far as is known
    GlLimits limits_;
    std::map<std::pair<const char*, std::string>, gl::GLuint> programs_; //!< by source and options
    gl::GLuint mark_, sampler_;
    uint64 markValue_[2];
    std::vector<gl::GLuint> queries_; //!< of stamps, which are the first of them
    size_t stamps_;
    std::unique_ptr<GlBinding> binding_;
    // What was bound in the caller's context, from the first change on.
    Saved savedProgram_, savedBuffer_, savedUnit_, savedTexture_, savedSampler_;
    std::vector<Saved> savedBlocks_;
    std::mutex mutex_; //!< of the next
    std::vector<gl::GLuint> discarded_;
    std::vector<String> messages_; //!< of KHR_debug, in debug builds
};

//! A launch of a shader.
class GlLaunch
{
public:
    /** @param options what its source is compiled after: lines that define macros. Some of them
    stand for a text that goes before it: WINDOWS for windows.glsl, RING_RADIUS for ring.glsl,
    CHILD_BITS for children.glsl. */
    GlLaunch(GlDevice& device, GlProgram program, const std::string& options);
    //! @param source of a shader that is none of glsl/; a program is kept by its address.
    GlLaunch(GlDevice& device, const char* source, const std::string& options);

    //! The next block of the shader; of the whole buffer, or of a part.
    GlLaunch& block(const GlBuffer& buffer) { return block(buffer, 0, buffer.bytes()); }
    GlLaunch& block(const GlBuffer& buffer, size_t offset, size_t bytes);
    //! One that is not the next.
    GlLaunch& blockAt(unsigned index, const GlBuffer& buffer)
    {
        return blockAt(index, buffer, buffer.bytes());
    }
    GlLaunch& blockAt(unsigned index, const GlBuffer& buffer, size_t bytes)
    {
        next_ = index;
        return block(buffer, 0, bytes);
    }
    //! The next blocks, parts of one buffer that are as large as a block can be, but for the last.
    GlLaunch& windows(const GlBuffer& buffer, size_t bytes);

    //! Queues it, for at least so many work groups, after what was queued before.
    void run(const std::vector<int>& numbers, size_t groups);
    //! What else the shader takes, in fours.
    GlLaunch& fours(const std::vector<Vec4i>& numbers);
    /** Queues it for so many items of so many rows of so many layers. The first two numbers tell
    the shader where a launch begins, if it takes several.
    @param isBeside whether it needs nothing of what was queued last. */
    void runRows(std::vector<int> numbers, int items, int rows, int layers, bool isBeside);
    void runItems(const std::vector<int>& numbers, size_t items)
    {
        run(numbers, (items + GlDevice::GROUP - 1) / GlDevice::GROUP);
    }

private:
    void queue(const std::vector<int>& numbers, unsigned columns, unsigned rows, unsigned layers,
               bool isBeside);

    GlDevice& device_;
    unsigned next_; //!< block
};

//! "#define NAME value", a line of options.
std::string define(const char* name, int value = 1);

//! Throws DeviceFailure if the number does not fit the shaders' 32 bits.
int asShaderInt(double value);

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GL_DEVICE_HPP
