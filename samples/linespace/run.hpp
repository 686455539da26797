// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// One run of the program: every input in turn, the outputs of each, and what is said about it.

#ifndef LINESPACE_SAMPLES_RUN_HPP
#define LINESPACE_SAMPLES_RUN_HPP

#include "options.hpp"

namespace program {

//! Returns the exit status. Throws UsageError before any work if the options do not fit the inputs.
int run(const Options& options);

} // namespace program

#endif // LINESPACE_SAMPLES_RUN_HPP
