// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "chord_band.hpp"

#include "pixel_bits.hpp"

#include <climits>

namespace cv {
namespace linespace {

namespace {

const int OVERHANG = ChordBand::REACH + 1; // columns before and behind the chord's own
const int BEFORE = ChordBand::HEIGHT / 2;  // pixels of a column before the chord's own
const int SHORTEST = 32;                   // columns of a chord that is worth a band
const int SPARE = 64;                      // words behind the last one, which vectors may read

} // namespace

void ChordBand::read(const EdgePlanes& planes, Chord chord, int bin)
{
    const Cell& frame = planes.frame();
    const Raster raster(frame, chord);
    isRead_ = true;
    bin_ = bin;
    xMajor_ = raster.xMajor;
    count_ = 0;
    if (raster.count < SHORTEST || raster.modulus > SHRT_MAX)
        return;
    const int length = xMajor_ ? frame.width : frame.height,
              across = xMajor_ ? frame.height : frame.width;
    first_ = std::max(0, raster.first - OVERHANG);
    count_ = std::min(length, raster.first + raster.count + OVERHANG) - first_;
    words_.resize(count_ + SPARE);
    starts_.resize(count_ + SPARE);
    const EdgePlanes::Plane& plane =
        planes.across(xMajor_)[planes.isOriented() ? EdgePlanes::planeOf(bin) : EdgePlanes::VOTES];
    const uchar bits = planes.isOriented() ? EdgePlanes::bitOf(bin) : 255;
    // The columns beyond the chord's own are a few of the line's pixels more.
    int64 position, step;
    raster.fixedPoint(position, step);
    position -= (raster.first - first_) * step;
    for (int i = 0; i < count_; ++i, position += step)
    {
        // Where the line has left the frame, the pixels nearest to it are read.
        const int minor = (int)(position >> 32),
                  start = std::max(-BEFORE, std::min(minor, across) - BEFORE);
        starts_[i] = (short)start;
        words_[i] = (ushort)readPixelBits(plane.row(first_ + i) + start, bits);
    }
    for (int i = count_; i < count_ + SPARE; ++i)
    {
        words_[i] = 0;
        starts_[i] = 0;
    }
}

bool ChordBand::count(const Raster& raster, int& votes) const
{
    if (count_ == 0 || raster.xMajor != xMajor_ || raster.modulus > SHRT_MAX ||
        raster.first < first_ || raster.first + raster.count > first_ + count_)
        return false;
    const BandWords band = {words_.data(), starts_.data(), first_, count_};
    votes = countInBand(band, raster);
    return true;
}

} // namespace linespace
} // namespace cv
