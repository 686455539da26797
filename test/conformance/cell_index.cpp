// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "cell_index.hpp"

#include <cmath>

namespace conformance {

CellIndex::CellIndex(const Lines& lines, double rho, double theta)
    : rho_(rho * 1.001), theta_(theta * 1.001)
{
    for (const cv::Vec3f& line : lines)
    {
        const Place place = placeOf(line);
        cells_[keyOf(std::floor(place.rho / rho_), std::floor(place.theta / theta_))].push_back(
            static_cast<int>(places_.size()));
        places_.push_back(place);
    }
}

//! The same line with theta in [0, pi).
CellIndex::Place CellIndex::placeOf(const cv::Vec3f& line)
{
    const double halfTurns = std::floor(line[1] / CV_PI);
    const bool isMirrored = std::fmod(std::abs(halfTurns), 2) == 1;
    return {isMirrored ? -line[0] : line[0], line[1] - halfTurns * CV_PI};
}

std::int64_t CellIndex::keyOf(double rhoCell, double thetaCell) const
{
    return (static_cast<std::int64_t>(thetaCell) << 32) ^
           (static_cast<std::int64_t>(rhoCell) & 0xffffffff);
}

void CellIndex::addNear(Place place, std::vector<int>& found) const
{
    const double rhoCell = std::floor(place.rho / rho_);
    const double thetaCell = std::floor(place.theta / theta_);
    for (int t = -1; t <= 1; ++t)
        for (int r = -1; r <= 1; ++r)
        {
            const auto cell = cells_.find(keyOf(rhoCell + r, thetaCell + t));
            if (cell == cells_.end())
                continue;
            for (int i : cell->second)
                if (std::abs(places_[i].rho - place.rho) <= rho_ &&
                    std::abs(places_[i].theta - place.theta) <= theta_)
                    found.push_back(i);
        }
}

std::vector<int> CellIndex::near(const cv::Vec3f& line) const
{
    std::vector<int> found;
    const Place place = placeOf(line);
    addNear(place, found);
    // Near the ends of [0, pi) the neighbours are at the other end too, mirrored.
    if (place.theta <= theta_)
        addNear({-place.rho, place.theta + CV_PI}, found);
    if (place.theta >= CV_PI - theta_)
        addNear({-place.rho, place.theta - CV_PI}, found);
    return found;
}

} // namespace conformance
