// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include <cvconfig.h>

#ifdef HAVE_OPENCL

#include "ocl_launch.hpp"

#include "opencl_kernels_linespace.hpp"

#include <climits>
#include <cstdlib>

namespace cv {
namespace linespace {

namespace {

typedef ocl::internal::ProgramEntry Entry;

ocl::ProgramSource joined(const std::vector<Entry>& entries)
{
    String code, hash;
    for (size_t i = 0; i < entries.size(); ++i)
    {
        code += entries[i].programCode;
        hash += entries[i].programHash;
    }
    return ocl::ProgramSource(entries.back().module, entries.back().name, code, hash);
}

const ocl::ProgramSource& sourceOf(DeviceProgram program)
{
    using namespace ocl::linespace;
    static const ocl::ProgramSource ascent = joined({chords_oclsrc, pixels_oclsrc, ascent_oclsrc}),
                                    cascade = joined({chords_oclsrc, pixels_oclsrc, segments_oclsrc,
                                                      cascade_oclsrc}),
                                    directions =
                                        joined({chords_oclsrc, pixels_oclsrc, directions_oclsrc}),
                                    houghlines = joined({chords_oclsrc, houghlines_oclsrc}),
                                    maxima = joined({chords_oclsrc, pixels_oclsrc, maxima_oclsrc}),
                                    pruning =
                                        joined({chords_oclsrc, segments_oclsrc, pruning_oclsrc}),
                                    table = joined({chords_oclsrc, table_oclsrc});
    switch (program)
    {
    case ASCENT_PROGRAM: return ascent;
    case CASCADE_PROGRAM: return cascade;
    case DIRECTIONS_PROGRAM: return directions;
    case HOUGHLINES_PROGRAM: return houghlines;
    case MAXIMA_PROGRAM: return maxima;
    case PRUNING_PROGRAM: return pruning;
    default: return table;
    }
}

enum KernelChoice
{
    BY_DEVICE,
    FOR_PROCESSORS,
    FOR_GRAPHICS
};

KernelChoice kernelChoice()
{
    const char* const value = std::getenv("LINESPACE_OPENCL_KERNELS");
    const String choice = value ? value : "";
    if (choice != "" && choice != "processor" && choice != "graphics")
        throw DeviceFailure("LINESPACE_OPENCL_KERNELS=" + choice +
                            ": must be processor or graphics");
    return choice == "processor" ? FOR_PROCESSORS : choice == "graphics" ? FOR_GRAPHICS : BY_DEVICE;
}

} // namespace

const char* typeOf(int depth)
{
    return depth == 1 ? "uchar" : depth == 2 ? "ushort" : "int";
}

void checkAllocation(double bytes)
{
    if (bytes > std::min<size_t>(ocl::Device::getDefault().maxMemAllocSize(), INT_MAX))
        throw DeviceFailure(format("%.0f bytes are more than the device gives at once", bytes));
}

void checkIsOnDevice(const UMat& memory)
{
    // OpenCV gives memory of the host where the device has none.
    if (!memory.u || memory.u->currAllocator != ocl::getOpenCLAllocator())
        throw DeviceFailure(format("%.0f bytes are more than the device has left",
                                   (double)memory.total() * memory.elemSize()));
}

void allocateOn(UMat& memory, size_t bytes)
{
    if (bytes <= (size_t)memory.cols)
        return;
    memory.release();
    checkAllocation((double)bytes);
    UMat allocated(1, (int)bytes, CV_8UC1);
    checkIsOnDevice(allocated);
    memory = allocated;
}

void copyOnDevice(const std::function<void()>& copy)
{
    try
    {
        copy();
    }
    catch (const cv::Exception& exception)
    {
        throw DeviceFailure(exception.err);
    }
}

void uploadBytes(const void* from, size_t bytes, UMat& memory)
{
    allocateOn(memory, bytes);
    copyOnDevice(
        [&]() { Mat(1, (int)bytes, CV_8UC1, (void*)from).copyTo(memory.colRange(0, (int)bytes)); });
}

void download(const UMat& memory, size_t bytes, void* to)
{
    Mat result(1, (int)bytes, CV_8UC1, to);
    copyOnDevice([&]() { memory.colRange(0, (int)bytes).copyTo(result); });
}

Launch::Launch(DeviceProgram program, const char* name, const String& options)
    : name_(name), next_(0)
{
    String errors;
    const ocl::Program built =
        ocl::Context::getDefault().getProg(sourceOf(program), options, errors);
    if (!built.ptr() || !kernel_.create(name, built))
        throw DeviceFailure(format("kernel %s is not built: %s", name, errors.c_str()));
}

void Launch::run(size_t width, size_t height, bool alongRows)
{
    size_t items = alongRows ? GROUP_OF_ROWS : GROUP;
    const size_t most = std::max<size_t>(1, kernel_.workGroupSize());
    while (items > most)
        items /= 2;
    size_t local[2] = {alongRows ? 1 : items, alongRows ? items : 1}, global[2] = {width, height};
    if (!kernel_.run(2, global, local, false))
        throw DeviceFailure(format("kernel %s is not launched", name_));
}

void DevicePixels::giveTo(Launch& launch) const
{
    launch.with(ocl::KernelArg::ReadOnly(image));
    if (!mask.empty())
        launch.with(ocl::KernelArg::ReadOnlyNoSize(mask));
}

void DevicePixels::giveDirectionsTo(Launch& launch) const
{
    if (!directions.empty())
        launch.with(ocl::KernelArg::ReadOnlyNoSize(directions));
}

String DevicePixels::directionOptions() const
{
    return directions.empty() ? String() : " -D ORIENTED" + directionBinOptions();
}

String directionBinOptions()
{
    String result = format(" -D BINS=%d -D END_COSINES=", DIRECTION_BINS);
    for (int bin = 0; bin < DIRECTION_BINS; ++bin)
        result += format(bin > 0 ? ",%d" : "%d", endCosine(bin));
    return result;
}

bool isProcessor()
{
    static const KernelChoice choice = kernelChoice();
    return choice == BY_DEVICE ? ocl::Device::getDefault().type() == ocl::Device::TYPE_CPU
                               : choice == FOR_PROCESSORS;
}

int asInt(double value)
{
    if (std::abs(value) > INT_MAX)
        throw DeviceFailure("the frame is too large for 32-bit numbers");
    return (int)value;
}

void checkRasters(const Cell& frame)
{
    asInt(4. * frame.width * frame.height + 4. * std::max(frame.width, frame.height));
}

} // namespace linespace
} // namespace cv

#endif // HAVE_OPENCL
