// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "climb.hpp"

#include "../chord_counter.hpp"
#include "../orientation.hpp"

namespace cv {
namespace linespace {

namespace {

const int UNKNOWN = -2;

} // namespace

Climber::Climber(const EdgePlanes& planes, bool isReference)
    : planes_(planes), isReference_(isReference), frame_(planes.frame()),
      points_(frame_.borderCount()), middle_()
{
}

void Climber::startAt(Chord chord)
{
    middle_ = chord;
    std::fill(&votes_[0][0], &votes_[0][0] + SIDE * SIDE, UNKNOWN);
    bands_[0].forget();
    bands_[1].forget();
}

int Climber::count(Chord chord)
{
    const int bin = planes_.isOriented() ? directionBin(frame_, chord) : 0;
    int votes = 0;
    if (!isReference_ && !planes_.isWeighted())
    {
        // Chords near each other have two bins at most.
        ChordBand& band = bands_[bands_[0].isFor(bin) || !bands_[0].isRead() ? 0 : 1];
        if (!band.isFor(bin))
            band.read(planes_, middle_, bin);
        if (band.count(Raster(frame_, chord), votes))
            return votes;
    }
    return ChordCounter(planes_).votes(chord);
}

Candidate Climber::at(int i, int j)
{
    int s = middle_.s + i, e = middle_.e + j;
    s += s < 0 ? points_ : s >= points_ ? -points_ : 0;
    e += e < 0 ? points_ : e >= points_ ? -points_ : 0;
    Candidate result = {-1, std::min(s, e), std::max(s, e)};
    int& votes = votes_[i + SPAN][j + SPAN];
    if (votes == UNKNOWN)
        votes = frame_.isChord(result.s, result.e) ? count(result.chord()) : -1;
    result.votes = votes;
    return result;
}

Candidate Climber::climb(Chord chord)
{
    const int radius = mostRadius(frame_, RADIUS);
    startAt(chord);
    int i = 0, j = 0;
    Candidate maximum = at(0, 0);
    for (;;)
    {
        int nextI = i, nextJ = j;
        for (int di = -radius; di <= radius; ++di)
            for (int dj = -radius; dj <= radius; ++dj)
            {
                const Candidate other = at(i + di, j + dj);
                if (isStronger(other, maximum))
                {
                    maximum = other;
                    nextI = i + di;
                    nextJ = j + dj;
                }
            }
        if (nextI == i && nextJ == j)
            return maximum;
        i = nextI;
        j = nextJ;
        if (std::max(std::abs(i), std::abs(j)) > SPAN - RADIUS)
        {
            startAt(maximum.chord());
            i = j = 0;
            votes_[SPAN][SPAN] = maximum.votes;
        }
    }
}

} // namespace linespace
} // namespace cv
