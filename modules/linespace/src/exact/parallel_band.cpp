// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "parallel_band.hpp"

#include "../orientation.hpp"
#include "../vectors.hpp"
#include "pixel_bits.hpp"

namespace cv {
namespace linespace {

namespace {

const int BEFORE = PARALLEL_PIXELS / 2; // pixels before the chord's own
const int MOST_BANDS = 8;               // that are read for one chord

} // namespace

void countParallelsOneByOne(const ParallelColumns& columns, int d, int* votes)
{
    for (int i = 0; i < columns.count; ++i)
    {
        const int64 rest = columns.rests[i] + (int64)d * (2 * (columns.first + i) + 1);
        const int shift =
            PARALLEL_PIXELS / 2 - PARALLEL_REACH + (int)floorDiv(rest, columns.modulus);
        for (int k = 0; k < PARALLELS; ++k)
            votes[k] += columns.words[i] >> (k + shift) & 1;
    }
}

void ParallelClimber::read(const StripFamily& family, int y, int t)
{
    y_ = y;
    t_ = t;
    std::fill(isCounted_, isCounted_ + 2 * MOST_TURN + 1, false);
    modulus_ = 2 * family.width();
    // Columns where the chord is within BEFORE pixels of the image.
    const int64 run = modulus_, above = -BEFORE - y, below = family.across + BEFORE - y;
    int64 first = 0, last = family.length;
    if (t != 0)
    {
        const int64 down = t > 0 ? above : -below, up = t > 0 ? below : -above;
        first = std::max(first, std::min(last, floorDiv(down * run, 2 * std::abs(t))));
        last = std::max(first, std::min(last, floorDiv(up * run, 2 * std::abs(t))));
    }
    else if (above > 0 || below < 0)
        last = 0;
    first_ = (int)first;
    count_ = (int)(last - first);
    words_.resize(count_ + ParallelColumns::SPARE);
    rests_.resize(count_ + ParallelColumns::SPARE);
    const int bin = !planes_.isOriented() ? 0
                    : family.xMajor       ? directionBin(family.width(), t)
                                          : directionBin(t, family.width());
    const EdgePlanes::Plane& plane = planes_.across(
        family.xMajor)[planes_.isOriented() ? EdgePlanes::planeOf(bin) : EdgePlanes::VOTES];
    const uchar bits = planes_.isOriented() ? EdgePlanes::bitOf(bin) : 255;
    // Positions in units of 2^-32 pixels, rounded up: the sum of the errors is less than the exact
    // position's distance to the next integer, 1 / run at least, as count run < 2^32.
    const int64 one = (int64)1 << 32;
    const int64 start = run / 2 + (int64)t * (2 * first_ + 1), step = ceilDiv(2 * t * one, run);
    const int64 whole = floorDiv(start, run);
    int64 position = (y + whole - BEFORE) * one + ceilDiv((start - whole * run) * one, run);
    for (int i = 0; i < count_; ++i, position += step)
    {
        const int pixel = (int)(position >> 32);
        rests_[i] = (ushort)((position & (one - 1)) * run >> 32);
        const bool isInside = pixel > -PARALLEL_PIXELS && pixel < family.across;
        words_[i] = (ushort)(isInside ? readPixelBits(plane.row(first_ + i) + pixel, bits) : 0);
    }
    std::fill(words_.begin() + count_, words_.end(), (ushort)0);
    std::fill(rests_.begin() + count_, rests_.end(), (ushort)0);
}

int ParallelClimber::votes(int i, int d)
{
    int* const row = votes_[d + MOST_TURN];
    if (!isCounted_[d + MOST_TURN])
    {
        isCounted_[d + MOST_TURN] = true;
        std::fill(row, row + PARALLELS, 0);
        const ParallelColumns columns = {words_.data(), rests_.data(), first_, count_, modulus_};
        (isReference_ ? countParallelsOneByOne : countParallels)(columns, d, row);
    }
    return row[i + PARALLEL_REACH];
}

int ParallelClimber::climb(const StripFamily& family, int& y, int& t)
{
    read(family, y, t);
    int i = 0, d = 0, best = votes(0, 0);
    for (int bands = 1;;)
    {
        int nextI = i, nextD = d;
        for (int turn = -2; turn <= 2; ++turn)
            for (int k = std::max(-2, -2 - turn); k <= std::min(2, 2 - turn); ++k)
            {
                const int otherI = i + k, otherD = d + turn;
                if (std::abs(otherI) > PARALLEL_REACH || std::abs(otherD) > MOST_TURN)
                    continue;
                const int count = votes(otherI, otherD);
                if (count > best)
                {
                    best = count;
                    nextI = otherI;
                    nextD = otherD;
                }
            }
        if (nextI == i && nextD == d)
        {
            // The bin, and with it the votes, may change from one band to the next, so that a climb
            // could go round in circles: the number of bands is limited.
            if ((std::abs(i) <= 1 && std::abs(d) <= 2) || bands == MOST_BANDS)
                break;
            // Its neighbours are not all in the band.
            ++bands;
            read(family, y_ + i, t_ + d);
            i = d = 0;
            best = votes(0, 0);
            continue;
        }
        i = nextI;
        d = nextD;
    }
    y = y_ + i;
    t = t_ + d;
    return best;
}

} // namespace linespace
} // namespace cv
