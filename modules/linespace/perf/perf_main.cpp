// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "perf_precomp.hpp"

// --perf_impl: what perf_implementations.cpp runs.
static const char* implementations[] = {"plain", "opencl", "opengl"};

CV_PERF_TEST_MAIN_WITH_IMPLS(linespace, implementations)
