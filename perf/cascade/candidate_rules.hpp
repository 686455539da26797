// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What other choices of candidates and of their ascent by exact votes would bring back, on the
// module's cascade with cells of 8 pixels.

#ifndef LINESPACE_CASCADE_CANDIDATE_RULES_HPP
#define LINESPACE_CASCADE_CANDIDATE_RULES_HPP

#include "square_map.hpp"

#include <ostream>
#include <vector>

namespace cascade {

class CandidateRules
{
public:
    CandidateRules();
    void add(const SquareMap& plain, const SquareMap& oriented);
    //! A row for each choice of candidates, ratio and ascent, a column for each pool.
    void write(std::ostream& out) const;
    //! A row for each image and setting.
    void writeCsv(std::ostream& out) const;

private:
    struct PerImage
    {
        Source source;
        bool oriented;
        int exactLines, found;
        std::size_t counted;
    };
    struct Setting
    {
        Candidates candidates;
        double ratio;
        Ascent ascent;
        std::size_t pool;
        std::vector<PerImage> images;
    };
    void addMap(const SquareMap& map, bool oriented);
    static void writeEntry(std::ostream& out, const Setting& setting, bool oriented);

    std::vector<Setting> settings_;
};

} // namespace cascade

#endif // LINESPACE_CASCADE_CANDIDATE_RULES_HPP
