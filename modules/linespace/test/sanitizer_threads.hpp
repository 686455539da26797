// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#ifndef OPENCV_LINESPACE_TEST_SANITIZER_THREADS_HPP
#define OPENCV_LINESPACE_TEST_SANITIZER_THREADS_HPP

namespace opencv_test {

//! In a build with the thread sanitizer, runs cv::parallel_for_ on threads that it can see; else
//! nothing.
void useSanitizerThreads();

} // namespace opencv_test

#endif // OPENCV_LINESPACE_TEST_SANITIZER_THREADS_HPP
