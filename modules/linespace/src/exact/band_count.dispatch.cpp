// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Chooses the instruction set that counts chords in a band (band_count.simd.hpp).

#include "band_count.simd.hpp"
#include "exact/band_count.simd_declarations.hpp"

namespace cv {
namespace linespace {

int countInBand(const BandWords& band, const Raster& raster)
{
    CV_CPU_DISPATCH(countBand, (band, raster), CV_CPU_DISPATCH_MODES_ALL);
}

void countParallels(const ParallelColumns& columns, int d, int* votes)
{
    CV_CPU_DISPATCH(countParallelsOf, (columns, d, votes), CV_CPU_DISPATCH_MODES_ALL);
}

} // namespace linespace
} // namespace cv
