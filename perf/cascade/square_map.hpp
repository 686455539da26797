// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A square edge map with its exact votes and strongest lines: what the naive cascade is compared
// with. The frame is the image for every cell size, so that chords have the same numbers.

#ifndef LINESPACE_CASCADE_SQUARE_MAP_HPP
#define LINESPACE_CASCADE_SQUARE_MAP_HPP

#include "inputs.hpp"
#include "naive_cascade.hpp"
#include "pipeline.hpp"

namespace cascade {

constexpr int SQUARE_SIZE = 256; //!< pixels

struct SquareMap
{
    Source source;
    int threshold;               //!< votes
    cv::Mat1w voters;            //!< see directions.hpp
    cv::Mat1i exact;             //!< votes
    std::vector<cv::Vec4f> ends; //!< of the strongest lines of the exact table

    SquareMap(const Input& input, bool oriented);

    cv::Size size() const { return voters.size(); }
    //! How many of those lines are found in a table of votes.
    int countFound(const PipelineResult& result) const;
    PipelineParameters parameters() const { return {threshold, 0.75}; }
};

/** Compares the naive code with the module, tolerance 0: the cascade's table for all cell sizes, the
exact table, and the lines of an oriented map. Throws std::runtime_error if it differs. */
void requireModulesVotes();

} // namespace cascade

#endif // LINESPACE_CASCADE_SQUARE_MAP_HPP
