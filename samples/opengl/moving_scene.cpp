// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Lines of what a graphics application draws, found where it is: a scene of boxes that turn is
// drawn off-screen by OpenGL, a compute shader marks its edges in a texture, and detectTexture
// finds their lines. Only then is the picture read, to draw the lines over it:
//   linespace_moving_scene OUTPUT [--frames=50]
// OUTPUT is a folder, for frame000.png and so on, or a video, NAME.avi. It needs libepoxy (which
// finds the functions of OpenGL) and EGL; the library itself needs neither.

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/linespace.hpp>
#include <opencv2/videoio.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

const int WIDTH = 640, HEIGHT = 480;

const char* const vertexShader = R"(#version 430 core
uniform float angle;
flat out float shade;
void main()
{
    const vec2 corners[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(1, 1),
                                    vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
    int face = gl_VertexID / 6, axis = face / 2;
    float side = face % 2 == 0 ? -1.0 : 1.0;
    vec2 corner = corners[gl_VertexID % 6];
    vec3 point = axis == 0   ? vec3(side, corner)
                 : axis == 1 ? vec3(corner.x, side, corner.y)
                             : vec3(corner, side);
    float height = 0.5 + 0.3 * float(gl_InstanceID * 7 % 5);
    point = point * vec3(0.8, height, 0.8) + vec3(0.0, height, 0.0);
    point.xz += 2.6 * (vec2(gl_InstanceID % 3, gl_InstanceID / 3) - 1.0);
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    point.xz = turn * point.xz;
    vec3 seen = point - vec3(0.0, 1.2, 0.0); // from above, and from the front
    seen.yz = mat2(0.9, 0.436, -0.436, 0.9) * seen.yz;
    seen.z -= 8.5;
    const float near = 1.0, far = 30.0;
    gl_Position = vec4(1.35 * seen.x, 1.8 * seen.y,
                       ((far + near) * seen.z + 2.0 * far * near) / (near - far), -seen.z);
    shade = 0.25 + 0.22 * float(axis) + 0.09 * (side + 1.0) + 0.01 * float(gl_InstanceID);
}
)";

const char* const fragmentShader = R"(#version 430 core
flat in float shade;
out float grey;
void main()
{
    grey = shade;
}
)";

// 1 where the gradient is large, and largest across the edge.
const char* const edgeShader = R"(#version 430 core
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D scene;
layout(binding = 0, r8ui) writeonly uniform uimage2D edges;

float at(ivec2 p)
{
    return texelFetch(scene, clamp(p, ivec2(0), textureSize(scene, 0) - 1), 0).r;
}
vec2 gradient(ivec2 p)
{
    float a = at(p + ivec2(-1, -1)), b = at(p + ivec2(0, -1)), c = at(p + ivec2(1, -1)),
          d = at(p + ivec2(-1, 0)), e = at(p + ivec2(1, 0)),
          f = at(p + ivec2(-1, 1)), g = at(p + ivec2(0, 1)), h = at(p + ivec2(1, 1));
    return vec2(c + 2.0 * e + h - a - 2.0 * d - f, f + 2.0 * g + h - a - 2.0 * b - c);
}
void main()
{
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, textureSize(scene, 0))))
        return;
    vec2 here = gradient(p);
    ivec2 across = abs(here.x) > 2.4 * abs(here.y)   ? ivec2(1, 0)
                   : abs(here.y) > 2.4 * abs(here.x) ? ivec2(0, 1)
                                                     : ivec2(1, here.x * here.y > 0.0 ? 1 : -1);
    float size = length(here);
    bool isEdge = size > 0.12 && size > length(gradient(p - across)) &&
                  size >= length(gradient(p + across));
    imageStore(edges, p, uvec4(isEdge ? 1u : 0u));
}
)";

//! A context of OpenGL 4.3 without a window, current as long as it lives.
class Context
{
public:
    Context()
    {
        display_ = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")
                       ? eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                  EGL_DEFAULT_DISPLAY, nullptr)
                       : eglGetDisplay(EGL_DEFAULT_DISPLAY);
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 3,
                                  EGL_NONE};
        if (!eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
            throw std::runtime_error("EGL cannot be initialised");
        context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
        if (!context_ || !eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            throw std::runtime_error("there is no OpenGL 4.3");
    }
    ~Context()
    {
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }

private:
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    EGLDisplay display_;
    EGLContext context_;
};

GLuint programOf(std::initializer_list<std::pair<GLenum, const char*>> shaders)
{
    const GLuint program = glCreateProgram();
    for (const auto& [type, source] : shaders)
    {
        const GLuint shader = glCreateShader(type);
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked)
    {
        char log[1024] = "";
        glGetProgramInfoLog(program, sizeof(log), nullptr, log);
        throw std::runtime_error(std::string("a shader is not built: ") + log);
    }
    return program;
}

//! What the application draws; its objects go with the context.
class Scene
{
public:
    Scene()
        : boxes_(
              programOf({{GL_VERTEX_SHADER, vertexShader}, {GL_FRAGMENT_SHADER, fragmentShader}})),
          marker_(programOf({{GL_COMPUTE_SHADER, edgeShader}}))
    {
        picture_ = texture(GL_R8);
        edges_ = texture(GL_R8UI);
        GLuint vertices = 0, depth = 0;
        glGenVertexArrays(1, &vertices);
        glBindVertexArray(vertices);
        glGenRenderbuffers(1, &depth);
        glBindRenderbuffer(GL_RENDERBUFFER, depth);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, WIDTH, HEIGHT);
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_, 0);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
        glViewport(0, 0, WIDTH, HEIGHT);
        glEnable(GL_DEPTH_TEST);
    }

    //! The name of the texture with its edges.
    GLuint draw(float angle) const
    {
        glUseProgram(boxes_);
        glUniform1f(glGetUniformLocation(boxes_, "angle"), angle);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glDrawArraysInstanced(GL_TRIANGLES, 0, 36, 9);
        glUseProgram(marker_);
        glBindTexture(GL_TEXTURE_2D, picture_);
        glBindImageTexture(0, edges_, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
        glDispatchCompute((WIDTH + 7) / 8, (HEIGHT + 7) / 8, 1);
        glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
        return edges_;
    }

    //! The first row is the lowest, as of the texture.
    cv::Mat1b picture() const
    {
        cv::Mat1b pixels(HEIGHT, WIDTH);
        glReadPixels(0, 0, WIDTH, HEIGHT, GL_RED, GL_UNSIGNED_BYTE, pixels.data);
        return pixels;
    }

private:
    static GLuint texture(GLenum format)
    {
        GLuint name = 0;
        glGenTextures(1, &name);
        glBindTexture(GL_TEXTURE_2D, name);
        glTexStorage2D(GL_TEXTURE_2D, 1, format, WIDTH, HEIGHT);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        return name;
    }

    GLuint boxes_, marker_, picture_ = 0, edges_ = 0, framebuffer_ = 0;
};

//! PNG files in a folder, or a video.
class Output
{
public:
    explicit Output(const std::filesystem::path& path) : folder_(path)
    {
        if (path.extension() != ".avi")
            std::filesystem::create_directories(path);
        else if (!video_.open(path.string(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25,
                              cv::Size(WIDTH, HEIGHT)))
            throw std::runtime_error(path.string() + " cannot be written");
    }
    void write(const cv::Mat& frame, int number)
    {
        if (video_.isOpened())
        {
            video_.write(frame);
            return;
        }
        const std::string name = (folder_ / cv::format("frame%03d.png", number)).string();
        if (!cv::imwrite(name, frame))
            throw std::runtime_error(name + " cannot be written");
    }

private:
    std::filesystem::path folder_;
    cv::VideoWriter video_;
};

void run(const std::string& path, int frames)
{
    const Context context;
    std::cout << glGetString(GL_RENDERER) << "\n";
    const Scene scene;
    Output output(path);
    const cv::Ptr<cv::linespace::LineSpaceDetector> detector =
        cv::linespace::LineSpaceDetector::create(50, 40);
    // Of the lines along one edge the strongest; the pixels stay where they are.
    detector->setSuppressionDistance(16);
    double milliseconds = 0;
    std::size_t count = 0;
    for (int frame = 0; frame < frames; ++frame)
    {
        const GLuint edges = scene.draw(0.3f + 0.02f * (float)frame);
        std::vector<cv::Vec3f> lines;
        const int64 begin = cv::getTickCount();
        detector->detectTexture(edges, lines);
        if (frame > 0) // the first one compiles the shaders
            milliseconds += (double)(cv::getTickCount() - begin) * 1e3 / cv::getTickFrequency();
        count += lines.size();
        cv::Mat picture, upright;
        cv::cvtColor(scene.picture(), picture, cv::COLOR_GRAY2BGR);
        cv::linespace::drawLines(picture, lines);
        cv::flip(picture, upright, 0);
        output.write(upright, frame);
    }
    std::cout << frames << " frames, " << count << " lines";
    if (frames > 1)
        std::cout << ", " << cvRound(milliseconds / (frames - 1)) << " ms for the lines of a frame";
    std::cout << "\n";
}

} // namespace

int main(int argc, char** argv)
{
    const cv::CommandLineParser arguments(
        argc, argv,
        "{help h ? | | prints this }"
        "{@output  | | a folder for PNG files, or a video, NAME.avi }"
        "{frames   | 50 | how many, 1 or more }");
    const std::string output = arguments.get<std::string>("@output");
    const int frames = arguments.get<int>("frames");
    if (arguments.has("help"))
    {
        arguments.printMessage();
        return 0;
    }
    if (!arguments.check() || output.empty() || frames < 1)
    {
        arguments.printErrors();
        arguments.printMessage();
        return 2;
    }
    try
    {
        run(output, frames);
    }
    catch (const std::exception& error)
    {
        std::cerr << "linespace_moving_scene: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
