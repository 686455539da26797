// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What the program says to a person.

#ifndef LINESPACE_SAMPLES_TEXT_HPP
#define LINESPACE_SAMPLES_TEXT_HPP

#include <exception>
#include <string>

namespace program {

struct Found;

//! printf into a string.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

//! Why something failed, in one line without file names of source code.
std::string reasonOf(const std::exception& error);

//! "house.jpg: 640 x 480, 9123 edge pixels, 12 lines in 3.4 ms (cpu)"
std::string summary(const Found& found);

//! The strongest lines, one a row, with a head.
std::string table(const Found& found, std::size_t maxRows);

} // namespace program

#endif // LINESPACE_SAMPLES_TEXT_HPP
