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

//! Before the pixels, so that all of these are aligned.
const size_t HEAD = 16;

//! Of all that is read with gradients of so many bytes for a component.
size_t bytesOf(Size size, size_t component)
{
    return HEAD + (2 * component + sizeof(ushort) + 1) * size.width * size.height;
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
    allocateOn(pixels_, bytesOf(size, isFloat ? sizeof(float) : sizeof(short)));
    clearWrong();
    Launch launch(DIRECTIONS_PROGRAM, "findDirections", optionsFor(votes, isFloat));
    votes.giveTo(launch);
    launch
        .with(ocl::KernelArg::ReadOnlyNoSize(dx), ocl::KernelArg::ReadOnlyNoSize(dy),
              DirectionRule(tolerance).sineSquared(), out(bits_), inOut(pixels_))
        .run(size.width, size.height);
    return bits_;
}

UMat DeviceDirections::estimate(const DevicePixels& votes, double tolerance)
{
    const Size size = votes.image.size();
    const String options = optionsFor(votes, true);
    allocateBits(size, bits_);
    allocateOn(pixels_, bytesOf(size, 0));
    clearWrong();
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

void DeviceDirections::clearWrong()
{
    const int none = 0;
    uploadBytes(&none, sizeof(none), pixels_);
}

void DeviceDirections::read(const DevicePixels& votes, const UMat& dx, const UMat& dy,
                            OrientedPixels& pixels)
{
    const Size size = votes.image.size();
    const bool isFloat = dx.type() == CV_32FC1;
    const size_t area = (size_t)size.width * size.height;
    const String options = optionsFor(votes, isFloat);
    size_t bytes = HEAD;
    pixels.memory.create(1, (int)bytesOf(size, dx.empty() ? 0 : dx.elemSize()), CV_8UC1);
    const struct
    {
        const UMat& from;
        const char* kernel;
        Mat& to;
    } images[] = {{dx, "copyGradients", pixels.dx},
                  {dy, "copyGradients", pixels.dy},
                  {bits_, "copyDirections", pixels.directions}};
    for (const auto& image : images)
    {
        image.to.release();
        if (image.from.empty())
            continue;
        Launch(DIRECTIONS_PROGRAM, image.kernel, options)
            .with(ocl::KernelArg::ReadOnly(image.from), inOut(pixels_), asInt((double)bytes))
            .run(size.width, size.height);
        image.to = Mat(size, image.from.type(), pixels.memory.ptr() + bytes);
        bytes += area * image.from.elemSize();
    }
    Launch launch(DIRECTIONS_PROGRAM, "copyVotes", options);
    votes.giveTo(launch);
    launch.with(inOut(pixels_), asInt((double)bytes)).run(size.width, size.height);
    pixels.votes = Mat(size, CV_8UC1, pixels.memory.ptr() + bytes);
    download(pixels_, pixels.memory.total(), pixels.memory.data);
    pixels.areFinite = *pixels.memory.ptr<int>() == 0;
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
