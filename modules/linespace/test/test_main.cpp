// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "test_precomp.hpp"

#include "sanitizer_threads.hpp"

CV_TEST_MAIN("cv", opencv_test::useSanitizerThreads())
