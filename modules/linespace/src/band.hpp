// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The pixels along a line of any position, not only of chords (doc/algorithm.md, section 5).

#ifndef OPENCV_LINESPACE_BAND_HPP
#define OPENCV_LINESPACE_BAND_HPP

#include "edge_bits.hpp"
#include "edge_planes.hpp"
#include "line_geometry.hpp"
#include "vectors.hpp"

#include <cmath>

namespace cv {
namespace linespace {

//! Added to distances, so that a pixel exactly as far away is within, however its distance rounds.
const double TIE = 1e-6;

//! Edge pixels within this many pixels of a line support it: half a pixel is the chord's raster,
//! half is that of the edge's own line.
const double SUPPORT_DISTANCE = 1 + TIE;

//! Which edge pixels can support the line of a chord: those that carry the bit of its bin,
//! of a map that is not oriented, all.
class Support
{
public:
    enum
    {
        WINDOW = 16 //!< pixels that are read at once
    };
    static_assert((int)WINDOW <= (int)EdgePlanes::MARGIN, "reads beyond the last pixel of a row");
    Support(const EdgePlanes& planes, int bin, bool xMajor)
        : plane_(planes.across(
              xMajor)[planes.isOriented() ? EdgePlanes::planeOf(bin) : EdgePlanes::VOTES]),
          bits_(planes.isOriented() ? EdgePlanes::bitOf(bin) : 255), edgeBits_(0), xMajor_(xMajor)
    {
    }
    //! Of a map that is not oriented; the bits must outlive it.
    Support(const EdgeBits& bits, bool xMajor) : bits_(0), edgeBits_(&bits), xMajor_(xMajor) {}
    //! Bit b is that of pixel k + b of column i.
    int at(int i, int k) const
    {
        if (edgeBits_)
            return edgeBits_->at(xMajor_, i, k);
        const uchar* const pixels = plane_.row(i) + k;
#if LINESPACE_SIMD128
        const v_uint8x16 own = v_and(v_load(pixels), v_setall_u8(bits_));
        return v_signmask(v_ne(own, v_setzero_u8()));
#else
        int mask = 0;
        for (int b = 0; b < WINDOW; ++b)
            mask |= ((pixels[b] & bits_) != 0) << b;
        return mask;
#endif
    }

private:
    EdgePlanes::Plane plane_;
    uchar bits_;
    const EdgeBits* edgeBits_; //!< null: the plane
    bool xMajor_;
};

/** The columns of an image that a line passes, or its rows if it is steeper than a diagonal: steps
along the major axis. */
struct Columns
{
    bool xMajor;
    int length, limit;        //!< pixels of the image along the major and along the minor axis
    double major, minor, rho; //!< i * major + k * minor = rho on the line, |minor| >= sqrt(1/2)

    Columns(Size image, const Line& line) : rho(line.rho)
    {
        const double cosine = std::cos(line.theta), sine = std::sin(line.theta);
        xMajor = std::abs(sine) >= std::abs(cosine);
        major = xMajor ? cosine : sine;
        minor = xMajor ? sine : cosine;
        length = xMajor ? image.width : image.height;
        limit = xMajor ? image.height : image.width;
    }
    //! Where the line passes column i.
    double centre(int i) const { return (rho - i * major) / minor; }
    //! Signed distance of pixel k of column i from the line.
    double distance(int i, int k) const { return i * major + k * minor - rho; }

    //! Those columns of the image where pixels of the image are within a distance of the line, and
    //! maybe one more at either end.
    Range within(double distance) const
    {
        if (major == 0)
            return Range(0, length);
        const double margin = distance + std::abs(minor);
        const double a = (rho - margin) / major, b = (rho + margin) / major,
                     shift = limit * minor / major;
        const double first = std::min(std::min(a, b), std::min(a, b) - shift),
                     last = std::max(std::max(a, b), std::max(a, b) - shift);
        return Range((int)std::min(std::max(first, 0.), (double)length),
                     (int)std::min(std::max(last + 1, 0.), (double)length));
    }

    enum
    {
        RUN = 64 //!< columns that are looked at together, a multiple of 4
    };

    //! The first pixel of the image within a distance of the line along a column, and how many
    //! there are, of RUN columns at most; of the rest of four as well.
    void rowsAround(int start, int count, double along, int* firsts, int* widths) const
    {
#if LINESPACE_SIMD128_64F
        const v_float64x2 rhos = v_setall_f64(rho), majors = v_setall_f64(major),
                          minors = v_setall_f64(minor), reach = v_setall_f64(along);
        const v_int32x4 none = v_setzero_s32(), one = v_setall_s32(1), end = v_setall_s32(limit);
        for (int j = 0; j < count; j += 4)
        {
            v_int32x4 first[2], last[2];
            for (int k = 0; k < 2; ++k)
            {
                const v_float64x2 columns(start + j + 2 * k, start + j + 2 * k + 1);
                const v_float64x2 rest = v_sub(rhos, v_mul(columns, majors)),
                                  middle = v_div(rest, minors); // as centre()
                first[k] = v_ceil(v_sub(middle, reach));
                last[k] = v_floor(v_add(middle, reach));
            }
            const v_int32x4 from = v_max(none, v_combine_low(first[0], first[1])),
                            to = v_min(end, v_add(v_combine_low(last[0], last[1]), one));
            v_store(firsts + j, from);
            v_store(widths + j, v_max(none, v_sub(to, from)));
        }
#else
        for (int j = 0; j < count; ++j)
        {
            const double middle = centre(start + j);
            firsts[j] = std::max(0, cvCeil(middle - along));
            widths[j] = std::max(0, std::min(limit, cvFloor(middle + along) + 1) - firsts[j]);
        }
#endif
    }

    /** Calls visit(i, k, mask) for the columns with supporting pixels within a distance of the
    line: bit b of the mask is that of pixel k + b of column i. */
    template<class Visit>
    void forEachWithin(double distance, const Support& support, Visit visit) const
    {
        const double along = distance / std::abs(minor);
        CV_DbgAssert(2 * along < Support::WINDOW - 1);
        const Range range = within(distance);
        // What a column holds is hard to guess: first all are looked at without a branch, in short
        // runs, then those are visited that hold something.
        int firsts[RUN], widths[RUN], masks[RUN], filled[RUN];
        for (int start = range.start; start < range.end; start += RUN)
        {
            const int count = std::min<int>(RUN, range.end - start);
            int visits = 0;
            rowsAround(start, count, along, firsts, widths);
            for (int j = 0; j < count; ++j)
            {
                masks[j] =
                    support.at(start + j, std::min(firsts[j], limit - 1)) & ((1 << widths[j]) - 1);
                filled[visits] = j;
                visits += masks[j] != 0;
            }
            for (int v = 0; v < visits; ++v)
                visit(start + filled[v], firsts[filled[v]], masks[filled[v]]);
        }
    }
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_BAND_HPP
