// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Which files are written for which input. All names are made and checked before any work, so that
// nothing is overwritten by surprise and no run stops half-way for a bad name.

#ifndef LINESPACE_SAMPLES_NAMING_HPP
#define LINESPACE_SAMPLES_NAMING_HPP

#include <string>
#include <vector>

#include "inputs.hpp"
#include "options.hpp"

namespace program {

//! Empty names: not wanted.
struct OutputNames
{
    std::string annotated;
    std::string lineSpace;
    std::vector<std::string> lineFiles; //!< one for each --lines
};

//! One entry for each input, in its order. Makes the folders. Throws UsageError for a name that
//! cannot serve its inputs, would overwrite an input, or would be written twice.
std::vector<OutputNames> planOutputs(const Options& options, const std::vector<Input>& inputs);

//! Whether one file takes the lines of all inputs: .json or .csv without a *.
bool isSharedLineFile(const std::string& option);

//! ".json", ".csv" or ".svg".
std::string lineFormat(const std::string& path);

//! "road.png", 12 gives "road-000012.png"; a negative frame leaves the name as it is.
std::string numbered(const std::string& path, int frame);

} // namespace program

#endif // LINESPACE_SAMPLES_NAMING_HPP
