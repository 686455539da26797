// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// What a local maximum of the table of the frame is, as ring_maxima.hpp defines it. The windows show
// the table, a word for each chord. Compiled before a shader that has RING_RADIUS.
//
// RING_RADIUS: of the neighbourhood on the ring of border points; -1: only the two chords parallel to it
// on either side.

/* Whether the chord of two points, which may be beyond the ring's ends, comes before chord i of
`votes` votes in the total order. */
bool isStrongerAt(Frame frame, int p, int q, int i, int votes)
{
    int points = 2 * (frame.width + frame.height);
    p = p < 0 ? p + points : p >= points ? p - points : p;
    q = q < 0 ? q + points : q >= points ? q - points : q;
    int s = min(p, q), e = max(p, q), partner = firstPartner(frame, s);
    if (e < partner)
        return false;
    int other = rowStart(frame, s) + e - partner, otherVotes = int(tableAt(uint(other)));
    return otherVotes > votes || (otherVotes == votes && other < i);
}

bool isMaximum(Frame frame, ivec2 chord, int i, int votes)
{
#ifdef SQUARE
    int left = 2 * frame.width + frame.height, points = left + frame.height;
    int row = chord.x & -SQUARE, column = chord.y & -SQUARE;
    for (int s = row; s < min(row + SQUARE, left); ++s)
        for (int e = max(column, firstPartner(frame, s)); e < min(column + SQUARE, points); ++e)
            if (isStrongerAt(frame, s, e, i, votes))
                return false;
    return true;
#elif RING_RADIUS < 0
    return !isStrongerAt(frame, chord.x + 1, chord.y - 1, i, votes) &&
           !isStrongerAt(frame, chord.x - 1, chord.y + 1, i, votes);
#else
    for (int k = 0; k <= RING_RADIUS; k = k > 0 ? -k : 1 - k) /* the nearest rows first */
        for (int j = -RING_RADIUS; j <= RING_RADIUS; ++j)
            if (isStrongerAt(frame, chord.x + k, chord.y + j, i, votes))
                return false;
    return true;
#endif
}
