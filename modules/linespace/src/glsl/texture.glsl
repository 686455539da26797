// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// A texture as an edge map in a storage block: a byte for each pixel, row after row. An item writes
// a word, four pixels of it. And how many vote, which was 0.
//
// INTEGER: GL_R8UI, else GL_R8. BINARY: 1 for what is not 0. MASKED: 0 where the mask is 0.

layout(std430, binding = 0) writeonly buffer Image { uint image[]; };
layout(std430, binding = 1) buffer Count { int voters[]; };
#ifdef MASKED
layout(std430, binding = 2) readonly buffer Mask { uint mask[]; };
#endif
#ifdef INTEGER
layout(binding = 0) uniform highp usampler2D texels;
#else
layout(binding = 0) uniform highp sampler2D texels;
#endif

#define COLUMNS numbers[0]
#define PIXELS numbers[1]

void main()
{
    int first = int(itemIndex()) * 4;
    if (first >= PIXELS)
        return;
    uint together = 0u;
    int count = 0;
    for (int i = 0; i < 4 && first + i < PIXELS; ++i)
    {
        int at = first + i, y = quotient(at, COLUMNS), x = at - y * COLUMNS;
#ifdef INTEGER
        uint value = texelFetch(texels, ivec2(x, y), 0).r;
#else
        uint value = uint(texelFetch(texels, ivec2(x, y), 0).r * 255.0 + 0.5);
#endif
#ifdef BINARY
        value = min(value, 1u);
#endif
#ifdef MASKED
        if ((mask[at >> 2] >> ((at & 3) * 8) & 0xFFu) == 0u)
            value = 0u;
#endif
        together |= value << (8 * i);
        count += int(value != 0u);
    }
    if (count > 0)
        atomicAdd(voters[0], count);
    image[first / 4] = together;
}
