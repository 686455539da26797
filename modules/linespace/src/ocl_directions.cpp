// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include <cvconfig.h>

#ifdef HAVE_OPENCL

#include "ocl_directions.hpp"

namespace cv {
namespace linespace {

namespace {

void allocateBits(Size size, UMat& bits)
{
    checkAllocation((double)size.width * size.height * sizeof(ushort));
    bits.create(size, CV_16UC1);
    checkIsOnDevice(bits);
}

String optionsFor(const DevicePixels& votes, bool hasFloats)
{
    String options = votes.options + (hasFloats ? " -D FLOATS" : "") +
                     format(" -D BINS=%d -D CENTRE_COSINES=", (int)DIRECTION_BINS);
    for (int bin = 0; bin < DIRECTION_BINS; ++bin)
        options += format(bin > 0 ? ",%d" : "%d", centreCosine(bin));
    return options;
}

} // namespace

UMat DeviceDirections::find(const DevicePixels& votes, const UMat& dx, const UMat& dy,
                            double tolerance)
{
    const Size size = votes.image.size();
    const bool isFloat = dx.type() == CV_32FC1;
    allocateBits(size, bits_);
    int wrong = 0;
    uploadBytes(&wrong, sizeof(wrong), wrong_);
    Launch launch(DIRECTIONS_PROGRAM, "findDirections", optionsFor(votes, isFloat));
    votes.giveTo(launch);
    launch
        .with(ocl::KernelArg::ReadOnlyNoSize(dx), ocl::KernelArg::ReadOnlyNoSize(dy),
              DirectionRule(tolerance).sineSquared(), out(bits_), inOut(wrong_))
        .run(size.width, size.height);
    if (isFloat)
        download(wrong_, sizeof(wrong), &wrong);
    return wrong ? UMat() : bits_;
}

UMat DeviceDirections::estimate(const DevicePixels& votes, double tolerance)
{
    const Size size = votes.image.size();
    const String options = optionsFor(votes, true);
    allocateBits(size, bits_);
    allocateOn(slopes_, 2 * (size_t)(size.width + 2) * (size.height + 2));
    Launch slopes(DIRECTIONS_PROGRAM, "findSlopes", options);
    votes.giveTo(slopes);
    slopes.with(out(slopes_)).run(size.width + 2, size.height + 2);
    Launch launch(DIRECTIONS_PROGRAM, "estimateDirections", options);
    votes.giveTo(launch);
    launch.with(in(slopes_), DirectionRule(tolerance).sineSquared(), out(bits_))
        .run(size.width, size.height);
    return bits_;
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
