// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// METHOD_STRIPS on the host (doc/algorithm.md, section 3b): from an edge map to the chords of strips
// with many votes. strip_candidates.hpp goes on from these.

#ifndef OPENCV_LINESPACE_STRIP_SEARCH_HPP
#define OPENCV_LINESPACE_STRIP_SEARCH_HPP

#include "../edge_planes.hpp"
#include "strip_kernels.hpp"

namespace cv {
namespace linespace {

//! A chord of a family with the votes that the cascade gives it.
struct StripChord
{
    int votes, family, t, y;
};

//! The total order of these chords: votes descending, then family, t and y ascending.
inline bool precedes(const StripChord& a, const StripChord& b)
{
    return a.votes != b.votes     ? a.votes > b.votes
           : a.family != b.family ? a.family < b.family
           : a.t != b.t           ? a.t < b.t
                                  : a.y < b.y;
}

//! A square of chords, of T and Y as in BundleGrid, and the most votes that one of them may have.
struct Bundle
{
    int votes, family, T, Y;
};

//! What is asked of the search; nothing in it depends on threads or on the back end.
struct StripRequest
{
    int threshold;     //!< chords with more votes than this are of interest
    size_t bundles;    //!< of the whole image that are looked into
    size_t subBundles; //!< of side FINE_BUNDLE
    int square;        //!< side of the squares of chords of which the strongest is found: 2 or 4
    //! For chords of a family that see so many columns of the image, how many votes are of interest;
    //! empty: any that are more than the threshold.
    std::vector<int> leastVotes[2];
    //! The rows T of bundles of side LEAF_BUNDLE that are of interest in each family, from start to
    //! end - 1.
    Range slopes[2];
};

/** Counts strips and finds the chords with the most votes; keeps its memory from call to call.
Votes: uchar, or ushort for a map with weights. */
template<class Votes>
class StripSearch
{
public:
    StripSearch() : side_(0) {}

    /** The strongest chord of each square of the bundles with the most votes; by votes, those
    with equal ones in no particular order. */
    void find(const EdgePlanes& planes, Size image, const StripRequest& request,
              const StripKernels<Votes>& kernels, const BundleKernels& bundles,
              std::vector<StripChord>& found);

    const StripFamily& family(int k) const { return tables_[k].family; }
    void clear();
    //! Bytes that find() allocates for an image, but for lists.
    static double memory(Size image);

private:
    //! What is kept of one family.
    struct Tables
    {
        StripFamily family;
        Buffer kept, leaves, nodes;
        std::vector<StripRows<Votes>> strips;
        std::vector<LeafRows> leafRows;
        //! By t from -width() on, and strip: where the votes of the chord (0, t) stand in `kept`.
        std::vector<int> chordOffsets;
        //! By T of the smallest bundles of the whole image, and strip: where bundle 0 of that row stands
        //! in `leaves`.
        std::vector<int> leafOffsets;
        NodeRows frame;
        //! The fewest columns of the image that a chord at a corner of a bundle sees, for all bundles of
        //! the frame in the order of its rows.
        std::vector<ushort> visible;
    };
    //! What one thread merges a strip in.
    struct Scratch
    {
        Buffer buffer;
        Votes* columns[8];
        StripRows<Votes> rows[4][2]; //!< of 4, 8, 16, 32 columns, left and right halves
    };

    void reset(Size image);
    void resetFamily(Tables& tables, const StripFamily& family);
    void resetScratch(Scratch& scratch, int across) const;
    void countStrip(const EdgePlanes& planes, Tables& tables, int strip,
                    const StripKernels<Votes>& kernels, Scratch& scratch) const;
    void countColumns(const EdgePlanes& planes, const StripFamily& family, int first, int columns,
                      const StripKernels<Votes>& kernels, Scratch& scratch,
                      const StripRows<Votes>& out) const;
    NodeRows build(Tables& tables, const BundleKernels& kernels, int first, int strips, int side,
                   ushort*& memory) const;
    void findVisible(Tables& tables) const;
    void selectBundles(const StripRequest& request);
    void splitBundles(const StripRequest& request, const BundleKernels& kernels);
    void addSubBundles(const Bundle& bundle, const BundleKernels& kernels, int least,
                       std::vector<Bundle>& found) const;
    void addChordsOf(const Bundle& bundle, int side, const StripRequest& request,
                     const StripKernels<Votes>& kernels, std::vector<StripChord>& found) const;

    Size image_;
    int side_; //!< of the bundles of the whole image
    Tables tables_[2];
    std::vector<Bundle> bundles_, split_;
    std::vector<StripChord> chords_;
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_STRIP_SEARCH_HPP
