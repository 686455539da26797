// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "acontrario.hpp"

namespace cv {
namespace linespace {

namespace {

//! Of an edge pixel along a chord, that the next one is one too; doc/algorithm.md, section 7, says
//! what it is in edge maps of images without lines.
const double PERSISTENCE = 0.75;

/** P(v or more edge pixels among the next l of a chain), for all v, by whether the pixel before
these is an edge pixel; l grows by one at a time. */
class Tails
{
public:
    Tails(int maxLength, double density, double negligible)
        : inside_(density), persistence_(std::max(density, PERSISTENCE)),
          begin_(density * (1 - persistence_) / (1 - density)), negligible_(negligible), top_(0),
          afterNone_(maxLength + 2, 0.), afterEdge_(maxLength + 2, 0.)
    {
        afterNone_[0] = afterEdge_[0] = 1;
    }

    void lengthen()
    {
        double *none = afterNone_.data(), *edge = afterEdge_.data();
        for (int v = ++top_; v > 0; --v)
        {
            const double staysOut = none[v], comesIn = edge[v - 1];
            none[v] = (1 - begin_) * staysOut + begin_ * comesIn;
            edge[v] = (1 - persistence_) * staysOut + persistence_ * comesIn;
        }
        while (top_ > 0 && edge[top_] < negligible_) // the larger one; spares most of the work
        {
            none[top_] = edge[top_] = 0;
            --top_;
        }
    }

    double at(int votes) const
    {
        return (1 - inside_) * afterNone_[votes] + inside_ * afterEdge_[votes];
    }

private:
    const double inside_, persistence_, begin_, negligible_;
    int top_; //!< beyond it all is 0
    std::vector<double> afterNone_, afterEdge_;
};

} // namespace

std::vector<int> significantVotes(int maxLength, double density, double tests, double falseAlarms)
{
    std::vector<int> votes(maxLength + 1);
    if (tests < falseAlarms) // so many chords do not alarm so often
        return votes;
    if (density >= 1)
    {
        for (int length = 0; length <= maxLength; ++length)
            votes[length] = length + 1;
        return votes;
    }
    const double chance = falseAlarms / tests;
    Tails tails(maxLength, density, chance * 1e-12);
    int least = 0;
    for (int length = 0; length <= maxLength; ++length)
    {
        if (length > 0)
            tails.lengthen();
        while (least <= length && tails.at(least) >= chance)
            ++least;
        votes[length] = least;
    }
    return votes;
}

} // namespace linespace
} // namespace cv
