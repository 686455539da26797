// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From the arguments of the command line to the list of files to read: folders and patterns
// unfolded.

#ifndef LINESPACE_SAMPLES_INPUTS_HPP
#define LINESPACE_SAMPLES_INPUTS_HPP

#include <string>
#include <vector>

namespace program {

struct Input
{
    std::string path;
    std::string error; //!< why there is nothing to read; empty if there may be
};

//! Keeps the order of the arguments; the files of one folder or pattern are sorted by name.
std::vector<Input> expandInputs(const std::vector<std::string>& arguments);

//! By the extension; a name does not tell whether the content can be read.
bool isImageName(const std::string& path);
bool isVideoName(const std::string& path);

} // namespace program

#endif // LINESPACE_SAMPLES_INPUTS_HPP
