// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The public detector: checks arguments, keeps parameters, chooses the back end and calls the
// stages in order. No mathematics of its own.

#include "acontrario.hpp"
#include "ascent.hpp"
#include "backends.hpp"
#include "line_geometry.hpp"
#include "orientation.hpp"
#include "peaks.hpp"
#include "refine.hpp"
#include "selection.hpp"

#include <climits>
#include <cmath>
#include <limits>

namespace cv {
namespace linespace {

namespace {

//! Throws unless low <= value <= high; NaN is outside of any range.
template<class Value>
void checkRange(Value value, Value low, Value high, const char* name, const char* allowed)
{
    if (!(value >= low && value <= high))
        CV_Error_(Error::StsOutOfRange, ("%s = %.15g: must be %s", name, (double)value, allowed));
}

void checkImage(const Mat& image, const char* name)
{
    if (image.empty())
        CV_Error_(Error::StsBadSize, ("%s is empty: must be at least 1 x 1", name));
    if (image.type() != CV_8UC1)
        CV_Error_(Error::StsUnsupportedFormat,
                  ("%s has %d dimensions and type %s: must be CV_8UC1 with two dimensions", name,
                   image.dims, typeToString(image.type()).c_str()));
    if (image.dims != 2)
        CV_Error_(Error::StsBadSize, ("%s has %d dimensions: must be two", name, image.dims));
}

//! A value that is not finite, if there is one. (To cv::checkRange the largest float is none.)
bool findNotFinite(const Mat& values, Point& where)
{
    const float most = std::numeric_limits<float>::max();
    for (int y = 0; y < values.rows; ++y)
    {
        const float* const row = values.ptr<float>(y);
        int wrong = 0; // without a branch, for speed
        for (int x = 0; x < values.cols; ++x)
            wrong |= !(std::abs(row[x]) <= most);
        for (int x = 0; wrong && x < values.cols; ++x)
            if (!(std::abs(row[x]) <= most))
            {
                where = Point(x, y);
                return true;
            }
    }
    return false;
}

struct Parameters
{
    int threshold, maxLines, method, cellSize, backend, suppression, suppressionRadius, selection,
        refine, poolSize, memoryLimit;
    double suppressionDistance, candidateRatio, minTheta, maxTheta, orientationTolerance,
        falseAlarms;
    bool edgeWeights;

    Parameters()
        : threshold(0), maxLines(0), method(METHOD_CASCADED), cellSize(8), backend(BACKEND_AUTO),
          suppression(SUPPRESS_RING), suppressionRadius(2), selection(SELECT_PEAKS),
          refine(REFINE_LEAST_SQUARES), poolSize(4096), memoryLimit(8192), suppressionDistance(3),
          candidateRatio(0.75), minTheta(0), maxTheta(CV_PI), orientationTolerance(22.5),
          falseAlarms(1), edgeWeights(false)
    {
    }

    void check() const
    {
        const double most = std::numeric_limits<double>::max();
        checkRange(threshold, 0, INT_MAX, "threshold", "0 or more votes");
        checkRange(maxLines, 0, INT_MAX, "maxLines", "0 (all) or more");
        checkRange(method, (int)METHOD_EXACT, (int)METHOD_CASCADED, "method",
                   "METHOD_EXACT (0) or METHOD_CASCADED (1)");
        checkRange(cellSize, 2, 64, "cellSize", "2 to 64 pixels");
        checkRange(backend, (int)BACKEND_AUTO, (int)BACKEND_OPENGL, "backend",
                   "one of enum Backend, 0 to 4");
        checkRange(suppression, (int)SUPPRESS_RING, (int)SUPPRESS_GREEDY, "suppression",
                   "one of enum Suppression, 0 to 2");
        checkRange(suppressionRadius, 0, 64, "suppressionRadius", "0 to 64 border points");
        checkRange(suppressionDistance, 0., most, "suppressionDistance",
                   "0 or more pixels, finite");
        checkRange(selection, (int)SELECT_PEAKS, (int)SELECT_EXPLAIN, "selection",
                   "SELECT_PEAKS (0) or SELECT_EXPLAIN (1)");
        checkRange(refine, (int)REFINE_NONE, (int)REFINE_LEAST_SQUARES, "refine",
                   "REFINE_NONE (0) or REFINE_LEAST_SQUARES (1)");
        checkRange(candidateRatio, 0., 1., "candidateRatio", "0 to 1");
        checkRange(poolSize, 1, INT_MAX, "poolSize", "1 or more");
        checkRange(minTheta, -1e6, 1e6, "minTheta",
                   "a finite angle in radians, at most 1e6 in size");
        checkRange(maxTheta, -1e6, 1e6, "maxTheta",
                   "a finite angle in radians, at most 1e6 in size");
        if (minTheta > maxTheta)
            CV_Error_(Error::StsOutOfRange,
                      ("minTheta = %.15g is larger than maxTheta = %.15g: must not be", minTheta,
                       maxTheta));
        checkRange(orientationTolerance, std::numeric_limits<double>::min(), 90.,
                   "orientationTolerance", "more than 0 and at most 90 degrees");
        checkRange(falseAlarms, std::numeric_limits<double>::min(), most, "falseAlarms",
                   "more than 0, finite");
        checkRange(memoryLimit, 1, INT_MAX, "memoryLimit", "1 MiB or more");
    }
};

/** Whose directions vote; none for a map that is not oriented. Empty gradients are estimated from
the edge map. */
struct Gradients
{
    bool isOriented;
    Mat dx, dy;

    void check(Size size) const
    {
        const struct
        {
            const Mat& values;
            const char* name;
        } both[2] = {{dx, "dx"}, {dy, "dy"}};
        if (dx.empty() && dy.empty())
            return;
        for (const auto& one : both)
        {
            if (one.values.empty())
                CV_Error_(Error::StsBadSize,
                          ("%s is empty: must not be, unless both dx and dy are", one.name));
            if ((one.values.type() != CV_16SC1 && one.values.type() != CV_32FC1) ||
                one.values.dims != 2)
                CV_Error_(
                    Error::StsUnsupportedFormat,
                    ("%s has %d dimensions and type %s: must be CV_16SC1 or CV_32FC1 with two "
                     "dimensions",
                     one.name, one.values.dims, typeToString(one.values.type()).c_str()));
            if (one.values.size() != size)
                CV_Error_(Error::StsUnmatchedSizes,
                          ("%s has %d x %d pixels: must have the %d x %d of edges", one.name,
                           one.values.cols, one.values.rows, size.width, size.height));
        }
        if (dx.type() != dy.type())
            CV_Error_(Error::StsUnmatchedFormats,
                      ("dx has type %s and dy %s: must be the same",
                       typeToString(dx.type()).c_str(), typeToString(dy.type()).c_str()));
        for (const auto& one : both)
        {
            Point bad;
            if (one.values.type() == CV_32FC1 && findNotFinite(one.values, bad))
                CV_Error_(Error::StsOutOfRange, ("%s at (%d, %d) = %g: must be finite", one.name,
                                                 bad.x, bad.y, one.values.at<float>(bad)));
        }
    }

    Mat bits(const Mat& votes, double tolerance) const
    {
        if (!dx.empty())
            return directionBits(votes, dx, dy, tolerance);
        Mat estimatedX, estimatedY;
        estimateGradients(votes, estimatedX, estimatedY);
        return directionBits(votes, estimatedX, estimatedY, tolerance);
    }
};

//! Clears a table's row of cells and writes both triangles of one cell into the output.
void writeCell(const VoteTable& table, const Cell& cell, size_t cellIndex, Mat out)
{
    out.setTo(0);
    size_t chord = 0;
    for (int s = 0; s < cell.firstPoint(SIDE_LEFT); ++s)
    {
        int* row = out.ptr<int>(s);
        for (int e = cell.firstPartner(cell.sideOf(s)); e < cell.borderCount(); ++e, ++chord)
        {
            row[e] = table.at(chord, cellIndex);
            out.ptr<int>(e)[s] = row[e];
        }
    }
}

class LineSpaceDetectorImpl CV_FINAL : public LineSpaceDetector
{
public:
    explicit LineSpaceDetectorImpl(const Parameters& parameters)
        : parameters_(parameters), activeBackend_(-1)
    {
    }

    void detect(InputArray edges, OutputArray lines) CV_OVERRIDE
    {
        const Gradients none = {false, Mat(), Mat()};
        detectLines(edges, none, lines);
    }

    void detect(InputArray edges, InputArray dx, InputArray dy, OutputArray lines) CV_OVERRIDE
    {
        const Gradients gradients = {true, dx.getMat(), dy.getMat()};
        detectLines(edges, gradients, lines);
    }

    void compute(InputArray edges, OutputArray lineSpace) CV_OVERRIDE
    {
        withMemoryFor("edges", edges.size(), [&]() { writeLevel(edges, -1, lineSpace); });
    }

    void computeLevel(InputArray edges, int level, OutputArray cascade) CV_OVERRIDE
    {
        checkRange(level, 0, 62, "level", "0 to getLevelCount() - 1");
        withMemoryFor("edges", edges.size(), [&]() { writeLevel(edges, level, cascade); });
    }

    Size getFrameSize() const CV_OVERRIDE
    {
        return plan_ ? Size(plan_->frame().width, plan_->frame().height) : Size();
    }
    int getLevelCount() const CV_OVERRIDE { return plan_ ? plan_->levelCount() : 0; }
    Size getLevelCellSize(int level) const CV_OVERRIDE
    {
        const Cell cell = levelOf(level).cell;
        return Size(cell.width, cell.height);
    }
    Size getLevelGridSize(int level) const CV_OVERRIDE { return levelOf(level).grid; }
    int getActiveBackend() const CV_OVERRIDE { return activeBackend_; }
    void getDeviations(OutputArray deviations) const CV_OVERRIDE
    {
        checkOutput(deviations, "deviations");
        writeVectors(deviations_, deviations);
    }

#define LINESPACE_PARAMETER(Type, Name, name)                                                      \
    void set##Name(Type value) CV_OVERRIDE                                                         \
    {                                                                                              \
        Parameters changed = parameters_;                                                          \
        changed.name = value;                                                                      \
        changed.check();                                                                           \
        parameters_ = changed;                                                                     \
    }                                                                                              \
    Type get##Name() const CV_OVERRIDE                                                             \
    {                                                                                              \
        return parameters_.name;                                                                   \
    }

    LINESPACE_PARAMETER(int, Threshold, threshold)
    LINESPACE_PARAMETER(int, MaxLines, maxLines)
    LINESPACE_PARAMETER(int, Method, method)
    LINESPACE_PARAMETER(int, CellSize, cellSize)
    LINESPACE_PARAMETER(int, Backend, backend)
    LINESPACE_PARAMETER(int, Suppression, suppression)
    LINESPACE_PARAMETER(int, SuppressionRadius, suppressionRadius)
    LINESPACE_PARAMETER(double, SuppressionDistance, suppressionDistance)
    LINESPACE_PARAMETER(int, Selection, selection)
    LINESPACE_PARAMETER(int, Refine, refine)
    LINESPACE_PARAMETER(double, CandidateRatio, candidateRatio)
    LINESPACE_PARAMETER(int, PoolSize, poolSize)
    LINESPACE_PARAMETER(double, OrientationTolerance, orientationTolerance)
    LINESPACE_PARAMETER(double, FalseAlarms, falseAlarms)
    LINESPACE_PARAMETER(bool, EdgeWeights, edgeWeights)
    LINESPACE_PARAMETER(int, MemoryLimit, memoryLimit)
#undef LINESPACE_PARAMETER

    void setAngleRange(double minTheta, double maxTheta) CV_OVERRIDE
    {
        Parameters changed = parameters_;
        changed.minTheta = minTheta;
        changed.maxTheta = maxTheta;
        changed.check();
        parameters_ = changed;
    }
    void getAngleRange(double& minTheta, double& maxTheta) const CV_OVERRIDE
    {
        minTheta = parameters_.minTheta;
        maxTheta = parameters_.maxTheta;
    }

    void setMask(InputArray mask) CV_OVERRIDE
    {
        if (mask.empty())
        {
            mask_.release();
            return;
        }
        const Mat given = mask.getMat();
        checkImage(given, "mask");
        mask_ = given.clone();
    }
    void getMask(OutputArray mask) const CV_OVERRIDE
    {
        if (mask_.empty())
            mask.release();
        else
            mask_.copyTo(mask);
    }

    void write(FileStorage& fs) const CV_OVERRIDE
    {
        writeFormat(fs);
        const Parameters& p = parameters_;
        fs << "threshold" << p.threshold << "maxLines" << p.maxLines << "method" << p.method;
        fs << "cellSize" << p.cellSize << "backend" << p.backend << "suppression" << p.suppression;
        fs << "suppressionRadius" << p.suppressionRadius << "suppressionDistance"
           << p.suppressionDistance;
        fs << "selection" << p.selection << "refine" << p.refine << "candidateRatio"
           << p.candidateRatio << "poolSize" << p.poolSize;
        fs << "minTheta" << p.minTheta << "maxTheta" << p.maxTheta << "orientationTolerance"
           << p.orientationTolerance << "falseAlarms" << p.falseAlarms;
        fs << "edgeWeights" << (int)p.edgeWeights << "memoryLimit" << p.memoryLimit;
    }
    void read(const FileNode& fn) CV_OVERRIDE
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
        readInto(fn, "memoryLimit", p.memoryLimit);
        p.check();
        parameters_ = p;
    }
    //! Never: the parameters are always complete. (Algorithm::load gives up on what is empty after
    //! read.)
    bool empty() const CV_OVERRIDE
    {
        return false;
    }
    //! Frees the plan and the buffers; the parameters and the mask stay.
    void clear() CV_OVERRIDE
    {
        plan_.reset();
        executor_.reset();
        result_.buffer.release();
        spare_.buffer.release();
        planes_.clear();
        left_.clear();
        strips_.clear();
        deviations_.clear();
        activeBackend_ = -1;
    }
    String getDefaultName() const CV_OVERRIDE
    {
        return "LineSpaceDetector";
    }

private:
    void detectLines(InputArray edges, const Gradients& gradients, OutputArray lines)
    {
        checkOutput(lines, "lines");
        withMemoryFor("edges", edges.size(),
                      [&]()
                      {
                          EdgeMap map;
                          const Count counted = count(edges, gradients, -1, map);
                          std::vector<Vec3f> found, deviations;
                          findLines(map, counted, found, deviations);
                          writeVectors(found, lines);
                          deviations_.swap(deviations);
                          keep(counted);
                      });
    }

    template<class Value>
    static void readInto(const FileNode& fn, const char* name, Value& value)
    {
        const FileNode node = fn[name];
        if (node.empty())
            return;
        if (!node.isInt() && !node.isReal())
            CV_Error_(Error::StsParseError, ("%s is not a number: must be one", name));
        node >> value;
    }

    static void checkOutput(OutputArray out, const char* name)
    {
        if (out.fixedType() && out.type() != CV_32FC3)
            CV_Error_(Error::StsUnsupportedFormat,
                      ("%s has type %s: must be CV_32FC3", name, typeToString(out.type()).c_str()));
    }

    static void writeVectors(const std::vector<Vec3f>& vectors, OutputArray out)
    {
        if (vectors.empty())
        {
            out.release();
            return;
        }
        Mat((int)vectors.size(), 1, CV_32FC3, (void*)vectors.data()).copyTo(out);
    }

    const Level& levelOf(int level) const
    {
        checkRange(level, 0, getLevelCount() - 1, "level",
                   "0 to getLevelCount() - 1, of the last call");
        return plan_->level(level);
    }

    Ptr<const Plan> planFor(Size size) const
    {
        const bool exact = parameters_.method == METHOD_EXACT;
        if (plan_ && plan_->imageSize() == size && planMethod_ == parameters_.method &&
            (exact || planCellSize_ == parameters_.cellSize))
            return plan_;
        return exact ? Plan::exact(size) : Plan::cascaded(size, parameters_.cellSize);
    }

    //! Bytes that lines need after the votes, but for the candidates themselves if all are asked
    //! for: how many there are is known too late.
    double selectionBytes(const Plan& plan, bool oriented) const
    {
        // Of the whole map, of what lines taken leave of it, and of an executor that counts again.
        const int copies = 1 + (parameters_.selection == SELECT_EXPLAIN) + (ascentRadius() == 0);
        return copies * EdgePlanes::memory(plan.frame(), parameters_.edgeWeights, oriented) +
               (ascentRadius() > 0
                    ? ascentMemory(plan.frame(), parameters_.maxLines > 0 ? poolSize() : 0)
                    : 0);
    }

    //! Candidates that are counted exactly.
    size_t poolSize() const
    {
        const int64 most = std::max<int64>(parameters_.poolSize, 16 * (int64)parameters_.maxLines);
        return (size_t)std::min<int64>(most, INT_MAX); // where size_t has 32 bits
    }

    void checkMemory(const Plan& plan, bool oriented, int level, double resultBytes) const
    {
        const double bytes =
            workingMemory(plan, parameters_.edgeWeights, oriented, level) + resultBytes;
        const double mebibytes = bytes / (1 << 20);
        if (mebibytes > parameters_.memoryLimit)
            CV_Error_(Error::StsNoMem,
                      ("edges of %d x %d pixels need %.0f MiB of memory: must be at most "
                       "memoryLimit = %d MiB",
                       plan.imageSize().width, plan.imageSize().height, mebibytes,
                       parameters_.memoryLimit));
    }

    //! What votes were counted by.
    struct Count
    {
        Ptr<const Plan> plan;
        Ptr<Executor> executor;
    };

    //! What the detector tells of its last call from now on; nothing of the call can fail any more.
    void keep(const Count& counted)
    {
        plan_ = counted.plan;
        planMethod_ = parameters_.method;
        planCellSize_ = parameters_.cellSize;
        executor_ = counted.executor;
        activeBackend_ = executor_->backend();
    }

    //! Counts the votes of a level (-1: the last one) into result_, and changes nothing else.
    Count count(InputArray input, const Gradients& gradients, int level, EdgeMap& edges,
                bool writesTable = false)
    {
        const Mat image = input.getMat();
        checkImage(image, "edges");
        if (!mask_.empty() && mask_.size() != image.size())
            CV_Error_(Error::StsUnmatchedSizes,
                      ("mask has %d x %d pixels: must have the %d x %d of edges", mask_.cols,
                       mask_.rows, image.cols, image.rows));
        gradients.check(image.size());
        // Border points are numbered by int.
        if ((int64)image.cols + image.rows > (1 << 28))
            CV_Error_(Error::StsOutOfRange,
                      ("edges has %d x %d pixels: width + height must be at most 2^28", image.cols,
                       image.rows));
        const Ptr<const Plan> plan = planFor(image.size());
        if (level < 0)
            level = plan->levelCount() - 1;
        checkRange(level, 0, plan->levelCount() - 1, "level",
                   "less than the number of levels of this image size");
        checkMemory(*plan, gradients.isOriented, level,
                    writesTable ? tableBytes(plan->level(level), image.size())
                                : selectionBytes(*plan, gradients.isOriented));
        const Ptr<Executor> executor = executorFor(parameters_.backend, executor_);

        edges.weighted = parameters_.edgeWeights;
        edges.votes = votingPixels(image);
        if (gradients.isOriented)
        {
            edges.directions = gradients.bits(edges.votes, parameters_.orientationTolerance);
            edges.isEstimated = gradients.dx.empty();
            edges.dx = gradients.dx;
            edges.dy = gradients.dy;
        }
        countVotes(*executor, edges, *plan, parameters_.method == METHOD_EXACT, level, spare_,
                   result_);
        const Count counted = {plan, executor};
        return counted;
    }

    Mat votingPixels(const Mat& image) const
    {
        Mat votes;
        if (parameters_.edgeWeights)
            votes = image.clone();
        else
            threshold(image, votes);
        if (!mask_.empty())
        {
            Mat masked = Mat::zeros(votes.size(), CV_8UC1);
            votes.copyTo(masked, mask_);
            votes = masked;
        }
        return votes;
    }

    //! 1 where the image is not 0.
    static void threshold(const Mat& image, Mat& votes)
    {
        cv::min(image, Scalar(1), votes);
    }

    //! Bytes of a level's output; throws if an array cannot be so large.
    static double tableBytes(const Level& level, Size size)
    {
        const double rows = (double)level.grid.height * level.cell.borderCount();
        const double columns = (double)level.grid.width * level.cell.borderCount();
        const double bytes = rows * columns * sizeof(int);
        if (bytes > INT_MAX)
            CV_Error_(Error::StsNoMem, ("edges of %d x %d pixels have a table of %.0f x %.0f "
                                        "votes, %.0f MiB: must be at most "
                                        "2047 MiB; use detect, or a smaller edge map",
                                        size.width, size.height, rows, columns, bytes / (1 << 20)));
        return bytes;
    }

    void writeLevel(InputArray edges, int level, OutputArray out)
    {
        if (out.fixedType() && out.type() != CV_32SC1)
            CV_Error_(Error::StsUnsupportedFormat, ("the output has type %s: must be CV_32SC1",
                                                    typeToString(out.type()).c_str()));
        EdgeMap map;
        const Gradients none = {false, Mat(), Mat()};
        const Count counted = count(edges, none, level, map, true);
        const Plan& plan = *counted.plan;
        const int l = level < 0 ? plan.levelCount() - 1 : level;
        const Level& shape = plan.level(l);
        const int points = shape.cell.borderCount();
        std::vector<int> rowBits, columnBits;
        plan.cellOrder(l, rowBits, columnBits);
        Mat table(shape.grid.height * points, shape.grid.width * points, CV_32SC1);
        for (int r = 0; r < shape.grid.height; ++r)
            for (int c = 0; c < shape.grid.width; ++c)
                writeCell(result_, shape.cell, rowBits[r] + columnBits[c],
                          table(Rect(c * points, r * points, points, points)));
        if (out.fixedSize() || out.isUMat())
            table.copyTo(out);
        else
            out.assign(table);
        keep(counted);
    }

    //! How many edge pixels vote for the chords of each bin; of a map that is not oriented, for
    //! all. Estimated directions follow the pixels of the chord itself, so they are no independent
    //! evidence against chance: all pixels, to be on the safe side.
    static std::vector<int> votersOf(const EdgeMap& edges)
    {
        if (!edges.isOriented() || edges.isEstimated)
            return std::vector<int>(1, countNonZero(edges.votes));
        std::vector<int> voters(DIRECTION_BINS, 0);
        for (int y = 0; y < edges.directions.rows; ++y)
        {
            const ushort* bits = edges.directions.ptr<ushort>(y);
            for (int x = 0; x < edges.directions.cols; ++x)
                for (int bin = 0; bits[x] >> bin; ++bin)
                    voters[bin] += bits[x] >> bin & 1;
        }
        return voters;
    }

    Requirement requirementFor(const EdgeMap& edges, const Plan& plan) const
    {
        Requirement requirement;
        requirement.threshold = parameters_.threshold;
        if (parameters_.threshold > 0)
            return requirement;
        // Where the mask is 0 nothing can vote; a chord's length still counts it, which is on the
        // safe side.
        const double pixels = mask_.empty() ? (double)edges.votes.total() : countNonZero(mask_);
        const int longest = std::max(edges.votes.cols, edges.votes.rows);
        const std::vector<int> voters = votersOf(edges);
        // Nothing shorter than the first length that can be significant needs to be looked at.
        requirement.threshold = INT_MAX;
        for (size_t bin = 0; bin < voters.size(); ++bin)
        {
            const double density = pixels > 0 ? voters[bin] / pixels : 0;
            const std::vector<int> votes = significantVotes(
                longest, density, (double)plan.frame().chordCount(), parameters_.falseAlarms);
            for (int length = 0; length <= longest; ++length)
                if (votes[length] <= length)
                {
                    requirement.threshold =
                        std::min(requirement.threshold, std::max(0, votes[length] - 1));
                    break;
                }
            requirement.pixels.push_back(votes);
        }
        return requirement;
    }

    void findLines(const EdgeMap& edges, const Count& counted, std::vector<Vec3f>& lines,
                   std::vector<Vec3f>& deviations)
    {
        const Plan& plan = *counted.plan;
        const Requirement requirement = requirementFor(edges, plan);
        if (requirement.threshold == INT_MAX)
            return;
        const AngleInterval angles = {parameters_.minTheta, parameters_.maxTheta};
        const Cell& frame = plan.frame();

        // The exact method's votes need no second count and no lower threshold.
        const bool exact = parameters_.method == METHOD_EXACT;
        const double ratio = exact ? 1 : parameters_.candidateRatio;
        const int minVotes = cvFloor(ratio * requirement.threshold);
        const bool parallel = ascentRadius() > 0 && parameters_.suppression == SUPPRESS_RING &&
                              parameters_.suppressionRadius <= MAX_ASCENT_RADIUS;
        Wanted wanted;
        wanted.threshold = minVotes;
        wanted.most =
            !exact && parameters_.maxLines > 0 ? poolSize() : std::numeric_limits<size_t>::max();
        if (!requirement.pixels.empty() || !angles.isFull())
            wanted.accepts = [&](const Candidate& candidate)
            {
                return requirement.canBeMet(plan, candidate, ratio) &&
                       isInInterval(frame, angles, candidate);
            };
        std::vector<Candidate> candidates =
            parallel ? findParallelMaxima(result_, frame, wanted)
                     : findCandidates(result_, frame, wanted, parameters_.suppression,
                                      parameters_.suppressionRadius);
        const bool explain = parameters_.selection == SELECT_EXPLAIN;
        planes_.reset(edges, frame);
        if (!exact)
            recount(edges, plan, *counted.executor, candidates);
        removeIf(candidates,
                 [&](const Candidate& candidate)
                 {
                     return !requirement.isMet(planes_, plan, candidate) ||
                            !isInInterval(frame, angles, candidate);
                 });
        SelectionRule rule;
        rule.requirement = requirement;
        rule.explain = explain;
        rule.distance = parameters_.suppressionDistance;
        rule.most = parameters_.maxLines > 0 ? (size_t)parameters_.maxLines
                                             : std::numeric_limits<size_t>::max();
        rule.refine = [&](Chord chord)
        {
            return refined(edges, frame, chord, angles);
        };
        if (explain)
            planes_.copyTo(left_);
        const std::vector<Selected> chosen =
            selectLines(plan, rule, candidates, explain ? left_ : planes_);
        for (size_t i = 0; i < chosen.size(); ++i)
        {
            FittedLine fitted = chosen[i].fitted;
            const bool wasNegative = std::signbit(fitted.line.rho);
            angles.represent(fitted.line);
            if (std::signbit(fitted.line.rho) != wasNegative) // also of a rho of 0
                fitted.covariance.rhoTheta = -fitted.covariance.rhoTheta;
            const Vec2f polar = angles.round(fitted.line);
            if (!angles.contains(
                    polar[1])) // an interval narrower than a float's step may hold none
                continue;
            lines.push_back(Vec3f(polar[0], polar[1], (float)chosen[i].candidate.votes));
            deviations.push_back(fitted.covariance.deviations());
        }
    }

    //! The table of METHOD_EXACT holds exact votes: its maxima are maxima of these.
    int ascentRadius() const
    {
        return parameters_.method == METHOD_EXACT
                   ? 0
                   : std::min<int>(parameters_.suppressionRadius, MAX_ASCENT_RADIUS);
    }

    static bool isInInterval(const Cell& frame, const AngleInterval& angles,
                             const Candidate& candidate)
    {
        if (angles.isFull())
            return true;
        Line line = lineOf(frame, candidate.chord());
        return angles.represent(line);
    }

    //! Counts candidates of the cascade exactly, or lets them climb (section 4.2).
    void recount(const EdgeMap& edges, const Plan& plan, Executor& executor,
                 std::vector<Candidate>& candidates)
    {
        if (ascentRadius() > 0)
        {
            const ChordCounter counter(planes_);
            strips_.reset(counter, plan.frame());
            climbToMaxima(counter, plan.frame(), ascentRadius(), strips_, candidates);
            return;
        }
        std::vector<Chord> chords(candidates.size());
        for (size_t i = 0; i < chords.size(); ++i)
            chords[i] = candidates[i].chord();
        std::vector<int> votes;
        executor.rescore(edges, plan, chords, votes);
        for (size_t i = 0; i < candidates.size(); ++i)
            candidates[i].votes = votes[i];
    }

    //! The line to report for a chord: one that leaves the interval of angles stays as it was.
    FittedLine refined(const EdgeMap& edges, const Cell& frame, Chord chord,
                       const AngleInterval& angles) const
    {
        const FittedLine line = chordLine(frame, chord);
        if (parameters_.refine == REFINE_NONE)
            return line;
        const FittedLine result = refineLine(edges, planes_, directionBit(frame, chord), line);
        Line inInterval = result.line;
        return angles.represent(inInterval) ? result : line;
    }

    template<class Predicate>
    static void removeIf(std::vector<Candidate>& candidates, Predicate predicate)
    {
        candidates.erase(std::remove_if(candidates.begin(), candidates.end(), predicate),
                         candidates.end());
    }

    Parameters parameters_;
    Mat mask_;
    Ptr<const Plan> plan_;
    int planMethod_, planCellSize_;
    Ptr<Executor> executor_;
    int activeBackend_;
    VoteTable result_, spare_;
    EdgePlanes planes_, left_; // left_: see selectLines
    VoteStrips strips_;
    std::vector<Vec3f> deviations_; // of the lines of the last detect
};

} // namespace

Ptr<LineSpaceDetector> LineSpaceDetector::create(int threshold, int maxLines, int method,
                                                 int cellSize, int backend)
{
    Parameters parameters;
    parameters.threshold = threshold;
    parameters.maxLines = maxLines;
    parameters.method = method;
    parameters.cellSize = cellSize;
    parameters.backend = backend;
    parameters.check();
    return makePtr<LineSpaceDetectorImpl>(parameters);
}

} // namespace linespace
} // namespace cv
