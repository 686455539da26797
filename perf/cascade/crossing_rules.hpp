// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What other rules of the crossing would give: votes beside the exact ones, lines, cost.

#ifndef LINESPACE_CASCADE_CROSSING_RULES_HPP
#define LINESPACE_CASCADE_CROSSING_RULES_HPP

#include "inputs.hpp"

#include <ostream>
#include <vector>

namespace cascade {

//! Compares the naive cascade with LineSpaceDetector::compute, tolerance 0; throws
//! std::runtime_error at the first vote that differs.
void requireShippedRule();

/** Tables over rules and cell sizes.
@param inputs edge maps of RULE_SIZE x RULE_SIZE pixels.
@param csv one row for each image, rule and cell size. */
void writeCrossingRules(std::ostream& out, std::ostream& csv, const std::vector<Input>& inputs);

constexpr int RULE_SIZE = 256; //!< pixels

} // namespace cascade

#endif // LINESPACE_CASCADE_CROSSING_RULES_HPP
