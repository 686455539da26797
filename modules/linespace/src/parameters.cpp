// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "parameters.hpp"

#include <climits>
#include <limits>

namespace cv {
namespace linespace {

namespace {

template<class Value>
void readInto(const FileNode& fn, const char* name, Value& value)
{
    const FileNode node = fn[name];
    if (node.empty())
        return;
    if (!node.isInt() && !node.isReal())
        CV_Error_(Error::StsParseError, ("%s is not a number: must be one", name));
    node >> value;
}

} // namespace

Parameters::Parameters()
    : threshold(0), maxLines(0), method(METHOD_CASCADED), cellSize(8), backend(BACKEND_AUTO),
      suppression(SUPPRESS_RING), suppressionRadius(2), selection(SELECT_PEAKS),
      refine(REFINE_LEAST_SQUARES), poolSize(8192), memoryLimit(8192), suppressionDistance(3),
      candidateRatio(0.75), minTheta(0), maxTheta(CV_PI), orientationTolerance(22.5),
      falseAlarms(1), edgeWeights(false), pruning(true)
{
}

void Parameters::check() const
{
    const double most = std::numeric_limits<double>::max();
    checkRange(threshold, 0, INT_MAX, "threshold", "0 or more votes");
    checkRange(maxLines, 0, INT_MAX, "maxLines", "0 (all) or more");
    checkRange(method, (int)METHOD_EXACT, (int)METHOD_STRIPS, "method",
               "METHOD_EXACT (0), METHOD_CASCADED (1) or METHOD_STRIPS (2)");
    checkRange(cellSize, 2, 64, "cellSize", "2 to 64 pixels");
    checkRange(backend, (int)BACKEND_AUTO, (int)BACKEND_OPENGL, "backend",
               "one of enum Backend, 0 to 4");
    checkRange(suppression, (int)SUPPRESS_RING, (int)SUPPRESS_GREEDY, "suppression",
               "one of enum Suppression, 0 to 2");
    checkRange(suppressionRadius, 0, 64, "suppressionRadius", "0 to 64 border points");
    checkRange(suppressionDistance, 0., most, "suppressionDistance", "0 or more pixels, finite");
    checkRange(selection, (int)SELECT_PEAKS, (int)SELECT_EXPLAIN, "selection",
               "SELECT_PEAKS (0) or SELECT_EXPLAIN (1)");
    checkRange(refine, (int)REFINE_NONE, (int)REFINE_LEAST_SQUARES, "refine",
               "REFINE_NONE (0) or REFINE_LEAST_SQUARES (1)");
    checkRange(candidateRatio, 0., 1., "candidateRatio", "0 to 1");
    checkRange(poolSize, 1, INT_MAX, "poolSize", "1 or more");
    checkRange(minTheta, -1e6, 1e6, "minTheta", "a finite angle in radians, at most 1e6 in size");
    checkRange(maxTheta, -1e6, 1e6, "maxTheta", "a finite angle in radians, at most 1e6 in size");
    if (minTheta > maxTheta)
        CV_Error_(
            Error::StsOutOfRange,
            ("minTheta = %.15g is larger than maxTheta = %.15g: must not be", minTheta, maxTheta));
    checkRange(orientationTolerance, std::numeric_limits<double>::min(), 90.,
               "orientationTolerance", "more than 0 and at most 90 degrees");
    checkRange(falseAlarms, std::numeric_limits<double>::min(), most, "falseAlarms",
               "more than 0, finite");
    checkRange(memoryLimit, 1, INT_MAX, "memoryLimit", "1 MiB or more");
}

void Parameters::write(FileStorage& fs) const
{
    fs << "threshold" << threshold << "maxLines" << maxLines << "method" << method;
    fs << "cellSize" << cellSize << "backend" << backend << "suppression" << suppression;
    fs << "suppressionRadius" << suppressionRadius << "suppressionDistance" << suppressionDistance;
    fs << "selection" << selection << "refine" << refine << "candidateRatio" << candidateRatio
       << "poolSize" << poolSize;
    fs << "minTheta" << minTheta << "maxTheta" << maxTheta << "orientationTolerance"
       << orientationTolerance << "falseAlarms" << falseAlarms;
    fs << "edgeWeights" << (int)edgeWeights << "pruning" << (int)pruning << "memoryLimit"
       << memoryLimit;
}

Parameters Parameters::read(const FileNode& fn)
{
    Parameters p; // a parameter that the file lacks has its default
    readInto(fn, "threshold", p.threshold);
    readInto(fn, "maxLines", p.maxLines);
    readInto(fn, "method", p.method);
    readInto(fn, "cellSize", p.cellSize);
    readInto(fn, "backend", p.backend);
    readInto(fn, "suppression", p.suppression);
    readInto(fn, "suppressionRadius", p.suppressionRadius);
    readInto(fn, "suppressionDistance", p.suppressionDistance);
    readInto(fn, "selection", p.selection);
    readInto(fn, "refine", p.refine);
    readInto(fn, "candidateRatio", p.candidateRatio);
    readInto(fn, "poolSize", p.poolSize);
    readInto(fn, "minTheta", p.minTheta);
    readInto(fn, "maxTheta", p.maxTheta);
    readInto(fn, "orientationTolerance", p.orientationTolerance);
    readInto(fn, "falseAlarms", p.falseAlarms);
    readInto(fn, "edgeWeights", p.edgeWeights);
    readInto(fn, "pruning", p.pruning);
    readInto(fn, "memoryLimit", p.memoryLimit);
    p.check();
    return p;
}

} // namespace linespace
} // namespace cv
