// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From the cascade's maxima to chords with the most exact votes (doc/algorithm.md, section 4.2), as
// ascent.hpp defines it.
//
// Candidates are threes of numbers, (votes, s, e), after a first one whose first number is how many
// there are; those that still climb have CLIMBING votes. In a round all climb one step: the chords
// of their neighbourhoods that were not counted yet are marked and listed, each listed chord is
// counted once, each candidate moves to the strongest chord around it. Who asks goes on with those
// that climb for more steps: no launch is long (llvmpipe ends loops of a shader after 65536 turns,
// other drivers after a time). A chord has its place among
// those of squares of 8 x 8 neighbours (vote_squares.hpp), one square after another, so that a
// neighbourhood is read at few places. The order of a list is any, as marks are set and lists grow
// by atomic operations; what is counted does not depend on it, and everything else is written by
// one item.
//
// One of CLEAR_MARKS, LIST_NEIGHBOURS, COUNT_LISTED, TAKE_STEPS, CLIMB_ON, COUNT_CANDIDATES: what it is
// compiled for. RADIUS: of the neighbourhood. ROUNDS: numbers that a list begins with, how many
// chords each round has listed. The windows show the votes of all places.

#define SQUARE 8
#define CLIMBING -1

#define ROOM numbers[6] /* for candidates */
#define ROUND numbers[7]
#define FIRST_PLACE numbers[8] /* of those whose votes a launch writes */
#define PLACES numbers[9] /* from there on */
#define MARKS numbers[9] /* words, a bit for each place */

#if defined(LIST_NEIGHBOURS) || defined(COUNT_CANDIDATES)
layout(std430, binding = 0) buffer Candidates { int candidates[]; };
#endif
#if defined(TAKE_STEPS) || defined(CLIMB_ON)
layout(std430, binding = BLOCK_A) buffer Candidates { int candidates[]; };
#endif

/* A cell with a border point for each run of SQUARE of a frame's, of each side from its first one on. */
Frame runsOf(Frame frame)
{
    return Frame((frame.width + SQUARE - 1) / SQUARE, (frame.height + SQUARE - 1) / SQUARE);
}

#ifdef CLEAR_MARKS
layout(std430, binding = 0) writeonly buffer Marks { uint marks[]; };
layout(std430, binding = 1) writeonly buffer Listed { int listed[]; };

void main()
{
    int word = int(itemIndex());
    if (word < MARKS)
        marks[word] = 0u;
    if (word < ROUNDS)
        listed[word] = 0;
}
#endif

#ifdef COUNT_LISTED
layout(std430, binding = 0) readonly buffer Listed { int listed[]; };
layout(std430, binding = 1) writeonly buffer Votes { uint votes[]; };

/* Where a run begins. */
int pointOfRun(Frame frame, Frame runs, int run)
{
    int right = runs.width, bottom = right + runs.height, left = bottom + runs.width;
    return run < right    ? run * SQUARE
           : run < bottom ? frame.width + (run - right) * SQUARE
           : run < left   ? frame.width + frame.height + (run - bottom) * SQUARE
                          : 2 * frame.width + frame.height + (run - left) * SQUARE;
}

/* An item for each chord that a round may have listed. */
void main()
{
    int i = int(itemIndex());
    if (i >= listed[ROUND])
        return;
    int place = listed[ROUNDS + i], to = place - FIRST_PLACE;
    if (to < 0 || to >= PLACES)
        return;
    Frame frame = Frame(WIDTH, HEIGHT), runs = runsOf(frame);
    ivec2 pair = chordAt(runs, place / (SQUARE * SQUARE));
    ivec2 first = ivec2(pointOfRun(frame, runs, pair.x), pointOfRun(frame, runs, pair.y));
    votes[to] = votesOfChord(frame, first + ivec2(place / SQUARE % SQUARE, place % SQUARE));
}
#endif

#if defined(LIST_NEIGHBOURS) || defined(TAKE_STEPS) || defined(CLIMB_ON)

/* A point's place among the runs: its run and its number there. */
ivec2 placeInRuns(Frame frame, Frame runs, int p)
{
    int side = 0;
    if (p >= frame.width)
    {
        p -= frame.width;
        side = runs.width;
        if (p >= frame.height)
        {
            p -= frame.height;
            side += runs.height;
            if (p >= frame.width)
            {
                p -= frame.width;
                side += runs.width;
            }
        }
    }
    return ivec2(side + p / SQUARE, p % SQUARE);
}

/* The place of a chord, s < e. */
int placeOf(Frame frame, Frame runs, ivec2 chord)
{
    ivec2 s = placeInRuns(frame, runs, chord.x), e = placeInRuns(frame, runs, chord.y);
    return (chordIndex(runs, s.x, e.x) * SQUARE + s.y) * SQUARE + e.y;
}

#define NEIGHBOURS ((2 * RADIUS + 1) * (2 * RADIUS + 1))

/* A chord of a neighbourhood on the ring, the smaller end first; (0, 0) if its ends are on one side. */
ivec2 neighbourOf(Frame frame, ivec2 chord, int j)
{
    int points = 2 * (frame.width + frame.height);
    int p = chord.x + j / (2 * RADIUS + 1) - RADIUS, q = chord.y + j % (2 * RADIUS + 1) - RADIUS;
    p = p < 0 ? p + points : p >= points ? p - points : p;
    q = q < 0 ? q + points : q >= points ? q - points : q;
    ivec2 result = ivec2(min(p, q), max(p, q));
    return result.y >= firstPartner(frame, result.x) ? result : ivec2(0);
}
#endif

#ifdef LIST_NEIGHBOURS
layout(std430, binding = 1) buffer Marks { uint marks[]; };
layout(std430, binding = 2) buffer Listed { int listed[]; };

/* Marks and lists what is new in the neighbourhoods of the candidates that climb; in the first round all
do. */
void main()
{
    int i = int(itemIndex());
    if (i >= min(candidates[0], ROOM))
        return;
    int at = 3 * (i + 1);
    if (ROUND == 0)
        candidates[at] = CLIMBING;
    if (candidates[at] != CLIMBING)
        return;
    Frame frame = Frame(WIDTH, HEIGHT), runs = runsOf(frame);
    ivec2 chord = ivec2(candidates[at + 1], candidates[at + 2]);
    uint fresh = 0u; /* a bit for each neighbour */
    for (int j = 0; j < NEIGHBOURS; ++j)
    {
        ivec2 neighbour = neighbourOf(frame, chord, j);
        if (neighbour.y == 0)
            continue;
        int place = placeOf(frame, runs, neighbour);
        uint bit = 1u << (place & 31);
        if ((atomicOr(marks[place >> 5], bit) & bit) == 0u)
            fresh |= 1u << j;
    }
    if (fresh == 0u)
        return;
    int to = ROUNDS + atomicAdd(listed[ROUND], bitCount(fresh));
    for (; fresh != 0u; fresh &= fresh - 1u, ++to)
        listed[to] = placeOf(frame, runs, neighbourOf(frame, chord, findLSB(fresh)));
}
#endif

#if defined(TAKE_STEPS) || defined(CLIMB_ON)

/* The total order, as isStronger in peaks.hpp: (votes, s, e). */
bool isStronger(ivec3 a, ivec3 b)
{
    return a.x != b.x ? a.x > b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

#ifdef CLIMB_ON
layout(std430, binding = BLOCK_B) readonly buffer Marks { uint marks[]; };
#endif

/* Counted by a round, or now. */
int votesOf(Frame frame, Frame runs, ivec2 chord)
{
    int place = placeOf(frame, runs, chord);
#ifdef CLIMB_ON
    if ((marks[place >> 5] >> (place & 31) & 1u) == 0u)
        return int(votesOfChord(frame, chord));
#endif
    return int(tableAt(uint(place)));
}

/* The strongest chord of a neighbourhood: votes, s and e. */
ivec3 strongestAround(Frame frame, ivec2 chord)
{
    Frame runs = runsOf(frame);
    ivec3 best = ivec3(-1, 0, 0);
    for (int j = 0; j < NEIGHBOURS; ++j)
    {
        ivec2 neighbour = neighbourOf(frame, chord, j);
        if (neighbour.y == 0)
            continue;
        ivec3 other = ivec3(votesOf(frame, runs, neighbour), neighbour);
        if (isStronger(other, best))
            best = other;
    }
    return best;
}

/* Each candidate that climbs moves to the strongest chord around it, or is there. With CLIMB_ON the
few that climb for more steps than there are rounds take up to STEPS + 1 of them alone, and count what
was not counted for others. */
void main()
{
    int i = int(itemIndex());
    if (i >= min(candidates[0], ROOM))
        return;
    int at = 3 * (i + 1);
    if (candidates[at] != CLIMBING)
        return;
    Frame frame = Frame(WIDTH, HEIGHT);
    ivec2 chord = ivec2(candidates[at + 1], candidates[at + 2]);
    ivec3 best = strongestAround(frame, chord);
#ifdef CLIMB_ON
    for (int step = 0; step < STEPS && best.yz != chord; ++step)
    {
        chord = best.yz;
        best = strongestAround(frame, chord);
    }
#endif
    if (best.yz == chord)
        candidates[at] = best.x;
    candidates[at + 1] = best.y;
    candidates[at + 2] = best.z;
}
#endif

#ifdef COUNT_CANDIDATES
/* Candidates that do not climb: each gets its exact votes. */
void main()
{
    int i = int(itemIndex());
    if (i >= min(candidates[0], ROOM))
        return;
    int at = 3 * (i + 1);
    candidates[at] =
        int(votesOfChord(Frame(WIDTH, HEIGHT), ivec2(candidates[at + 1], candidates[at + 2])));
}
#endif
