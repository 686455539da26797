// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The edge pixels of a map as bits, as a device packs them: a quarter of the map's bytes, with both
// axes.

#ifndef OPENCV_LINESPACE_EDGE_BITS_HPP
#define OPENCV_LINESPACE_EDGE_BITS_HPP

#include "plan.hpp"

namespace cv {
namespace linespace {

/** Which pixels of a frame are edge pixels, in columns along each of the two axes:
[axis][column][word], first for lines with the major axis x, where a column is one of the frame's, then
for the others, where it is a row; bit b of word MARGIN + w is that of pixel 32 w + b across. The words
before and after are 0. */
class EdgeBits
{
public:
    enum
    {
        MARGIN = 2,      //!< words before a column's pixels
        MARGIN_AFTER = 3 //!< and after
    };
    EdgeBits() {}
    //! Words of a column of so many pixels.
    static int wordsOf(int length) { return (length + 31) / 32 + MARGIN + MARGIN_AFTER; }
    //! Words of all.
    static double wordsOf(const Cell& frame)
    {
        return (double)frame.width * wordsOf(frame.height) +
               (double)frame.height * wordsOf(frame.width);
    }

    //! Makes room for a frame, where the caller writes the words. Memory is kept from call to call.
    unsigned* create(const Cell& frame)
    {
        frame_ = frame;
        words_.resize((size_t)wordsOf(frame));
        return words_.data();
    }
    void clear() { std::vector<unsigned>().swap(words_); }

    //! How many edge pixels there are.
    int count() const
    {
        int pixels = 0; // of one axis
        for (int x = 0; x < frame_.width; ++x)
            for (int y = 0; y < frame_.height; y += 16)
                for (int bits = at(true, x, y); bits; bits &= bits - 1)
                    ++pixels;
        return pixels;
    }

    /** Pixels of one column: bit b is that of pixel k + b, b < 16.
    @param column along the major axis.
    @param k at least -64, at most the number of pixels across. */
    int at(bool xMajor, int column, int k) const
    {
        const size_t words = wordsOf(xMajor ? frame_.height : frame_.width);
        const size_t start = xMajor ? 0 : (size_t)frame_.width * wordsOf(frame_.height);
        const int place = k + 32 * MARGIN;
        const unsigned* const word = &words_[start + column * words + place / 32];
        return (int)((word[0] | (uint64)word[1] << 32) >> place % 32 & 0xffff);
    }

private:
    Cell frame_;
    std::vector<unsigned> words_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_EDGE_BITS_HPP
