// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The OpenGL path: contexts, textures, threads; that it counts the same is, but for the outputs of
// detect, a matter of the tests of all back ends.

#include "test_precomp.hpp"

#include "generators.hpp"
#include "test_gl.hpp"
#include "test_support.hpp"

#include <fstream>
#include <thread>

namespace opencv_test {
namespace {

using namespace generators;
namespace gl = cv::linespace::gl;

typedef std::vector<Vec3f> Lines;

class Linespace_OpenGl : public testing::Test
{
protected:
    Linespace_OpenGl() : edges(randomEdges(Size(90, 70), 0.2, 1)), expected()
    {
        detectorFor(BACKEND_CPU)->detect(edges, expected);
    }
    static Ptr<LineSpaceDetector> detectorFor(int backend)
    {
        return LineSpaceDetector::create(20, 0, METHOD_CASCADED, 8, backend);
    }
    Lines detected(LineSpaceDetector& detector) const
    {
        Lines lines;
        detector.detect(edges, lines);
        EXPECT_EQ(BACKEND_OPENGL, detector.getActiveBackend());
        return lines;
    }
    Lines detected() const { return detected(*detectorFor(BACKEND_OPENGL)); }

    const Mat1b edges;
    Lines expected;
};

TEST_F(Linespace_OpenGl, random_sizes_and_densities)
{
    requireBackend(BACKEND_OPENGL);
    RNG random(5);
    for (int i = 0; i < 200; ++i)
    {
        const Size size(random.uniform(1, 260), random.uniform(1, 200));
        const Mat1b image = randomEdges(size, random.uniform(0., 1.), (unsigned)i);
        const int backends[] = {BACKEND_CPU, BACKEND_OPENGL};
        Lines lines[2], oriented[2];
        Mat tables[2];
        for (int k = 0; k < 2; ++k)
        {
            const Ptr<LineSpaceDetector> detector = detectorFor(backends[k]);
            detector->setEdgeWeights(i % 4 == 3);
            detector->setThreshold(std::min(size.width, size.height) / 2);
            detector->setMaxLines(200);
            if (i % 3 == 0)
                detector->setMask(randomEdges(size, 0.8, (unsigned)i + 1000));
            detector->detect(image, lines[k]);
            detector->detect(image, noArray(), noArray(), oriented[k]);
            detector->compute(image, tables[k]);
            ASSERT_EQ(backends[k], detector->getActiveBackend());
        }
        ASSERT_EQ(lines[0], lines[1]) << i << ": " << size;
        ASSERT_EQ(oriented[0], oriented[1]) << i << ": " << size;
        ASSERT_EQ(0, cvtest::norm(tables[0], tables[1], NORM_INF)) << i << ": " << size;
    }
}

//! Of so many chords that a sample tells the cut, and so few candidates that it is often too high;
//! lines near stronger ones are dropped, so that the weakest candidate may be reported.
TEST_F(Linespace_OpenGl, a_cut_that_is_too_high)
{
    requireBackend(BACKEND_OPENGL);
    for (int i = 0; i < 40; ++i)
    {
        const Mat1b image = randomEdges(Size(150 + i, 190 - i), 0.3, (unsigned)i);
        Lines lines[2];
        const int backends[] = {BACKEND_CPU, BACKEND_OPENGL};
        for (int k = 0; k < 2; ++k)
        {
            const Ptr<LineSpaceDetector> detector = detectorFor(backends[k]);
            detector->setMaxLines(1 + i % 3);
            detector->setPoolSize(1 + 2 * i);
            detector->setSuppressionRadius(i % 2 ? 0 : 2);
            detector->setSuppressionDistance(80);
            detector->detect(image, lines[k]);
        }
        ASSERT_EQ(lines[0], lines[1]) << i;
    }
}

TEST_F(Linespace_OpenGl, stages_add_up_to_the_whole)
{
    requireBackend(BACKEND_OPENGL);
    const Mat1b image = randomEdges(Size(300, 200), 0.1, 3);
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_OPENGL);
    double best = 0;
    for (int round = 0; round < 5; ++round)
    {
        Lines lines;
        const double begin = (double)getTickCount();
        detector->detect(image, lines);
        const double whole = ((double)getTickCount() - begin) * 1e3 / getTickFrequency();
        std::vector<String> names;
        std::vector<double> milliseconds;
        detector->getStageTimes(names, milliseconds);
        double sum = 0, votes = 0;
        for (size_t i = 0; i < names.size(); ++i)
        {
            EXPECT_GE(milliseconds[i], 0) << names[i];
            sum += milliseconds[i];
            votes += names[i].find("level") == 0 ? milliseconds[i] : 0;
        }
        EXPECT_EQ(detector->getLevelCount() + 4, (int)names.size());
        EXPECT_LE(sum, 1.01 * whole);
        EXPECT_GT(votes, 0);
        best = std::max(best, sum / whole);
    }
    EXPECT_GT(best, 0.8);
}

//! Of blocks of 2 MiB; of four, as opengl.few_blocks has them, one too few to find candidates there.
TEST_F(Linespace_OpenGl, a_table_of_two_blocks)
{
    requireBackend(BACKEND_OPENGL);
    const Mat1b image = randomEdges(Size(340, 330), 0.1, 3);
    Lines lines[2];
    detectorFor(BACKEND_CPU)->detect(image, lines[0]);
    detectorFor(BACKEND_OPENGL)->detect(image, lines[1]);
    EXPECT_FALSE(lines[0].empty());
    EXPECT_EQ(lines[0], lines[1]);
}

TEST_F(Linespace_OpenGl, full_hd)
{
    requireBackend(BACKEND_OPENGL);
    const Size size(1920, 1080);
    const Mat1b image = randomEdges(size, 0.05, 9), mask = randomEdges(size, 0.7, 10);
    for (int variant = 0; variant < 3; ++variant)
    {
        Lines lines[2];
        const int backends[] = {BACKEND_CPU, BACKEND_OPENGL};
        for (int k = 0; k < 2; ++k)
        {
            const Ptr<LineSpaceDetector> detector = detectorFor(backends[k]);
            detector->setMaxLines(100);
            detector->setThreshold(variant == 0 ? 60 : variant == 1 ? 15 : 9000);
            detector->setEdgeWeights(variant == 2);
            if (variant > 0)
                detector->setMask(mask);
            if (variant == 1)
                detector->detect(image, noArray(), noArray(), lines[k]);
            else
                detector->detect(image, lines[k]);
        }
        EXPECT_FALSE(lines[0].empty());
        EXPECT_EQ(lines[0], lines[1]) << variant;
    }
}

TEST_F(Linespace_OpenGl, the_default_back_end_of_the_process)
{
    requireBackend(BACKEND_OPENGL);
    // Of so many edge pixels that the drop-in counts chords.
    const Mat1b dense = randomEdges(Size(400, 300), 0.5, 1);
    Lines byCpu, byOpenGl, lines;
    cv::linespace::HoughLines(dense, byCpu, 1, CV_PI / 900, 220);
    const DefaultBackend device(BACKEND_OPENGL);
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_AUTO);
    detector->detect(edges, lines);
    EXPECT_EQ(BACKEND_OPENGL, detector->getActiveBackend());
    cv::linespace::HoughLines(dense, byOpenGl, 1, CV_PI / 900, 220);
    EXPECT_EQ(expected, lines);
    ASSERT_FALSE(byCpu.empty());
    EXPECT_EQ(byCpu, byOpenGl);
}

TEST_F(Linespace_OpenGl, no_context_is_left_current)
{
    requireBackend(BACKEND_OPENGL);
    EXPECT_EQ(expected, detected());
    EXPECT_TRUE(TestContext::current() == nullptr);
}

//! One detector, of each thread after the other: a context of its own moves along.
TEST_F(Linespace_OpenGl, one_detector_from_one_thread_after_another)
{
    requireBackend(BACKEND_OPENGL);
    const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_OPENGL);
    for (int round = 0; round < 4; ++round)
    {
        Lines lines;
        std::thread([&]() { lines = detected(*detector); }).join();
        EXPECT_EQ(expected, lines);
        EXPECT_EQ(expected, detected(*detector));
    }
}

TEST_F(Linespace_OpenGl, detectors_of_several_threads)
{
    requireBackend(BACKEND_OPENGL);
    std::vector<std::thread> threads;
    std::vector<std::vector<Lines>> lines(4);
    for (size_t i = 0; i < lines.size(); ++i)
        threads.push_back(std::thread(
            [this, i, &lines]()
            {
                const Ptr<LineSpaceDetector> detector = detectorFor(BACKEND_OPENGL);
                for (int round = 0; round < 5; ++round)
                    lines[i].push_back(
                        detected(round < 3 ? *detector : *detectorFor(BACKEND_OPENGL)));
            }));
    for (size_t i = 0; i < threads.size(); ++i)
        threads[i].join();
    for (size_t i = 0; i < lines.size(); ++i)
        for (size_t k = 0; k < lines[i].size(); ++k)
            EXPECT_EQ(expected, lines[i][k]) << "thread " << i << ", round " << k;
}

//! Everything that the library binds, bound to something else before.
class BoundState
{
public:
    explicit BoundState(const TestContext& context, bool isInteger) : gl_(context.gl()), program_(0)
    {
        const std::string source =
            std::string((const char*)gl_.GetString(gl::VERSION)).find("OpenGL ES") == 0
                ? "#version 310 es\n"
                : "#version 430 core\n";
        const std::string text = source + "layout(local_size_x = 1) in;\n"
                                          "layout(std430, binding = 0) buffer B { uint b[]; };\n"
                                          "void main() { b[0] = 1u; }\n";
        const char* const lines = text.c_str();
        const gl::GLuint shader = gl_.CreateShader(gl::COMPUTE_SHADER);
        gl_.ShaderSource(shader, 1, &lines, nullptr);
        gl_.CompileShader(shader);
        program_ = gl_.CreateProgram();
        gl_.AttachShader(program_, shader);
        gl_.LinkProgram(program_);
        gl_.DeleteShader(shader);
        gl_.UseProgram(program_);
        gl_.GenBuffers(BLOCKS + 1, buffers_);
        for (int i = 0; i <= BLOCKS; ++i)
        {
            const std::vector<uchar> bytes(4096, (uchar)(i + 1));
            gl_.BindBuffer(gl::SHADER_STORAGE_BUFFER, buffers_[i]);
            gl_.BufferData(gl::SHADER_STORAGE_BUFFER, 4096, bytes.data(), gl::DYNAMIC_COPY);
        }
        for (int i = 0; i < BLOCKS; ++i)
            if (i % 3 == 0)
                gl_.BindBufferBase(gl::SHADER_STORAGE_BUFFER, i, buffers_[i]);
            else if (i % 3 == 1)
                gl_.BindBufferRange(gl::SHADER_STORAGE_BUFFER, i, buffers_[i], 256 * i, 512);
        gl_.BindBuffer(gl::SHADER_STORAGE_BUFFER, buffers_[BLOCKS]);
        gl_.GenSamplers(2, samplers_);
        for (int unit = 0; unit < 3; ++unit)
            textures_[unit] = context.textureOf(Mat1b(4, 4, uchar(unit + 1)), isInteger);
        for (int unit = 0; unit < 3; ++unit)
        {
            gl_.ActiveTexture(gl::TEXTURE0 + unit);
            gl_.BindTexture(gl::TEXTURE_2D, textures_[unit]);
            gl_.BindSampler(unit, unit < 2 ? samplers_[unit] : 0);
        }
        gl_.ActiveTexture(gl::TEXTURE0 + 2);
    }

    void check() const
    {
        EXPECT_EQ(0, (int)gl_.GetError());
        EXPECT_EQ((int)program_, number(gl::CURRENT_PROGRAM));
        EXPECT_EQ((int)buffers_[BLOCKS], number(gl::SHADER_STORAGE_BUFFER_BINDING));
        for (int i = 0; i < BLOCKS; ++i)
        {
            gl::GLint name = -1;
            gl::GLint64 start = -1, size = -1;
            gl_.GetIntegeri_v(gl::SHADER_STORAGE_BUFFER_BINDING, i, &name);
            gl_.GetInteger64i_v(gl::SHADER_STORAGE_BUFFER_START, i, &start);
            gl_.GetInteger64i_v(gl::SHADER_STORAGE_BUFFER_SIZE, i, &size);
            EXPECT_EQ(i % 3 < 2 ? (int)buffers_[i] : 0, name) << "block " << i;
            EXPECT_EQ(i % 3 == 1 ? 256 * i : 0, (int)start) << "block " << i;
            EXPECT_EQ(i % 3 == 1 ? 512 : 0, (int)size) << "block " << i;
        }
        EXPECT_EQ(gl::TEXTURE0 + 2, number(gl::ACTIVE_TEXTURE));
        for (int unit = 2; unit >= 0; --unit)
        {
            gl_.ActiveTexture(gl::TEXTURE0 + unit);
            EXPECT_EQ((int)textures_[unit], number(gl::TEXTURE_BINDING_2D)) << "unit " << unit;
            EXPECT_EQ(unit < 2 ? (int)samplers_[unit] : 0, number(gl::SAMPLER_BINDING))
                << "unit " << unit;
        }
        gl_.ActiveTexture(gl::TEXTURE0 + 2);
        for (int i = 0; i <= BLOCKS; ++i)
        {
            gl_.BindBuffer(gl::SHADER_STORAGE_BUFFER, buffers_[i]);
            const uchar* const bytes = (const uchar*)gl_.MapBufferRange(gl::SHADER_STORAGE_BUFFER,
                                                                        0, 4096, gl::MAP_READ_BIT);
            ASSERT_TRUE(bytes != nullptr);
            EXPECT_EQ(4096, std::count(bytes, bytes + 4096, (uchar)(i + 1))) << "buffer " << i;
            gl_.UnmapBuffer(gl::SHADER_STORAGE_BUFFER);
        }
        gl_.BindBuffer(gl::SHADER_STORAGE_BUFFER, buffers_[BLOCKS]);
    }

private:
    enum
    {
        BLOCKS = 4 // as many as every context has
    };
    int number(gl::GLenum name) const
    {
        gl::GLint value = -1;
        gl_.GetIntegerv(name, &value);
        return value;
    }

    const TestFunctions& gl_;
    gl::GLuint program_, buffers_[BLOCKS + 1], textures_[3], samplers_[2];
};

//! 4.3 and ES 3.1.
typedef testing::TestWithParam<bool> Linespace_OpenGl_Context;

TEST_P(Linespace_OpenGl_Context, state_of_the_caller_is_restored)
{
    requireBackend(BACKEND_OPENGL);
    const TestContext context(GetParam());
    const Mat1b edges = randomEdges(Size(90, 70), 0.2, 1);
    const unsigned int texture = context.textureOf(edges, true);
    const BoundState state(context, false);
    state.check();
    void* const before = TestContext::current();
    Lines expected, lines, oriented;
    LineSpaceDetector::create(20, 0, METHOD_CASCADED, 8, BACKEND_CPU)->detect(edges, expected);
    {
        const Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(20, 0, METHOD_CASCADED, 8, BACKEND_OPENGL);
        const int radii[] = {2, 0};
        for (int i = 0; i < 2; ++i)
        {
            detector->setSuppressionRadius(radii[i]);
            detector->detect(edges, lines);
            state.check();
            if (i == 0)
            {
                EXPECT_EQ(expected, lines);
            }
            detector->detect(edges, noArray(), noArray(), oriented);
            state.check();
            Mat table;
            detector->compute(edges, table);
            state.check();
            detector->detectTexture(texture, oriented);
            EXPECT_EQ(lines, oriented);
            state.check();
            // Errors as well, in the middle of the work.
            EXPECT_EQ("", wrongException([&]() { detector->detectTexture(12345, lines); },
                                         {"texture", "12345"}));
            state.check();
        }
        detector->clear();
        state.check();
    }
    state.check();
    EXPECT_EQ(before, TestContext::current());
}

TEST_P(Linespace_OpenGl_Context, textures)
{
    requireBackend(BACKEND_OPENGL);
    const TestContext context(GetParam());
    const Ptr<LineSpaceDetector> byCpu = LineSpaceDetector::create(0, 0, METHOD_CASCADED, 8,
                                                                   BACKEND_CPU),
                                 byOpenGl = LineSpaceDetector::create();
    for (int i = 0; i < 60; ++i)
    {
        const Size size(1 + 17 * i % 131, 1 + 29 * i % 97);
        const Mat1b edges = randomEdges(size, 0.1 + 0.05 * (i % 8), (unsigned)i);
        const Mat1b mask = i % 3 ? Mat1b() : randomEdges(size, 0.7, (unsigned)i + 100);
        const unsigned int texture = context.textureOf(edges, i % 2 > 0);
        Lines expected, lines;
        for (const Ptr<LineSpaceDetector>& detector : {byCpu, byOpenGl})
        {
            detector->setMask(mask);
            detector->setEdgeWeights(i % 5 == 4);
            detector->setMethod(i % 7 == 6 ? METHOD_EXACT : METHOD_CASCADED);
            detector->setSuppressionRadius(i % 4);
            detector->setThreshold(i % 8 < 6 ? 0 : 4);
            // By the number of pixels some of the chords are wanted, or whatever it is all.
            const double chords = std::pow(size.width + size.height, 2) + 2. * size.area();
            detector->setFalseAlarms(std::max(1., (i % 6 < 3 ? 0.2 : 2) * chords));
            detector->setSuppression(i % 11 == 5 ? SUPPRESS_BLOCKS : SUPPRESS_RING);
            detector->setSelection(i % 13 == 7 ? SELECT_EXPLAIN : SELECT_PEAKS);
        }
        byCpu->detect(edges, expected);
        byOpenGl->detectTexture(texture, lines);
        ASSERT_EQ(BACKEND_OPENGL, byOpenGl->getActiveBackend());
        ASSERT_EQ(expected, lines) << i << ": " << size;
        context.gl().DeleteTextures(1, &texture);
    }
}

//! Lowers the limits of the devices that are made in its time.
class LowLimits
{
public:
    explicit LowLimits(const char* limits)
    {
#ifndef _WIN32
        const char* const now = getenv(name());
        before_ = now ? now : "";
        setenv(name(), limits, 1);
#endif
    }
    ~LowLimits()
    {
#ifndef _WIN32
        setenv(name(), before_.c_str(), 1);
#endif
    }

private:
    static const char* name()
    {
        return "LINESPACE_OPENGL_LIMITS";
    }
    std::string before_; // an empty one lowers nothing
};

//! The CPU path takes over, and has the pixels from the device that failed.
TEST_P(Linespace_OpenGl_Context, a_device_that_fails)
{
    requireBackend(BACKEND_OPENGL);
    const LowLimits limits("16384,100,4");
    const TestContext context(GetParam());
    const Mat1b edges = randomEdges(Size(90, 70), 0.2, 1);
    const unsigned int texture = context.textureOf(edges, true);
    const BoundState state(context, true);
    for (int threshold = 0; threshold <= 20; threshold += 20)
    {
        Lines expected, lines;
        LineSpaceDetector::create(threshold, 0, METHOD_CASCADED, 8, BACKEND_CPU)
            ->detect(edges, expected);
        const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(threshold);
        for (int i = 0; i < 2; ++i)
        {
            detector->detectTexture(texture, lines);
            EXPECT_EQ(BACKEND_CPU, detector->getActiveBackend());
            EXPECT_EQ(expected, lines);
            state.check();
        }
        detector->setBackend(BACKEND_OPENGL);
        EXPECT_EQ("", wrongException([&]() { detector->detectTexture(texture, lines); },
                                     {"BACKEND_OPENGL", "bytes"}));
    }
}

TEST_P(Linespace_OpenGl_Context, textures_that_are_none)
{
    requireBackend(BACKEND_OPENGL);
    const TestContext context(GetParam());
    const TestFunctions& functions = context.gl();
    gl::GLuint wrong[4];
    functions.GenTextures(4, wrong);
    const gl::GLenum cubeMap = 0x8513, rgba = 0x1908, bytes = 0x1401, rgba8 = 0x8058;
    functions.BindTexture(gl::TEXTURE_2D, wrong[1]); // without an image
    functions.BindTexture(cubeMap, wrong[2]);
    functions.BindTexture(gl::TEXTURE_2D, wrong[3]);
    functions.TexImage2D(gl::TEXTURE_2D, 0, rgba8, 8, 8, 0, rgba, bytes, nullptr);
    functions.BindTexture(gl::TEXTURE_2D, 0);
    const Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(5);
    const Lines sentinel(2, Vec3f(1, 2, 3));
    Lines lines = sentinel;
    const char* const words[] = {"texture", "pixels", "GL_TEXTURE_2D", "GL_R8UI"};
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_EQ("", wrongException([&]() { detector->detectTexture(wrong[i], lines); },
                                     {"texture = ", words[i], "must"}))
            << i;
        EXPECT_EQ(sentinel, lines);
        EXPECT_EQ(-1, detector->getActiveBackend());
        EXPECT_EQ(0, (int)functions.GetError());
    }
    const unsigned int texture = context.textureOf(Mat1b(20, 30, uchar(1)), true);
    detector->setMask(Mat1b(30, 20, uchar(1)));
    EXPECT_EQ("", wrongException([&]() { detector->detectTexture(texture, lines); },
                                 {"mask", "20 x 30", "30 x 20", "texture"}));
    detector->setMask(noArray());
    detector->setMemoryLimit(1);
    const unsigned int large = context.textureOf(Mat1b(600, 600, uchar(1)), true);
    EXPECT_EQ("", wrongException([&]() { detector->detectTexture(large, lines); },
                                 {"texture", "memoryLimit"}));
    detector->setBackend(BACKEND_CPU);
    EXPECT_EQ("", wrongException([&]() { detector->detectTexture(texture, lines); },
                                 {"backend", "BACKEND_OPENGL"}));
    EXPECT_EQ(sentinel, lines);
    TestContext::release();
    detector->setBackend(BACKEND_AUTO);
    EXPECT_EQ("", wrongException([&]() { detector->detectTexture(texture, lines); },
                                 {"texture", "context", "current"}));
}

//! Of the context that is current.
int buffersIn(const TestContext& context)
{
    int buffers = 0;
    for (gl::GLuint name = 1; name < 200; ++name)
        buffers += context.gl().IsBuffer(name) ? 1 : 0;
    return buffers;
}

//! A detector goes along with the context that is current, or with none.
TEST_P(Linespace_OpenGl_Context, contexts_take_turns)
{
    requireBackend(BACKEND_OPENGL);
    const Mat1b edges = randomEdges(Size(90, 70), 0.2, 1);
    Lines expected, lines;
    LineSpaceDetector::create(20, 0, METHOD_CASCADED, 8, BACKEND_CPU)->detect(edges, expected);
    const Ptr<LineSpaceDetector> detector =
        LineSpaceDetector::create(20, 0, METHOD_CASCADED, 8, BACKEND_OPENGL);
    TestContext first(GetParam()), second(!GetParam());
    for (int i = 0; i < 12; ++i)
    {
        if (i % 3 == 0)
            first.makeCurrent();
        else if (i % 3 == 1)
            second.makeCurrent();
        else
            TestContext::release();
        void* const before = TestContext::current();
        detector->detect(edges, lines);
        EXPECT_EQ(expected, lines);
        EXPECT_EQ(BACKEND_OPENGL, detector->getActiveBackend());
        EXPECT_EQ(before, TestContext::current());
    }
    // Both have been worked in: the test itself has made no buffers.
    for (TestContext* context : {&first, &second})
    {
        context->makeCurrent();
        EXPECT_GT(buffersIn(*context), 0);
    }
}

//! The drop-in has no object, so what it counts with is kept for the next call in the same context.
TEST_P(Linespace_OpenGl_Context, the_drop_in_goes_along_with_contexts)
{
    requireBackend(BACKEND_OPENGL);
    // Of so many edge pixels that it counts chords.
    const Mat1b dense = randomEdges(Size(400, 300), 0.5, 1);
    const auto houghLines = [&]()
    {
        Lines lines;
        cv::linespace::HoughLines(dense, lines, 1, CV_PI / 900, 220);
        return lines;
    };
    const Lines expected = houghLines();
    ASSERT_FALSE(expected.empty());
    const DefaultBackend device(BACKEND_OPENGL);
    {
        TestContext first(GetParam()), second(!GetParam());
        TestContext* const contexts[] = {&first, &second};
        int buffers[2];
        for (int i = 0; i < 6; ++i)
        {
            if (i % 3 < 2)
                contexts[i % 3]->makeCurrent();
            else
                TestContext::release();
            void* const before = TestContext::current();
            EXPECT_EQ(expected, houghLines());
            EXPECT_EQ(before, TestContext::current());
            if (i < 2)
            {
                buffers[i] = buffersIn(*contexts[i]);
                EXPECT_GT(buffers[i], 0);
            }
            else if (i % 3 < 2)
            {
                EXPECT_EQ(buffers[i % 3], buffersIn(*contexts[i % 3])) << i;
            }
        }
    }
    // Handles come again, and with them the names of buffers and programs.
    for (int i = 0; i < 6; ++i)
    {
        const TestContext context(GetParam());
        const BoundState state(context, false);
        for (int k = 0; k < 1 + i % 2; ++k)
        {
            EXPECT_EQ(expected, houghLines()) << i;
            state.check();
        }
    }
    std::vector<std::thread> threads;
    std::vector<std::vector<Lines>> lines(3);
    for (std::vector<Lines>& ofThread : lines)
        threads.push_back(std::thread(
            [&]()
            {
                for (int round = 0; round < 2; ++round)
                    ofThread.push_back(houghLines());
            }));
    for (std::thread& thread : threads)
        thread.join();
    for (const std::vector<Lines>& ofThread : lines)
        EXPECT_EQ(std::vector<Lines>(2, expected), ofThread);
}

size_t residentBytes()
{
    std::ifstream statm("/proc/self/statm");
    size_t total = 0, resident = 0;
    statm >> total >> resident;
    return resident * 4096;
}

//! The handle of a context that was destroyed comes again with the next one, which has objects of
//! its own of the same names. No program and no buffer of the old one may be taken for one of the
//! new.
TEST_P(Linespace_OpenGl_Context, a_thousand_contexts_are_made_and_destroyed)
{
    requireBackend(BACKEND_OPENGL);
    const Mat1b edges = randomEdges(Size(24, 17), 0.4, 1);
    Lines expected;
    LineSpaceDetector::create(5, 0, METHOD_CASCADED, 8, BACKEND_CPU)->detect(edges, expected);
    const Ptr<LineSpaceDetector> kept =
        LineSpaceDetector::create(5, 0, METHOD_CASCADED, 8, BACKEND_OPENGL);
    size_t before = 0;
    for (int i = 0; i < 1000; ++i)
    {
        if (i == 200)
            before = residentBytes();
        TestContext context(GetParam());
        // Buffers with the names that the library had in the last one.
        gl::GLuint own[12];
        context.gl().GenBuffers(12, own);
        for (int k = 0; k < 12; ++k)
        {
            const std::vector<uchar> bytes(64, (uchar)k);
            context.gl().BindBuffer(gl::SHADER_STORAGE_BUFFER, own[k]);
            context.gl().BufferData(gl::SHADER_STORAGE_BUFFER, 64, bytes.data(), gl::DYNAMIC_COPY);
        }
        Lines lines;
        if (i % 4 < 2) // also in two that follow one another
        {
            kept->detect(edges, lines);
            ASSERT_EQ(expected, lines) << i;
        }
        else
        {
            Mat table;
            LineSpaceDetector::create(5, 0, METHOD_EXACT, 8, BACKEND_OPENGL)
                ->compute(Mat1b(3, 4, uchar(1)), table);
        }
        for (int k = 0; k < 12; ++k)
        {
            context.gl().BindBuffer(gl::SHADER_STORAGE_BUFFER, own[k]);
            const uchar* const bytes = (const uchar*)context.gl().MapBufferRange(
                gl::SHADER_STORAGE_BUFFER, 0, 64, gl::MAP_READ_BIT);
            ASSERT_TRUE(bytes != nullptr && std::count(bytes, bytes + 64, (uchar)k) == 64) << i;
            context.gl().UnmapBuffer(gl::SHADER_STORAGE_BUFFER);
        }
    }
    const size_t after = residentBytes();
    std::cout << before / 1024 << " KiB after 200 contexts, " << after / 1024 << " after 1000"
              << std::endl;
    EXPECT_LT((double)after, before + 16e6);
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_OpenGl_Context, testing::Bool());

//! Two at a time have a context each, of which one is kept and one is destroyed.
TEST_F(Linespace_OpenGl, a_thousand_contexts_without_a_window)
{
    requireBackend(BACKEND_OPENGL);
    size_t before = 0;
    for (int i = 0; i < 1000; ++i)
    {
        if (i == 200)
            before = residentBytes();
        Mat tables[2];
        Ptr<LineSpaceDetector> detectors[2];
        for (int k = 0; k < 2; ++k)
        {
            detectors[k] = LineSpaceDetector::create(5, 0, METHOD_EXACT, 8, BACKEND_OPENGL);
            detectors[k]->compute(Mat1b(3, 4, uchar(1)), tables[k]);
        }
        ASSERT_EQ(0, cvtest::norm(tables[0], tables[1], NORM_INF));
    }
    const size_t after = residentBytes();
    std::cout << before / 1024 << " KiB after 200 contexts, " << after / 1024 << " after 1000"
              << std::endl;
    EXPECT_LT((double)after, before + 16e6);
}

} // namespace
} // namespace opencv_test
