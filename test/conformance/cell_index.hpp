// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Lines by their (rho, theta) cell: which of them are within one cell of a line.

#ifndef LINESPACE_CONFORMANCE_CELL_INDEX_HPP
#define LINESPACE_CONFORMANCE_CELL_INDEX_HPP

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lines.hpp"

namespace conformance {

/** Two lines are within one cell of each other if their rho differ by at most rho and their theta
by at most theta, a thousandth of a cell more allowed for rounding to float. (rho, theta) and (-rho,
theta + pi) are the same line. */
class CellIndex
{
public:
    CellIndex(const Lines& lines, double rho, double theta);

    //! Indices of the lines within one cell of this one, itself included if it is one of them.
    std::vector<int> near(const cv::Vec3f& line) const;

private:
    struct Place
    {
        double rho, theta;
    };
    static Place placeOf(const cv::Vec3f& line);
    std::int64_t keyOf(double rhoCell, double thetaCell) const;
    void addNear(Place place, std::vector<int>& found) const;

    double rho_, theta_;
    std::vector<Place> places_;
    std::unordered_map<std::int64_t, std::vector<int>> cells_;
};

} // namespace conformance

#endif // LINESPACE_CONFORMANCE_CELL_INDEX_HPP
