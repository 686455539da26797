// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "perf_precomp.hpp"

#include "../test/test_gl.cpp" // in OpenCV's tree this folder is all that is compiled

// --perf_impl: what perf_implementations.cpp runs.
static const char* implementations[] = {"plain", "opencl", "opengl"};

//! As OpenCV's harness does for OpenCL.
static void tellOpenGl()
{
    const std::string renderer = opencv_test::headlessRenderer();
    std::cout << "[ INFO ] OpenGL: " << renderer << std::endl;
    testing::Test::RecordProperty("cv_opengl", renderer);
}

CV_PERF_TEST_MAIN_WITH_IMPLS(linespace, implementations, tellOpenGl())
