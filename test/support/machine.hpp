// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Where and from which sources a table of results came, for its heading.

#ifndef LINESPACE_SUPPORT_MACHINE_HPP
#define LINESPACE_SUPPORT_MACHINE_HPP

#include <string>

namespace support {

//! Cores, processor, operating system, version of OpenCV.
std::string machine();

//! The commit of the sources that this program was built from, with a mark if files were changed;
//! "unknown commit" without git.
std::string commit();

//! The command line as it was typed, without the program's folder.
std::string commandLine(int argc, const char* const* argv);

} // namespace support

#endif // LINESPACE_SUPPORT_MACHINE_HPP
