// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A table that is read at any place, of any size: it is bound to as many storage blocks as it
// takes, from the first binding on. Compiled before a shader that has WINDOWS.
//
// WINDOWS: blocks, of 2^WINDOW_LOG words each but the last. BLOCK_A, BLOCK_B, BLOCK_C: the bindings
// after them.

layout(std430, binding = 0) readonly buffer Window0 { uint window0[]; };
#if WINDOWS > 1
layout(std430, binding = 1) readonly buffer Window1 { uint window1[]; };
#endif
#if WINDOWS > 2
layout(std430, binding = 2) readonly buffer Window2 { uint window2[]; };
#endif
#if WINDOWS > 3
layout(std430, binding = 3) readonly buffer Window3 { uint window3[]; };
#endif
#if WINDOWS > 4
layout(std430, binding = 4) readonly buffer Window4 { uint window4[]; };
#endif
#if WINDOWS > 5
layout(std430, binding = 5) readonly buffer Window5 { uint window5[]; };
#endif
#if WINDOWS > 6
layout(std430, binding = 6) readonly buffer Window6 { uint window6[]; };
#endif
#if WINDOWS > 7
layout(std430, binding = 7) readonly buffer Window7 { uint window7[]; };
#endif
#if WINDOWS > 8
layout(std430, binding = 8) readonly buffer Window8 { uint window8[]; };
#endif
#if WINDOWS > 9
layout(std430, binding = 9) readonly buffer Window9 { uint window9[]; };
#endif
#if WINDOWS > 10
layout(std430, binding = 10) readonly buffer Window10 { uint window10[]; };
#endif
#if WINDOWS > 11
layout(std430, binding = 11) readonly buffer Window11 { uint window11[]; };
#endif
#if WINDOWS > 12
layout(std430, binding = 12) readonly buffer Window12 { uint window12[]; };
#endif

uint tableAt(uint i)
{
#if WINDOWS > 1
    uint window = i >> WINDOW_LOG;
    i &= (1u << WINDOW_LOG) - 1u;
#if WINDOWS > 1
    if (window == 1u)
        return window1[i];
#endif
#if WINDOWS > 2
    if (window == 2u)
        return window2[i];
#endif
#if WINDOWS > 3
    if (window == 3u)
        return window3[i];
#endif
#if WINDOWS > 4
    if (window == 4u)
        return window4[i];
#endif
#if WINDOWS > 5
    if (window == 5u)
        return window5[i];
#endif
#if WINDOWS > 6
    if (window == 6u)
        return window6[i];
#endif
#if WINDOWS > 7
    if (window == 7u)
        return window7[i];
#endif
#if WINDOWS > 8
    if (window == 8u)
        return window8[i];
#endif
#if WINDOWS > 9
    if (window == 9u)
        return window9[i];
#endif
#if WINDOWS > 10
    if (window == 10u)
        return window10[i];
#endif
#if WINDOWS > 11
    if (window == 11u)
        return window11[i];
#endif
#if WINDOWS > 12
    if (window == 12u)
        return window12[i];
#endif
#endif
    return window0[i];
}
