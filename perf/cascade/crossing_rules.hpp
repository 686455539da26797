// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What other rules of the crossing would give: votes beside the exact ones, lines, cost.

#ifndef LINESPACE_CASCADE_CROSSING_RULES_HPP
#define LINESPACE_CASCADE_CROSSING_RULES_HPP

#include "square_map.hpp"

#include <ostream>
#include <vector>

namespace cascade {

//! Rules and cell sizes over all images that were added.
class CrossingRules
{
public:
    CrossingRules();
    //! @param map not oriented
    void add(const SquareMap& map);
    //! A row for each rule and cell size.
    void write(std::ostream& out) const;
    //! A row for each image, rule and cell size.
    void writeCsv(std::ostream& out) const;

private:
    struct PerImage
    {
        Source source;
        std::size_t chords;
        double meanRatio;
        int exactLines, foundSimply, foundByAscent;
    };
    struct Setting
    {
        CrossingRule rule;
        int cellSize;
        MergeCost cost;
        std::vector<float> ratios; //!< of the cascade's votes to the exact ones
        std::vector<PerImage> images;
    };
    static void writeRow(std::ostream& out, const Setting& setting);

    std::vector<Setting> settings_;
};

} // namespace cascade

#endif // LINESPACE_CASCADE_CROSSING_RULES_HPP
