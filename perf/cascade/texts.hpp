// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What doc/cascade.md says before its tables: what is counted and how.

#ifndef LINESPACE_CASCADE_TEXTS_HPP
#define LINESPACE_CASCADE_TEXTS_HPP

namespace cascade {

constexpr const char* LINES_TEXT = R"(
## Lines of the exact method

Of the 100 strongest lines of `METHOD_EXACT`, percent that `METHOD_CASCADED` reports with the same
parameters: one of its 100 lines is within 1.5 pixels of line error, the largest distance from the two
ends of the exact line's chord in the image. Threshold: a tenth of the shorter side; everything else at
the defaults. Oriented: with the Sobel gradients of the image. Each figure is that of all lines of all
images together; in brackets the image with the smallest share. With 100 lines a pool of 1024 is one of
1600 (16 for each line).

)";

constexpr const char* FRAMES_TEXT = R"(### Padded frames

Percent at the defaults, not refined, by whether the cascade's frame is the image or larger; beside it
what `METHOD_EXACT` finds on the image padded to the frame, whose chords are not those of the image: more
than that, votes for chords of the frame cannot be expected to find.

)";

constexpr const char* LOSSES_TEXT = R"(## What is lost

Lines that are not reported at the defaults, without refinement, by the first change that brings them
back: longer lists (the votes at their end are nearly equal), all candidates in the pool, a candidate
ratio of 0.5 (with all candidates in the pool), every chord above the default ratio a candidate
(`setSuppressionRadius(0)`), both. The longer lists have 105 and 256 lines, the others 256. The votes in
the cascade are of the chord of its frame nearest to the line, and the most of the 3 x 3 chords around it;
those of oriented maps are not part of the public interface. )";

constexpr const char* CANDIDATES_TEXT = R"(## Candidates and ascent

Squares of 256 pixels, where the frame is the image; k = 8, a naive pipeline without refinement. Percent
of the exact table's 100 strongest lines, and in brackets the number of chords counted exactly, in
thousands, mean of the images. A parallel maximum is stronger than (s + 1, e - 1) and (s - 1, e + 1), its
parallel neighbours.
"To a ring maximum": to the strongest of the 5 x 5 chords around, until the chord is the strongest of its
own. )";

constexpr const char* CROSSINGS_TEXT = R"(## Rules of the crossing

The same images, not oriented. Ratio of the cascade's votes to the exact ones over the chords with at
least n/4 = 64 exact votes; percent of the exact table's lines by ring maxima without ascent, and by
parallel maxima that climb to a ring maximum, both with a pool of 8192; cost of the merges, all levels
together. Ties without bias: to the larger point if the number of the chord's end on the first child plus
that of the crossing is even. Both neighbours: the border points on both sides of the crossing, of two
sums the larger one.

)";

} // namespace cascade

#endif // LINESPACE_CASCADE_TEXTS_HPP
