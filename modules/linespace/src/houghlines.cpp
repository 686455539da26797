// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The drop-in for cv::HoughLines (doc/algorithm.md, section 8). The lines that can be reported are
// those of the grid (i rho, min_theta + j theta). The cascaded Line Space tells which of them can
// have more votes than the threshold; only those are counted, by the definition of cv::HoughLines:
// an edge pixel votes for line (i, j) if the rounded x cos(theta) / rho + y sin(theta) / rho is i.
// Then the strongest is taken first, and what lies within one cell of it is dropped.

#include "executor_pool.hpp"
#include "grid_support.hpp"
#include "parameters.hpp"

#include <opencv2/core/version.hpp>

#include <climits>
#include <limits>

namespace cv {
namespace linespace {

namespace {

bool isStronger(const GridLine& a, const GridLine& b)
{
    return a.votes != b.votes   ? a.votes > b.votes
           : a.angle != b.angle ? a.angle < b.angle
                                : a.distance < b.distance;
}

//! As Executor::countGridLines, with the executor's table, for which `tables` are.
void countOnHost(Executor& executor, const EdgeMap& edges, const Plan& plan, const HoughGrid& grid,
                 int threshold, VoteTables& tables, std::vector<GridLine>& all)
{
    const int last = plan.levelCount() - 1;
    const EdgePixels pixels(edges);
    const bool hasTable = !countsAllLines(plan, grid, edges.weighted, pixels.count());
    if (hasTable)
    {
        StageTimes times;
        countVotes(executor, edges, plan, false, last, tables, times);
        executor.fetch(tables.of(last));
    }
    const int needed = neededSupport(threshold);

    std::vector<std::vector<GridLine>> found(grid.angles);
    parallel_for_(Range(0, grid.angles),
                  [&](const Range& range)
                  {
                      BandCounter counter(pixels, grid);
                      std::vector<int> distances, votes;
                      for (int angle = range.start; angle < range.end; ++angle)
                      {
                          if (hasTable)
                              supportedDistances(tables.of(last), plan.frame(), grid, angle, needed,
                                                 distances);
                          else
                              allDistances(grid, angle, distances);
                          counter.count(angle, distances, votes);
                          for (size_t i = 0; i < distances.size(); ++i)
                              if (votes[i] > threshold && votes[i] > 0)
                              {
                                  const GridLine line = {votes[i], angle, distances[i]};
                                  found[angle].push_back(line);
                              }
                      }
                  });
    all.clear();
    for (size_t i = 0; i < found.size(); ++i)
        all.insert(all.end(), found[i].begin(), found[i].end());
}

//! Brings the edge map to the host.
void readEdges(InputArray image, EdgeMap& edges)
{
    const Mat source = image.getMat(); // goes back to its device at the end
    if (!edges.weighted)
        cv::min(source, Scalar(1), edges.votes);
    else
        edges.votes = source.isContinuous() && !image.isUMat() ? source : source.clone();
}

//! The lines of the grid with more votes than the threshold that the Line Space does not rule out.
std::vector<GridLine> countedLines(InputArray image, bool weighted, const HoughGrid& grid,
                                   int threshold)
{
    const Ptr<const Plan> plan = Plan::cascaded(grid.image, 8);
    EdgeMap edges;
    edges.weighted = weighted;
    edges.source = onDevice(image);
    std::vector<GridLine> found;
    PooledExecutor pooled = takeExecutor(chosenBackend(BACKEND_AUTO, image.isUMat()));
    const auto count = [&](Executor& executor)
    {
        if (edges.source.empty() || !executor.takesUMats())
            readEdges(image, edges);
        if (!executor.countGridLines(edges, *plan, grid, threshold, found))
            countOnHost(executor, edges, *plan, grid, threshold, *pooled.tables, found);
    };
    const Ptr<Executor> executor = executorFor(BACKEND_AUTO, image.isUMat(), {pooled.executor});
    pooled.executor = runOn(BACKEND_AUTO, executor, count);
    giveExecutor(pooled);
    return found;
}

//! From OpenCV 5.1 on, cv::HoughLines refuses steps that are not positive and finite, and negative
//! thresholds; then it takes an empty image of any type for one without lines.
const bool IS_STRICT = CV_VERSION_MAJOR > 5 || (CV_VERSION_MAJOR == 5 && CV_VERSION_MINOR >= 1);

//! Whether a strict cv::HoughLines takes a step, which it converts to float.
bool isStep(double value)
{
    const float step = (float)value;
    return step > 0 && step <= std::numeric_limits<float>::max();
}

//! Throws where a strict cv::HoughLines does.
void checkStrictly(double rho, double theta, int threshold, double minTheta, double maxTheta)
{
    if (!isStep(rho))
        CV_Error_(Error::StsOutOfRange, ("rho = %.15g: must be more than 0 pixels, finite", rho));
    if (!isStep(theta))
        CV_Error_(Error::StsOutOfRange,
                  ("theta = %.15g: must be more than 0 radians, finite", theta));
    checkRange(threshold, 0, INT_MAX, "threshold", "0 or more votes");
    if (!(minTheta <= maxTheta))
        CV_Error_(
            Error::StsOutOfRange,
            ("min_theta = %.15g, max_theta = %.15g: must be numbers, and min_theta not larger "
             "than max_theta",
             minTheta, maxTheta));
}

//! Keeps, strongest first, the lines that are not within one cell of a stronger one.
std::vector<GridLine> strongestOfCells(std::vector<GridLine>& lines, const HoughGrid& grid)
{
    std::sort(lines.begin(), lines.end(), isStronger);
    // One byte per line of the grid: whether it is within one cell of a line taken. The margin
    // holds the neighbours of those at the edge, and of their mirror images beyond it.
    const int angleMargin = 2, distanceMargin = grid.mostDistance + 1;
    const size_t columns = 2 * (size_t)distanceMargin + 1;
    std::vector<uchar> taken(columns * (grid.angles + 2 * angleMargin), (uchar)0);
    const auto at = [&](int angle, int distance) -> uchar&
    {
        return taken[(angle + angleMargin) * columns + (distance + distanceMargin)];
    };
    const auto take = [&](int angle, int distance)
    {
        for (int a = angle - 1; a <= angle + 1; ++a)
            for (int d = distance - 1; d <= distance + 1; ++d)
                at(a, d) = 1;
    };
    std::vector<GridLine> kept;
    for (size_t i = 0; i < lines.size(); ++i)
    {
        const GridLine& line = lines[i];
        if (at(line.angle, line.distance))
            continue;
        kept.push_back(line);
        take(line.angle, line.distance);
        // (rho, theta) and (-rho, theta + pi) are one line: the last angle's neighbour is the
        // first, mirrored.
        if (grid.wraps && line.angle == 0)
            take(grid.angles, -line.distance);
        if (grid.wraps && line.angle == grid.angles - 1)
            take(-1, -line.distance);
    }
    return kept;
}

} // namespace

void HoughLines(InputArray image, OutputArray lines, double rho, double theta, int threshold,
                double srn, double stn, double min_theta, double max_theta, bool use_edgeval)
{
    if (IS_STRICT)
    {
        checkStrictly(rho, theta, threshold, min_theta, max_theta);
        if (image.empty())
        {
            lines.release();
            return;
        }
    }
    int type = CV_32FC2;
    if (lines.fixedType())
    {
        type = lines.type();
        if (type != CV_32FC2 && type != CV_32FC3)
            CV_Error_(
                Error::StsUnsupportedFormat,
                ("lines has type %s: must be CV_32FC2 or CV_32FC3", typeToString(type).c_str()));
    }
    // What is on a device stays there.
    const Mat source = image.isUMat() ? Mat() : image.getMat();
    const int sourceType = image.isUMat() ? image.type() : source.type();
    const int dimensions = image.isUMat() ? image.dims() : source.dims;
    if (sourceType != CV_8UC1 || dimensions > 2)
        CV_Error_(Error::StsUnsupportedFormat,
                  ("image has %d dimensions and type %s: must be CV_8UC1 with two dimensions",
                   dimensions, typeToString(sourceType).c_str()));
    const Size size = image.isUMat() ? image.size() : source.size();
    // As in cv::HoughLines, a negative step is an error unless it is so large that there is nothing
    // to count.
    const double distances = (2. * (size.width + size.height) + 1) / rho,
                 angles = (max_theta - min_theta) / theta;
    if ((rho < 0 && cvRound(distances) == 0) ||
        (theta < 0 && rho != 0 && angles >= -0.5 && angles <= 0))
    {
        lines.release();
        return;
    }
    const HoughGrid grid(size, rho / std::max(1., srn), theta / std::max(1., stn), min_theta,
                         max_theta);

    std::vector<GridLine> found;
    if (!size.empty())
        withMemoryFor("image", size,
                      [&]()
                      {
                          std::vector<GridLine> counted =
                              countedLines(image, use_edgeval, grid, threshold);
                          found = strongestOfCells(counted, grid);
                      });
    if (found.empty())
    {
        lines.release();
        return;
    }
    Mat result((int)found.size(), 1, type);
    for (int i = 0; i < result.rows; ++i)
    {
        const Vec2f polar = grid.line(found[i].angle, found[i].distance);
        float* row = result.ptr<float>(i);
        row[0] = polar[0];
        row[1] = polar[1];
        if (type == CV_32FC3)
            row[2] = (float)found[i].votes;
    }
    result.copyTo(lines);
}

} // namespace linespace
} // namespace cv
