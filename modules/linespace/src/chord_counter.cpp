// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "chord_counter.hpp"

namespace cv {
namespace linespace {

namespace {

//! The pixels of a raster inside the image: as the minor coordinate is monotone, they are one run.
Range insideImage(const Raster& raster, int64 start, int64 increment, Size image)
{
    const int majorLimit = raster.xMajor ? image.width : image.height,
              minorLimit = raster.xMajor ? image.height : image.width;
    const auto isOutside = [&](int i)
    {
        return (start + i * increment) >> 32 >= minorLimit;
    };
    Range inside(0, std::max(0, std::min(raster.count, majorLimit - raster.first)));
    while (inside.start < inside.end && isOutside(inside.start))
        ++inside.start;
    while (inside.start < inside.end && isOutside(inside.end - 1))
        --inside.end;
    return inside;
}

//! The sum of vote(index of the pixel in its rows) over a run of a raster.
template<class Vote>
int sumRun(const Raster& raster, const Range& inside, int64 start, int64 increment, int rowLength,
           Vote vote)
{
    int sum = 0;
    size_t column = raster.first + inside.start;
    int64 row = start + inside.start * increment;
    for (int i = inside.start; i < inside.end; ++i, ++column, row += increment)
        sum += vote((size_t)(row >> 32) * rowLength + column);
    return sum;
}

} // namespace

ChordCounter::ChordCounter(const EdgeMap& edges, const Cell& frame) : edges_(edges), frame_(frame)
{
    edges_.votes = edges.votes.clone();
    transpose(edges_.votes, votesTransposed_);
    if (edges.isOriented())
    {
        edges_.directions = edges.directions.clone();
        transpose(edges_.directions, directionsTransposed_);
    }
}

int ChordCounter::votes(Chord chord) const
{
    const Raster raster(frame_, chord);
    int64 start, increment;
    if (!raster.fixedPoint(start, increment))
        return chordVotes(edges_, frame_, chord);
    const Range inside = insideImage(raster, start, increment, edges_.votes.size());
    const Mat& voteRows = raster.xMajor ? edges_.votes : votesTransposed_;
    const uchar* const values = voteRows.ptr<uchar>();
    const int rowLength = voteRows.cols;
    if (!edges_.isOriented())
        return sumRun(raster, inside, start, increment, rowLength,
                      [=](size_t pixel) { return values[pixel]; });
    const ushort* const bits =
        (raster.xMajor ? edges_.directions : directionsTransposed_).ptr<ushort>();
    const int bin = directionBin(frame_, chord);
    if (!edges_.weighted) // pixels that do not vote have no bits
        return sumRun(raster, inside, start, increment, rowLength,
                      [=](size_t pixel) { return bits[pixel] >> bin & 1; });
    return sumRun(raster, inside, start, increment, rowLength,
                  [=](size_t pixel) { return (bits[pixel] >> bin & 1) * values[pixel]; });
}

void ChordCounter::remove(Point pixel)
{
    edges_.votes.ptr<uchar>(pixel.y)[pixel.x] = 0;
    votesTransposed_.ptr<uchar>(pixel.x)[pixel.y] = 0;
    if (!edges_.isOriented())
        return;
    edges_.directions.ptr<ushort>(pixel.y)[pixel.x] = 0;
    directionsTransposed_.ptr<ushort>(pixel.x)[pixel.y] = 0;
}

} // namespace linespace
} // namespace cv
