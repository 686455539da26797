// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Exact votes of a chord and its neighbours (doc/algorithm.md, section 5): the edge pixels around
// the chord are read once, as bits, and every chord near it is counted from these.

#ifndef OPENCV_LINESPACE_CHORD_BAND_HPP
#define OPENCV_LINESPACE_CHORD_BAND_HPP

#include "../edge_planes.hpp"

namespace cv {
namespace linespace {

/** Columns of pixels around a line, along its major axis: bit b of word i is the pixel starts[i] + b
of column first + i. */
struct BandWords
{
    const ushort* words;
    const short* starts;
    int first, count;
};

/** The votes of a chord whose pixels are all in the band, by columns side by side.
@param raster of the chord, of a modulus below 2^15. */
int countInBand(const BandWords& band, const Raster& raster);

//! The band around one chord, for the pixels that vote for one bin.
class ChordBand
{
public:
    enum
    {
        HEIGHT = 16, //!< pixels of a column
        REACH = 6    //!< border points between the ends of the chord and of one that is counted
    };
    ChordBand() : isRead_(false), bin_(0) {}

    //! Reads the pixels around a chord of the frame that vote for a bin, of a map that is not
    //! oriented all. The planes must outlive it.
    void read(const EdgePlanes& planes, Chord chord, int bin);
    bool isFor(int bin) const { return isRead_ && bin_ == bin; }
    bool isRead() const { return isRead_; }
    void forget() { isRead_ = false; }

    /** The votes of a chord, whose ends are within REACH border points of those of the one that was
    read, on the ring.
    @return false if the band does not hold them. */
    bool count(const Raster& raster, int& votes) const;

private:
    bool isRead_;
    int bin_;
    bool xMajor_;
    int first_, count_;
    std::vector<ushort> words_;
    std::vector<short> starts_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CHORD_BAND_HPP
