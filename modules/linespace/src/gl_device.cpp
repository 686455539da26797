// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "gl_device.hpp"

#ifdef LINESPACE_OPENGL

#include "gl_shaders_linespace.hpp"

#include <atomic>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace cv {
namespace linespace {

void gl::Functions::load(FindFunction find)
{
#define LINESPACE_GL_FIND(Result, name, parameters)                                                \
    name = (Result(LINESPACE_GL_CALL*) parameters)find("gl" #name);
#define LINESPACE_GL_LOAD(Result, name, parameters)                                                \
    LINESPACE_GL_FIND(Result, name, parameters)                                                    \
    if (!name)                                                                                     \
        throw DeviceFailure("there is no gl" #name);
    LINESPACE_GL_FUNCTIONS(LINESPACE_GL_LOAD)
    LINESPACE_GL_OPTIONAL_FUNCTIONS(LINESPACE_GL_FIND)
#undef LINESPACE_GL_LOAD
#undef LINESPACE_GL_FIND
}

namespace {

//! Devices that nobody uses now. Never destroyed: at the end of the process drivers go first.
class IdleDevices
{
public:
    static IdleDevices& instance()
    {
        static IdleDevices* const devices = new IdleDevices;
        return *devices;
    }
    Ptr<GlDevice> take()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (size_t i = devices_.size(); i-- > 0;)
            if (devices_[i]->isForThisThread())
            {
                const Ptr<GlDevice> result = devices_[i];
                devices_.erase(devices_.begin() + i);
                return result;
            }
        return Ptr<GlDevice>();
    }
    //! Of headless ones one is kept, as each has a context; of the caller's contexts the last few.
    void add(const Ptr<GlDevice>& device)
    {
        Ptr<GlDevice> surplus; // destroyed after the lock
        const std::lock_guard<std::mutex> lock(mutex_);
        const size_t most = device->isCallers() ? MOST_CALLERS : 1;
        size_t alike = 0;
        for (size_t i = devices_.size(); i-- > 0;)
            if (devices_[i]->isCallers() == device->isCallers() && ++alike == most)
            {
                surplus = devices_[i];
                devices_.erase(devices_.begin() + i);
                break;
            }
        devices_.push_back(device);
    }

private:
    enum
    {
        MOST_CALLERS = 4
    };
    std::mutex mutex_;
    std::vector<Ptr<GlDevice>> devices_;
};

const char* sourceOf(GlProgram program)
{
    switch (program)
    {
    case GL_PLANES: return planes_glsl;
    case GL_FIRST_CELLS: return first_cells_glsl;
    case GL_MERGE: return merge_glsl;
    case GL_MAXIMA: return maxima_glsl;
    case GL_TEXTURE: return texture_glsl;
    case GL_EXACT: return exact_glsl;
    case GL_BITS: return bits_glsl;
    default: return ascent_glsl;
    }
}

size_t floorPowerOfTwo(uint64 value)
{
    size_t power = 1;
    while (power <= value / 2 && power <= SIZE_MAX / 4)
        power *= 2;
    return power;
}

} // namespace

void GlBuffer::release()
{
    if (device_)
        device_->discard(name_);
    device_.reset();
    name_ = 0;
    bytes_ = 0;
}

GlDevice::GlDevice(GlContext&& context)
    : context_(std::move(context)), isEmbedded_(false), isLost_(false), isBusy_(false), mark_(0),
      sampler_(0), stamps_(0)
{
    binding_.reset(new GlBinding(context_));
    gl_.load(context_.functions());
    gl_.GetGraphicsResetStatus = 0; // until it is known that the context has it
    dropErrors();                   // whose they are is not known
    const char* const version = (const char*)call("glGetString", gl_.GetString, gl::VERSION);
    isEmbedded_ = version && std::strncmp(version, "OpenGL ES", 9) == 0;
    gl::GLint major = 0, minor = 0, blocks = 0, alignment = 0, groups = 0;
    call("glGetIntegerv", gl_.GetIntegerv, gl::MAJOR_VERSION, &major);
    call("glGetIntegerv", gl_.GetIntegerv, gl::MINOR_VERSION, &minor);
    if (10 * major + minor < (isEmbedded_ ? 31 : 43))
        throw DeviceFailure(format("the current context is of %s: must be OpenGL 4.3 or OpenGL ES "
                                   "3.1, or later",
                                   version ? version : "no version"));
    if (10 * major + minor >= (isEmbedded_ ? 32 : 45))
        gl_.load(context_.functions());
    checkReset();
    gl::GLint64 blockBytes = 0;
    call("glGetInteger64v", gl_.GetInteger64v, gl::MAX_SHADER_STORAGE_BLOCK_SIZE, &blockBytes);
    call("glGetIntegerv", gl_.GetIntegerv, gl::MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    call("glGetIntegerv", gl_.GetIntegerv, gl::SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &alignment);
    call("glGetIntegeri_v", gl_.GetIntegeri_v, gl::MAX_COMPUTE_WORK_GROUP_COUNT, 0u, &groups);
    unsigned long long lower[3] = {(unsigned long long)blockBytes, (unsigned long long)groups,
                                   (unsigned long long)blocks};
    if (const char* const limits = std::getenv("LINESPACE_OPENGL_LIMITS"))
        std::sscanf(limits, "%llu,%llu,%llu", &lower[0], &lower[1], &lower[2]);
    limits_.blockBytes = floorPowerOfTwo(std::min<uint64>(blockBytes, lower[0]));
    limits_.groups = (unsigned)std::min<uint64>(groups, lower[1]);
    limits_.blocks = (int)std::min<uint64>(std::min<uint64>(blocks, lower[2]), 16);
    limits_.alignment = alignment;
#ifdef _DEBUG
    if (!isCallers() && gl_.DebugMessageCallback && gl_.Enable)
    {
        call("glDebugMessageCallback", gl_.DebugMessageCallback, &GlDevice::collect,
             (const void*)this);
        call("glEnable", gl_.Enable, (gl::GLenum)gl::DEBUG_OUTPUT);
        call("glEnable", gl_.Enable, (gl::GLenum)gl::DEBUG_OUTPUT_SYNCHRONOUS);
    }
#endif
    if (isCallers())
        markContext();
    end();
}

GlDevice::~GlDevice()
{
    // A context of its own goes with all that it has; in the caller's, only what is current can be
    // deleted.
    if (!isCallers() || isLost_ || !context_.isCurrent())
        return;
    try
    {
        begin();
        for (const auto& program : programs_)
            gl_.DeleteProgram(program.second);
        gl_.DeleteBuffers(1, &mark_);
        if (sampler_)
            gl_.DeleteSamplers(1, &sampler_);
        if (!queries_.empty())
            gl_.DeleteQueries((gl::GLsizei)queries_.size(), queries_.data());
        end();
    }
    catch (const DeviceFailure&)
    {
    }
}

Ptr<GlDevice> GlDevice::take()
{
    while (const Ptr<GlDevice> idle = IdleDevices::instance().take())
        if (idle->works())
            return idle;
    GlContext context = GlContext::current();
    if (context.isNone())
        context = GlContext::headless();
    return Ptr<GlDevice>(new GlDevice(std::move(context)));
}

void GlDevice::giveBack(const Ptr<GlDevice>& device)
{
    if (device->isLost_)
        return;
    if ((!device->isCallers() || device->context_.isCurrent()) && !device->works())
        return;
    IdleDevices::instance().add(device);
}

bool GlDevice::isForThisThread() const
{
    const GlContext current = GlContext::current();
    return !isLost_ && (current.isNone() ? !isCallers() : isCallers() && context_.isSame(current));
}

bool GlDevice::works()
{
    try
    {
        begin(); // which also frees what is not needed any more
        end();
        return true;
    }
    catch (const DeviceFailure&)
    {
        return false; // the context was destroyed, and its handle may have come again
    }
}

String GlDevice::renderer()
{
    const char* const name = (const char*)call("glGetString", gl_.GetString, gl::RENDERER);
    return name ? name : "";
}

void GlDevice::begin()
{
    if (isLost_)
        throw DeviceFailure("the context is lost");
    binding_.reset(new GlBinding(context_));
    try
    {
        dropErrors();
        checkReset();
        if (isCallers() && !hasMark())
            lose("the context was destroyed");
        freeDiscarded();
        stamps_ = 0;
    }
    catch (...)
    {
        end();
        throw;
    }
}

void GlDevice::end()
{
    if (isCallers() && !isLost_)
        restore();
    binding_.reset();
}

//! Contexts are told apart by their handles, which come again: a buffer of known contents tells.
void GlDevice::markContext()
{
    static std::atomic<int> count(0);
    markValue_[0] = (uint64)getTickCount();
    markValue_[1] = ((uint64)(uintptr_t)&count << 16) + ++count;
    call("glGenBuffers", gl_.GenBuffers, 1, &mark_);
    bind(mark_);
    call("glBufferData", gl_.BufferData, gl::SHADER_STORAGE_BUFFER,
         (gl::GLsizeiptr)sizeof(markValue_), (const void*)markValue_, gl::STREAM_READ);
}

bool GlDevice::hasMark()
{
    if (!gl_.IsBuffer(mark_))
        return false;
    bind(mark_);
    const void* const value =
        gl_.MapBufferRange(gl::SHADER_STORAGE_BUFFER, 0, sizeof(markValue_), gl::MAP_READ_BIT);
    const bool isSame = value && std::memcmp(value, markValue_, sizeof(markValue_)) == 0;
    if (value)
        gl_.UnmapBuffer(gl::SHADER_STORAGE_BUFFER);
    dropErrors(); // of a buffer of somebody else
    if (!isSame)
        restore();
    return isSame;
}

//! Those of others. A context that is lost may give one for ever.
void GlDevice::dropErrors()
{
    const int most = 1000;
    for (int i = 0; i < most; ++i)
    {
        const gl::GLenum error = gl_.GetError();
        if (error == gl::NO_ERROR)
            return;
        if (error == gl::CONTEXT_LOST)
            break;
    }
    lose("the context is lost");
}

//! A reset may be told in no other way.
void GlDevice::checkReset()
{
    if (gl_.GetGraphicsResetStatus && gl_.GetGraphicsResetStatus() != gl::NO_ERROR)
        lose("the context is lost by a reset");
}

void GlDevice::lose(const char* reason)
{
    isLost_ = true;
    throw DeviceFailure(reason);
}

void GlDevice::discard(gl::GLuint buffer)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    discarded_.push_back(buffer);
}

void GlDevice::freeDiscarded()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!discarded_.empty())
        call("glDeleteBuffers", gl_.DeleteBuffers, (gl::GLsizei)discarded_.size(),
             (const gl::GLuint*)discarded_.data());
    discarded_.clear();
}

void GlDevice::check(const char* name)
{
    const gl::GLenum error = gl_.GetError();
    isLost_ = isLost_ || error == gl::CONTEXT_LOST;
    if (error == gl::NO_ERROR)
        return;
    if (isLost_)
        lose("the context is lost by a reset");
    throw DeviceFailure(format("%s failed with OpenGL error 0x%04x%s%s", name, error,
                               error == gl::OUT_OF_MEMORY ? ", out of memory" : "",
                               messages().c_str()));
}

void LINESPACE_GL_CALL GlDevice::collect(gl::GLenum, gl::GLenum, gl::GLuint, gl::GLenum severity,
                                         gl::GLsizei, const gl::GLchar* message, const void* user)
{
    GlDevice& device = *(GlDevice*)user;
    if (severity != gl::DEBUG_SEVERITY_NOTIFICATION && device.messages_.size() < 100)
        device.messages_.push_back(message);
}

String GlDevice::messages()
{
    String all;
    for (size_t i = 0; i < messages_.size(); ++i)
        all += "; " + messages_[i];
    messages_.clear();
    return all;
}

void GlDevice::bind(gl::GLuint buffer)
{
    if (isCallers() && !savedBuffer_.isSaved)
    {
        call("glGetIntegerv", gl_.GetIntegerv, gl::SHADER_STORAGE_BUFFER_BINDING,
             &savedBuffer_.name);
        savedBuffer_.isSaved = true;
    }
    call("glBindBuffer", gl_.BindBuffer, gl::SHADER_STORAGE_BUFFER, buffer);
}

void GlDevice::bindBlock(unsigned index, const GlBuffer& buffer, size_t offset, size_t bytes)
{
    bind(buffer.name_); // which the next call changes as well
    if (isCallers() && (index >= savedBlocks_.size() || !savedBlocks_[index].isSaved))
    {
        savedBlocks_.resize(std::max<size_t>(savedBlocks_.size(), index + 1));
        Saved& saved = savedBlocks_[index];
        call("glGetIntegeri_v", gl_.GetIntegeri_v, gl::SHADER_STORAGE_BUFFER_BINDING, index,
             &saved.name);
        call("glGetInteger64i_v", gl_.GetInteger64i_v, gl::SHADER_STORAGE_BUFFER_START, index,
             &saved.start);
        call("glGetInteger64i_v", gl_.GetInteger64i_v, gl::SHADER_STORAGE_BUFFER_SIZE, index,
             &saved.size);
        saved.isSaved = true;
    }
    call("glBindBufferRange", gl_.BindBufferRange, gl::SHADER_STORAGE_BUFFER, index, buffer.name_,
         (gl::GLintptr)offset, (gl::GLsizeiptr)bytes);
}

void GlDevice::use(gl::GLuint program)
{
    if (isCallers() && !savedProgram_.isSaved)
    {
        call("glGetIntegerv", gl_.GetIntegerv, gl::CURRENT_PROGRAM, &savedProgram_.name);
        savedProgram_.isSaved = true;
    }
    call("glUseProgram", gl_.UseProgram, program);
}

void GlDevice::restore()
{
    for (size_t i = 0; i < savedBlocks_.size(); ++i)
    {
        const Saved& saved = savedBlocks_[i];
        if (!saved.isSaved)
            continue;
        if (saved.name == 0 || saved.size == 0) // the whole of it
            gl_.BindBufferBase(gl::SHADER_STORAGE_BUFFER, (gl::GLuint)i, saved.name);
        else
            gl_.BindBufferRange(gl::SHADER_STORAGE_BUFFER, (gl::GLuint)i, saved.name,
                                (gl::GLintptr)saved.start, (gl::GLsizeiptr)saved.size);
    }
    if (savedBuffer_.isSaved)
        gl_.BindBuffer(gl::SHADER_STORAGE_BUFFER, savedBuffer_.name);
    if (savedProgram_.isSaved)
        gl_.UseProgram(savedProgram_.name);
    if (savedTexture_.isSaved)
        gl_.BindTexture(gl::TEXTURE_2D, savedTexture_.name);
    if (savedSampler_.isSaved)
        gl_.BindSampler(0, savedSampler_.name);
    if (savedUnit_.isSaved)
        gl_.ActiveTexture(savedUnit_.name);
    savedBlocks_.clear();
    savedBuffer_ = savedProgram_ = savedTexture_ = savedSampler_ = savedUnit_ = Saved();
}

Size GlDevice::bindTexture(unsigned int texture, bool& isInteger)
{
    if (!call("glIsTexture", gl_.IsTexture, texture))
        CV_Error_(Error::StsBadArg,
                  ("texture = %u: must be the name of a texture of the current context", texture));
    call("glGetIntegerv", gl_.GetIntegerv, gl::ACTIVE_TEXTURE, &savedUnit_.name);
    savedUnit_.isSaved = true;
    call("glActiveTexture", gl_.ActiveTexture, gl::TEXTURE0);
    call("glGetIntegerv", gl_.GetIntegerv, gl::TEXTURE_BINDING_2D, &savedTexture_.name);
    savedTexture_.isSaved = true;
    call("glGetIntegerv", gl_.GetIntegerv, gl::SAMPLER_BINDING, &savedSampler_.name);
    savedSampler_.isSaved = true;
    gl_.BindTexture(gl::TEXTURE_2D, texture);
    if (gl_.GetError() != gl::NO_ERROR)
        CV_Error_(Error::StsBadArg, ("texture = %u: must be of GL_TEXTURE_2D", texture));
    if (!sampler_)
    {
        // An integer texture is complete with this filter only, and whatever it has of its own.
        call("glGenSamplers", gl_.GenSamplers, 1, &sampler_);
        call("glSamplerParameteri", gl_.SamplerParameteri, sampler_, gl::TEXTURE_MIN_FILTER,
             (gl::GLint)gl::NEAREST);
        call("glSamplerParameteri", gl_.SamplerParameteri, sampler_, gl::TEXTURE_MAG_FILTER,
             (gl::GLint)gl::NEAREST);
    }
    call("glBindSampler", gl_.BindSampler, 0u, sampler_);
    gl::GLint level = 0, width = 0, height = 0, kind = 0;
    call("glGetTexParameteriv", gl_.GetTexParameteriv, gl::TEXTURE_2D, gl::TEXTURE_BASE_LEVEL,
         &level);
    call("glGetTexLevelParameteriv", gl_.GetTexLevelParameteriv, gl::TEXTURE_2D, level,
         gl::TEXTURE_WIDTH, &width);
    call("glGetTexLevelParameteriv", gl_.GetTexLevelParameteriv, gl::TEXTURE_2D, level,
         gl::TEXTURE_HEIGHT, &height);
    call("glGetTexLevelParameteriv", gl_.GetTexLevelParameteriv, gl::TEXTURE_2D, level,
         gl::TEXTURE_INTERNAL_FORMAT, &kind);
    if (width < 1 || height < 1)
        CV_Error_(Error::StsBadSize, ("texture = %u has %d x %d pixels: must have at least 1 x 1",
                                      texture, width, height));
    if (kind != gl::R8 && kind != gl::R8UI)
        CV_Error_(Error::StsUnsupportedFormat,
                  ("texture = %u has the internal format 0x%04x: must be GL_R8 or GL_R8UI", texture,
                   kind));
    isInteger = kind == gl::R8UI;
    return Size(width, height);
}

void GlDevice::allocate(GlBuffer& buffer, size_t bytes)
{
    bytes = (bytes + 15) / 16 * 16;
    if (buffer.device_.get() == this && bytes <= buffer.bytes_)
        return;
    buffer.release();
    freeDiscarded();
    gl::GLuint name = 0;
    call("glGenBuffers", gl_.GenBuffers, 1, &name);
    buffer.name_ = name;
    buffer.device_ = shared_from_this();
    bind(name);
    call("glBufferData", gl_.BufferData, gl::SHADER_STORAGE_BUFFER, (gl::GLsizeiptr)bytes,
         (const void*)0, gl::DYNAMIC_COPY);
    buffer.bytes_ = bytes;
}

void GlDevice::upload(const void* from, size_t bytes, GlBuffer& buffer)
{
    allocate(buffer, std::max<size_t>(bytes, 1));
    bind(buffer.name_);
    call("glBufferSubData", gl_.BufferSubData, gl::SHADER_STORAGE_BUFFER, (gl::GLintptr)0,
         (gl::GLsizeiptr)bytes, from);
}

void GlDevice::stamp()
{
    // OpenGL ES has it in an extension only.
    if (isEmbedded_ || !gl_.QueryCounter || !gl_.GetQueryObjectui64v)
        return;
    if (stamps_ == queries_.size())
    {
        gl::GLuint query = 0;
        call("glGenQueries", gl_.GenQueries, 1, &query);
        queries_.push_back(query);
    }
    call("glQueryCounter", gl_.QueryCounter, queries_[stamps_], gl::TIMESTAMP);
    ++stamps_;
}

std::vector<double> GlDevice::laps()
{
    std::vector<double> result;
    gl::GLuint64 before = 0;
    for (size_t i = 0; i < stamps_; ++i)
    {
        gl::GLuint64 now = 0;
        call("glGetQueryObjectui64v", gl_.GetQueryObjectui64v, queries_[i], gl::QUERY_RESULT, &now);
        if (i > 0)
            result.push_back((double)(now - before) * 1e-6);
        before = now;
    }
    return result;
}

void GlDevice::finish()
{
    if (!isBusy_)
        return;
    call("glMemoryBarrier", gl_.MemoryBarrier, gl::BUFFER_UPDATE_BARRIER_BIT);
    const gl::GLsync fence = call("glFenceSync", gl_.FenceSync, gl::SYNC_GPU_COMMANDS_COMPLETE, 0u);
    const gl::GLuint64 second = 1000000000;
    gl::GLenum state;
    do
        state = call("glClientWaitSync", gl_.ClientWaitSync, fence, gl::SYNC_FLUSH_COMMANDS_BIT,
                     second);
    while (state == gl::TIMEOUT_EXPIRED);
    call("glDeleteSync", gl_.DeleteSync, fence);
    if (state == gl::WAIT_FAILED)
        throw DeviceFailure("glClientWaitSync failed");
    isBusy_ = false;
    checkReset();
}

const void* GlDevice::map(const GlBuffer& buffer, size_t offset, size_t bytes)
{
    bind(buffer.name_);
    const void* const mapped =
        call("glMapBufferRange", gl_.MapBufferRange, gl::SHADER_STORAGE_BUFFER,
             (gl::GLintptr)offset, (gl::GLsizeiptr)bytes, gl::MAP_READ_BIT);
    if (!mapped)
        throw DeviceFailure("glMapBufferRange failed");
    return mapped;
}

void GlDevice::unmap()
{
    if (!call("glUnmapBuffer", gl_.UnmapBuffer, gl::SHADER_STORAGE_BUFFER))
        throw DeviceFailure("the contents of a buffer were lost");
}

void GlDevice::read(const GlBuffer& buffer, size_t bytes, void* to)
{
    if (bytes == 0)
        return;
    std::memcpy(to, map(buffer, 0, bytes), bytes);
    unmap();
}

gl::GLuint GlDevice::program(const char* source, bool readsPixels, const std::string& options)
{
    gl::GLuint& result = programs_[std::make_pair(source, options)];
    if (!result)
        result = compiled(source, readsPixels, options);
    return result;
}

gl::GLuint GlDevice::compiled(const char* source, bool readsPixels, const std::string& options)
{
    const std::string head = std::string(isEmbedded_ ? "#version 310 es\n"
                                                       "precision highp float;\n"
                                                       "precision highp int;\n"
                                                     : "#version 430 core\n") +
                             define("GROUP", GROUP) + define("NUMBERS", NUMBERS) + options;
    const auto textOf = [&](const char* option, const char* text)
    {
        return options.find(option) != std::string::npos ? text : "";
    };
    const char* const texts[] = {head.c_str(),
                                 chords_glsl,
                                 textOf("WINDOWS", windows_glsl),
                                 textOf("RING_RADIUS", ring_glsl),
                                 textOf("CHILD_BITS", children_glsl),
                                 readsPixels ? pixels_glsl : "",
                                 source};
    const gl::GLuint shader = call("glCreateShader", gl_.CreateShader, gl::COMPUTE_SHADER);
    call("glShaderSource", gl_.ShaderSource, shader, (gl::GLsizei)(sizeof(texts) / sizeof(*texts)),
         texts, (const gl::GLint*)0);
    call("glCompileShader", gl_.CompileShader, shader);
    gl::GLint done = 0;
    char log[2048] = "";
    call("glGetShaderiv", gl_.GetShaderiv, shader, gl::COMPILE_STATUS, &done);
    if (!done)
    {
        gl_.GetShaderInfoLog(shader, sizeof(log), 0, log);
        gl_.DeleteShader(shader);
        throw DeviceFailure(format("a shader is not compiled: %s", log));
    }
    const gl::GLuint result = call("glCreateProgram", gl_.CreateProgram);
    call("glAttachShader", gl_.AttachShader, result, shader);
    call("glLinkProgram", gl_.LinkProgram, result);
    call("glDeleteShader", gl_.DeleteShader, shader); // goes with the program
    call("glGetProgramiv", gl_.GetProgramiv, result, gl::LINK_STATUS, &done);
    if (!done)
    {
        gl_.GetProgramInfoLog(result, sizeof(log), 0, log);
        gl_.DeleteProgram(result);
        throw DeviceFailure(format("a shader is not linked: %s", log));
    }
    return result;
}

GlLaunch::GlLaunch(GlDevice& device, GlProgram program, const std::string& options)
    : device_(device), next_(0)
{
    device_.use(device_.program(sourceOf(program), program >= GL_EXACT, options));
}

GlLaunch::GlLaunch(GlDevice& device, const char* source, const std::string& options)
    : device_(device), next_(0)
{
    device_.use(device_.program(source, false, options));
}

GlLaunch& GlLaunch::block(const GlBuffer& buffer, size_t offset, size_t bytes)
{
    const size_t rounded = std::min((bytes + 15) / 16 * 16, buffer.bytes() - offset);
    if (bytes > device_.limits().blockBytes || (int)next_ >= device_.limits().blocks)
        throw DeviceFailure(
            format("%.0f bytes are more than a shader of this device can reach", (double)bytes));
    device_.bindBlock(next_++, buffer, offset, std::min(rounded, device_.limits().blockBytes));
    return *this;
}

GlLaunch& GlLaunch::windows(const GlBuffer& buffer, size_t bytes)
{
    const size_t most = device_.limits().blockBytes;
    for (size_t offset = 0; offset < bytes; offset += most)
        block(buffer, offset, std::min(most, bytes - offset));
    return *this;
}

void GlLaunch::run(const std::vector<int>& numbers, size_t groups)
{
    const size_t most = device_.limits().groups, columns = std::min(groups, most),
                 rows = (groups + columns - 1) / columns;
    if (rows > most)
        throw DeviceFailure(
            format("%.0f work groups are more than the device launches", (double)groups));
    queue(numbers, (unsigned)columns, (unsigned)rows, 1, false);
}

void GlLaunch::runRows(std::vector<int> numbers, int items, int rows, int layers, bool isBeside)
{
    const int most = (int)std::min<int64>(device_.limits().groups, INT_MAX / GlDevice::GROUP);
    for (int row = 0; row < rows; row += most)
        for (int item = 0; item < items; item += most * GlDevice::GROUP)
        {
            numbers[0] = item;
            numbers[1] = row;
            const int groups = (items - item - 1) / GlDevice::GROUP + 1;
            queue(numbers, (unsigned)std::min(groups, most), (unsigned)std::min(rows - row, most),
                  (unsigned)layers, isBeside);
            isBeside = true;
        }
}

GlLaunch& GlLaunch::fours(const std::vector<Vec4i>& numbers)
{
    device_.call("glUniform4iv", device_.gl_.Uniform4iv, (gl::GLint)GlDevice::NUMBERS,
                 (gl::GLsizei)numbers.size(), numbers.front().val);
    return *this;
}

void GlLaunch::queue(const std::vector<int>& numbers, unsigned columns, unsigned rows,
                     unsigned layers, bool isBeside)
{
    CV_DbgAssert(numbers.size() <= (size_t)GlDevice::NUMBERS);
    const gl::Functions& gl = device_.gl_;
    if (!isBeside)
        device_.call("glMemoryBarrier", gl.MemoryBarrier, gl::SHADER_STORAGE_BARRIER_BIT);
    device_.call("glUniform1iv", gl.Uniform1iv, 0, (gl::GLsizei)numbers.size(), numbers.data());
    device_.call("glDispatchCompute", gl.DispatchCompute, columns, rows, layers);
    device_.isBusy_ = true;
}

std::string define(const char* name, int value)
{
    return format("#define %s %d\n", name, value);
}

int asShaderInt(double value)
{
    if (std::abs(value) > INT_MAX)
        throw DeviceFailure("the frame is too large for 32-bit numbers");
    return (int)value;
}

} // namespace linespace
} // namespace cv

#endif // LINESPACE_OPENGL
