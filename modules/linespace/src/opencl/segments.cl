// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Cells that stand side by side, and runs of chords of a row of the parent: what the merges of
// whole tables (cascade.cl) and of blocks (pruning.cl) share. Both are compiled after this text.
//
// CELLS: how many cells are taken at a time, 1, 2, 4, 8 or 16.

#if CELLS == 1
#define VECTOR(type) type
#else
#define VECTOR(type) CONCAT(type, CELLS)
#endif
#define CONVERT(type, value) CONCAT(convert_, VECTOR(type))(value)

/* Runs of cells are aligned: CELLS divides their number, and a buffer begins at any vector's
boundary. (vloadn and vstoren, which ask for less, are single bytes on some devices.) */
#define CELLS_AT(type, from) (*(__global VECTOR(type)*)(from))
#define CONST_CELLS_AT(type, from) (*(__global const VECTOR(type)*)(from))

/* Points of the shared side, as struct DeviceCrossings: that of chord i is (numerator + i
numeratorStep) / (denominator + i denominatorStep), rounded down. */
typedef struct
{
    int numerator, numeratorStep, denominator, denominatorStep;
} Crossings;

inline int crossingAt(__global const Crossings* run, int i)
{
    return quotient(run->numerator + i * run->numeratorStep,
                    run->denominator + i * run->denominatorStep);
}

/* Those of chords first .. first + count - 1. In a loop of their own, which compilers turn into
vectors. */
inline void findCrossings(__global const Crossings* run, int first, int count, int* crossings)
{
    const int numeratorStep = run->numeratorStep, denominatorStep = run->denominatorStep;
    const int numerator = run->numerator + first * numeratorStep;
    const int denominator = run->denominator + first * denominatorStep;
    for (int i = 0; i < count; ++i)
        crossings[i] = quotient(numerator + i * numeratorStep, denominator + i * denominatorStep);
}

/* A run of chords of one row of the parent, as struct DeviceSegment: its first one has the end
firstEnd. */
typedef struct
{
    int firstEnd, count, isCrossing, childS, chordS, strideS, chordE, strideE, stepE;
    Crossings crossings;
} Segment;
