// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The votes of chords of the frame by their rasters: of all of them (METHOD_EXACT), an item each,
// or with LIST of those of a list.

layout(std430, binding = 0) writeonly buffer Votes { uint votes[]; };
#ifdef LIST
layout(std430, binding = 1) readonly buffer Chords { ivec2 chords[]; };
#endif

#define FIRST_CHORD numbers[6]
#define CHORDS numbers[7] /* from there on */

void main()
{
    int i = int(itemIndex());
    if (i >= CHORDS)
        return;
    Frame frame = Frame(WIDTH, HEIGHT);
#ifdef LIST
    votes[i] = votesOfChord(frame, chords[i]);
#else
    votes[i] = votesOfChord(frame, chordAt(frame, FIRST_CHORD + i));
#endif
}
