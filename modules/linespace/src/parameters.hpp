// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The parameters of a detector: their defaults, their ranges, and how files hold them.

#ifndef OPENCV_LINESPACE_PARAMETERS_HPP
#define OPENCV_LINESPACE_PARAMETERS_HPP

#include "precomp.hpp"

namespace cv {
namespace linespace {

//! Throws unless low <= value <= high; NaN is outside of any range.
template<class Value>
void checkRange(Value value, Value low, Value high, const char* name, const char* allowed)
{
    if (!(value >= low && value <= high))
        CV_Error_(Error::StsOutOfRange, ("%s = %.15g: must be %s", name, (double)value, allowed));
}

//! Named as the setters of LineSpaceDetector, where they are described.
struct Parameters
{
    int threshold, maxLines, method, cellSize, backend, suppression, suppressionRadius, selection,
        refine, poolSize, memoryLimit;
    double suppressionDistance, candidateRatio, minTheta, maxTheta, orientationTolerance,
        falseAlarms;
    bool edgeWeights, pruning;

    Parameters();
    //! Throws if one of them is out of its range.
    void check() const;
    void write(FileStorage& fs) const;
    //! A parameter that the file lacks has its default. Throws if one is no number or out of range.
    static Parameters read(const FileNode& fn);
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_PARAMETERS_HPP
