// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The chords of a cell of level 0 as lists of pixels, in the order in which the CPU path counts
// them.

#ifndef OPENCV_LINESPACE_CELL_CHORDS_HPP
#define OPENCV_LINESPACE_CELL_CHORDS_HPP

#include "orientation.hpp"

namespace cv {
namespace linespace {

class CellChords
{
public:
    CellChords() : isSorted_(false) {}

    /** Lists the chords of a cell, unless that was the last one.
    @param byBins those of one direction bin after the other; else by their indices. */
    void reset(const Cell& cell, bool byBins)
    {
        if (cell_.width == cell.width && cell_.height == cell.height && isSorted_ == byBins)
            return;
        cell_ = cell;
        isSorted_ = byBins;
        chords_.clear();
        for (int s = 0; s < cell.firstPoint(SIDE_LEFT); ++s)
            for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e)
            {
                const Chord chord = {s, e};
                const Entry entry = {chord, byBins ? directionBin(cell, chord) : 0};
                chords_.push_back(entry);
            }
        std::stable_sort(chords_.begin(), chords_.end(),
                         [](const Entry& a, const Entry& b) { return a.bin < b.bin; });
        // Cells of usual size have few chords; those of large ones are cheap to find again beside
        // counting them.
        pixels_.clear();
        if (chords_.size() * longest() <= MOST_LISTED)
        {
            pixels_.resize(chords_.size() * (longest() + 1));
            for (size_t i = 0; i < chords_.size(); ++i)
                listPixels(i, &pixels_[i * (longest() + 1)]);
        }
    }

    size_t count() const { return chords_.size(); }
    size_t indexOf(size_t i) const
    {
        return cell_.chordIndex(chords_[i].chord.s, chords_[i].chord.e);
    }
    int binOf(size_t i) const { return chords_[i].bin; }

    /** The pixels of the i-th chord, as y width + x.
    @param buffer of longest() + 1 elements, where they may be written to.
    @param count of the pixels. */
    const ushort* pixels(size_t i, ushort* buffer, int& count) const
    {
        const ushort* list = buffer;
        if (pixels_.empty())
            listPixels(i, buffer);
        else
            list = &pixels_[i * (longest() + 1)];
        count = list[0];
        return list + 1;
    }
    //! Most pixels of a chord.
    size_t longest() const { return std::max(cell_.width, cell_.height); }

private:
    enum
    {
        MOST_LISTED = 1 << 18
    };
    struct Entry
    {
        Chord chord;
        int bin;
    };

    //! Their number first.
    void listPixels(size_t i, ushort* list) const
    {
        int n = 0;
        Raster(cell_, chords_[i].chord)
            .forEachPixel([&](int x, int y) { list[++n] = (ushort)(y * cell_.width + x); });
        list[0] = (ushort)n;
    }

    Cell cell_;
    bool isSorted_;
    std::vector<Entry> chords_;
    std::vector<ushort> pixels_; //!< longest() + 1 for each chord; empty: none are kept
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_CELL_CHORDS_HPP
