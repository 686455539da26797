// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Chooses the instruction set of the cascade of strips (strip_kernels.simd.hpp).

#include "strip_kernels.simd.hpp"
#include "strips/strip_kernels.simd_declarations.hpp"

namespace cv {
namespace linespace {

template<>
const StripKernels<uchar>& stripKernels<uchar>()
{
    CV_CPU_DISPATCH(byteKernels, (), CV_CPU_DISPATCH_MODES_ALL);
}

template<>
const StripKernels<ushort>& stripKernels<ushort>()
{
    CV_CPU_DISPATCH(shortKernels, (), CV_CPU_DISPATCH_MODES_ALL);
}

const BundleKernels& bundleKernels()
{
    CV_CPU_DISPATCH(kernelsOfBundles, (), CV_CPU_DISPATCH_MODES_ALL);
}

} // namespace linespace
} // namespace cv
