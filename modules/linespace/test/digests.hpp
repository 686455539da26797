// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the CPU path computes for images of its own, in few lines of text that are the same where
// every bit is.

#ifndef OPENCV_LINESPACE_TEST_DIGESTS_HPP
#define OPENCV_LINESPACE_TEST_DIGESTS_HPP

#include <iosfwd>

namespace opencv_test {

/** One line per array: image, what, digest. The images are made by integers alone, so that another
processor has the same. */
void writeDigests(std::ostream& out);

} // namespace opencv_test

#endif // OPENCV_LINESPACE_TEST_DIGESTS_HPP
