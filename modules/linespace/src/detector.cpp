// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The public detector: checks arguments, keeps parameters, chooses the back end and calls the
// stages in order. No mathematics of its own.

#include "angle_ends.hpp"
#include "ascent.hpp"
#include "backends.hpp"
#include "bundles.hpp"
#include "edge_bits.hpp"
#include "gradients.hpp"
#include "line_geometry.hpp"
#include "parameters.hpp"
#include "refine.hpp"
#include "selection.hpp"
#include "stage_times.hpp"
#include "strips/strip_candidates.hpp"

#include <opencv2/core/ocl.hpp>

#include <climits>
#include <cmath>
#include <limits>

namespace cv {
namespace linespace {

namespace {

//! The size of an image that can be counted; throws if it cannot. A vector is an image of one row,
//! which OpenCV 5 gives one dimension.
Size checkedSize(InputArray image, const char* name)
{
    if (image.empty())
        CV_Error_(Error::StsBadSize, ("%s is empty: must be at least 1 x 1", name));
    if (image.type() != CV_8UC1)
        CV_Error_(Error::StsUnsupportedFormat,
                  ("%s has %d dimensions and type %s: must be CV_8UC1 with two dimensions", name,
                   image.dims(), typeToString(image.type()).c_str()));
    if (image.dims() > 2)
        CV_Error_(Error::StsBadSize, ("%s has %d dimensions: must be two", name, image.dims()));
    return image.size();
}

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

const int MOST_PRUNED_RADIUS = 4;
const size_t MOST_FAILED_SIZES = 16;
const int LIST_PAUSE = 16;

//! METHOD_STRIPS with SELECT_EXPLAIN: York's recall at 2 px, strongest 100, was 0.629, 0.703 and 0.706
//! with 1, 4 and 8 of them (perf/accuracy.sh); each costs time.
const size_t CANDIDATES_PER_LINE = 4;

class LineSpaceDetectorImpl CV_FINAL : public LineSpaceDetector
{
public:
    explicit LineSpaceDetectorImpl(const Parameters& parameters)
        : parameters_(parameters), executors_(BACKEND_OPENGL + 1), activeBackend_(-1), listPause_(0)
    {
    }

    void detect(InputArray edges, OutputArray lines) CV_OVERRIDE
    {
        detectLines(edges, Gradients::none(), lines);
    }

    void detect(InputArray edges, InputArray dx, InputArray dy, OutputArray lines) CV_OVERRIDE
    {
        detectLines(edges, Gradients::of(dx, dy), lines);
    }

    void detectTexture(unsigned int texture, OutputArray lines) CV_OVERRIDE
    {
        checkOutput(lines, "lines");
        if (parameters_.backend != BACKEND_AUTO && parameters_.backend != BACKEND_OPENGL)
            CV_Error_(Error::StsBadArg, ("backend = %d: detectTexture must have BACKEND_AUTO or "
                                         "BACKEND_OPENGL",
                                         parameters_.backend));
        Counting counting;
        EdgeMap map;
        Size size;
        counting.executor = executorFor(BACKEND_OPENGL, false, executors_);
        try
        {
            {
                const WorkingTime time(*counting.executor);
                size = counting.executor->textureSize(texture);
            }
            withMemoryFor("texture", size,
                          [&]() { detectTaken(texture, size, map, counting, lines); });
        }
        catch (const DeviceFailure& failure)
        {
            substituteFor(BACKEND_OPENGL, failure); // which throws: nobody else has the texture
        }
    }

    void compute(InputArray edges, OutputArray lineSpace) CV_OVERRIDE
    {
        withMemoryFor("edges", checkedSize(edges, "edges"),
                      [&]() { writeLevel(edges, -1, lineSpace); });
    }

    void computeLevel(InputArray edges, int level, OutputArray cascade) CV_OVERRIDE
    {
        checkRange(level, 0, 62, "level", "0 to getLevelCount() - 1");
        withMemoryFor("edges", checkedSize(edges, "edges"),
                      [&]() { writeLevel(edges, level, cascade); });
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

    void getStageTimes(std::vector<String>& stages,
                       std::vector<double>& milliseconds) const CV_OVERRIDE
    {
        stages = stageTimes_.names();
        milliseconds = stageTimes_.milliseconds();
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
    LINESPACE_PARAMETER(bool, Pruning, pruning)
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
        checkedSize(mask, "mask");
        mask_ = mask.getMat().clone();
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
        parameters_.write(fs);
    }
    void read(const FileNode& fn) CV_OVERRIDE
    {
        parameters_ = Parameters::read(fn);
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
        tables_.release(); // before the device that they are on
        executors_.assign(executors_.size(), Ptr<Executor>());
        images_ = Images();
        bundles_.clear();
        planes_.clear();
        left_.clear();
        bits_.clear();
        squares_.clear();
        strips_.clear();
        angleEnds_ = AngleEnds();
        listPause_ = 0;
        deviations_.clear();
        stageTimes_ = StageTimes();
        activeBackend_ = -1;
        failedSizes_.clear();
    }
    String getDefaultName() const CV_OVERRIDE
    {
        return "LineSpaceDetector";
    }

private:
    void detectLines(InputArray edges, const Gradients& gradients, OutputArray lines)
    {
        checkOutput(lines, "lines");
        withMemoryFor("edges", checkedSize(edges, "edges"),
                      [&]()
                      {
                          const Input input = {edges, gradients};
                          EdgeMap map;
                          Counting counting;
                          if (parameters_.method == METHOD_STRIPS)
                              checkBackendForStrips();
                          prepare(input, -1, false, map, counting);
                          std::vector<Vec3f> found, deviations;
                          findLines(input, map, counting, found, deviations);
                          writeVectors(found, lines);
                          deviations_.swap(deviations);
                          keep(counting);
                      });
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

    //! METHOD_STRIPS has no tables of its own to write.
    int methodFor(bool writesTable) const
    {
        return parameters_.method == METHOD_STRIPS && writesTable ? (int)METHOD_CASCADED
                                                                  : parameters_.method;
    }

    Ptr<const Plan> planFor(Size size, int method) const
    {
        const bool isCascaded = method == METHOD_CASCADED;
        if (plan_ && plan_->imageSize() == size && planMethod_ == method &&
            (!isCascaded || planCellSize_ == parameters_.cellSize))
            return plan_;
        return isCascaded ? Plan::cascaded(size, parameters_.cellSize) : Plan::exact(size);
    }

    //! What METHOD_STRIPS cannot do, the others can.
    void checkForStrips(const char* name, Size size) const
    {
        // Places in the tables are counted by int.
        if (StripCandidates::memory(size, parameters_.edgeWeights) > INT_MAX)
            CV_Error_(Error::StsOutOfRange,
                      ("%s has %d x %d pixels: its tables must be at most 2047 MiB for "
                       "METHOD_STRIPS; METHOD_CASCADED has other limits",
                       name, size.width, size.height));
        const int radius = parameters_.suppressionRadius;
        if (parameters_.suppression != SUPPRESS_RING || radius < 1 || radius > MAX_ASCENT_RADIUS)
            CV_Error_(Error::StsBadArg,
                      ("suppression = %d with suppressionRadius = %d: must be SUPPRESS_RING (0) "
                       "with 1 or 2 for METHOD_STRIPS; METHOD_CASCADED takes any",
                       parameters_.suppression, radius));
    }
    void checkBackendForStrips() const
    {
        if (parameters_.backend == BACKEND_OPENCL || parameters_.backend == BACKEND_OPENGL)
            CV_Error_(
                Error::StsNotImplemented,
                ("backend = %s: METHOD_STRIPS does not run there yet, must be BACKEND_AUTO, "
                 "BACKEND_CPU or BACKEND_REFERENCE; METHOD_CASCADED runs on any",
                 parameters_.backend == BACKEND_OPENCL ? "BACKEND_OPENCL" : "BACKEND_OPENGL"));
    }

    //! Bytes that METHOD_STRIPS needs, but for lists.
    double stripBytes(Size image, bool isOriented) const
    {
        const bool weighted = parameters_.edgeWeights;
        const Cell frame(image.width, image.height);
        const double pixels = (double)image.width * image.height;
        const int copies = 1 + (parameters_.selection == SELECT_EXPLAIN);
        return (1 + !mask_.empty() + 2 * isOriented) * pixels +
               copies * EdgePlanes::memory(frame, weighted, isOriented) +
               StripCandidates::memory(image, weighted);
    }

    //! Bytes that lines need after the votes, but for the candidates themselves if all are asked
    //! for: how many there are is known too late.
    double selectionBytes(const Plan& plan, bool oriented) const
    {
        // Of the whole map, of what lines taken leave of it, and of an executor that counts again.
        const bool recounts = parameters_.method != METHOD_EXACT && ascentRadius() == 0;
        const int copies = 1 + (parameters_.selection == SELECT_EXPLAIN) + recounts;
        const int base = prunes() ? BundleSearch::baseLevel(plan, parameters_.edgeWeights) : -1;
        return copies * EdgePlanes::memory(plan.frame(), parameters_.edgeWeights, oriented) +
               (ascentRadius() > 0
                    ? ascentMemory(plan.frame(), !oriented && !parameters_.edgeWeights,
                                   parameters_.maxLines > 0 ? poolSize() : 0)
                    : 0) +
               (base >= 0 ? BundleSearch::memory(plan, base) : 0);
    }

    //! Candidates that are counted exactly.
    size_t poolSize() const
    {
        const int64 most = std::max<int64>(parameters_.poolSize, 16 * (int64)parameters_.maxLines);
        return (size_t)std::min<int64>(most, INT_MAX); // where size_t has 32 bits
    }

    void checkMemory(const char* name, Size size, double bytes) const
    {
        const double mebibytes = bytes / (1 << 20);
        if (mebibytes > parameters_.memoryLimit)
            CV_Error_(Error::StsNoMem,
                      ("%s of %d x %d pixels need %.0f MiB of memory: must be at most "
                       "memoryLimit = %d MiB",
                       name, size.width, size.height, mebibytes, parameters_.memoryLimit));
    }

    //! What an edge map is made of; kept, so that the next one needs no memory.
    struct Images
    {
        Mat votes, masked, directions;
        OrientedPixels oriented;
        EstimatedGradients estimated;
    };

    //! What votes were counted by.
    struct Counting
    {
        Ptr<const Plan> plan;
        Ptr<Executor> executor;
        int method; //!< METHOD_CASCADED where tables of METHOD_STRIPS are asked for
        int level;  //!< whose votes were counted last
        StageTimes times;
    };

    //! What a user gives.
    struct Input
    {
        InputArray edges;
        const Gradients& gradients;
    };

    //! What the detector tells of its last call from now on; nothing of the call can fail any more.
    void keep(const Counting& counting)
    {
        plan_ = counting.plan;
        planMethod_ = counting.method;
        planCellSize_ = parameters_.cellSize;
        activeBackend_ = counting.executor->backend();
        executors_[activeBackend_] = counting.executor;
        stageTimes_ = counting.times;
    }

    /** Makes the plan of an image that was checked, and what an edge map has on a device.
    @param level of which the votes are wanted; -1: of the last one. */
    void prepare(const Input& input, int level, bool writesTable, EdgeMap& edges,
                 Counting& counting)
    {
        prepare("edges", input.edges.size(), input.gradients, level, writesTable, edges, counting);
        edges.source = onDevice(input.edges);
        edges.mask = mask_;
    }

    //! The same but for what an edge map has on OpenCV's device.
    void prepare(const char* name, Size size, const Gradients& gradients, int level,
                 bool writesTable, EdgeMap& edges, Counting& counting)
    {
        counting.times.restart();
        if (!mask_.empty() && mask_.size() != size)
            CV_Error_(Error::StsUnmatchedSizes,
                      ("mask has %d x %d pixels: must have the %d x %d of %s", mask_.cols,
                       mask_.rows, size.width, size.height, name));
        gradients.check(size);
        // Border points are numbered by int.
        if ((int64)size.width + size.height > (1 << 28))
            CV_Error_(Error::StsOutOfRange,
                      ("%s has %d x %d pixels: width + height must be at most 2^28", name,
                       size.width, size.height));
        counting.method = methodFor(writesTable);
        if (counting.method == METHOD_STRIPS)
            checkForStrips(name, size);
        const Ptr<const Plan> plan = planFor(size, counting.method);
        counting.level = level < 0 ? plan->levelCount() - 1 : level;
        checkRange(counting.level, 0, plan->levelCount() - 1, "level",
                   "less than the number of levels of this image size");
        const bool isOriented = gradients.isOriented;
        checkMemory(
            name, size,
            counting.method == METHOD_STRIPS
                ? stripBytes(size, isOriented)
                : workingMemory(*plan, parameters_.edgeWeights, isOriented, counting.level) +
                      (writesTable ? tableBytes(plan->level(counting.level), size)
                                   : selectionBytes(*plan, isOriented)));
        counting.plan = plan;
        edges.weighted = parameters_.edgeWeights;
    }

    //! Brings the edge map to the host, if it is not there.
    void readEdges(const Input& input, EdgeMap& edges, Executor& executor, Counting& counting)
    {
        if (!edges.votes.empty())
            return;
        if (edges.isTaken)
        {
            readTaken(edges, executor, counting);
            return;
        }
        const Gradients& gradients = input.gradients;
        if (!edges.directionsOnDevice.empty() && executor.takesUMats())
            readOriented(gradients, edges, executor, counting);
        else
        {
            edges.votes = votingPixels(input.edges.getMat());
            if (gradients.isOriented)
            {
                const Gradients read = gradients.onHost();
                if (gradients.areOnDevice())
                    read.check(edges.votes.size());
                read.findBits(edges.votes, parameters_.orientationTolerance, images_.estimated,
                              images_.directions);
                edges.directions = images_.directions;
                edges.dx = read.dx;
                edges.dy = read.dy;
            }
        }
        edges.isEstimated = gradients.areEstimated();
        counting.times.end("edge map");
    }

    void readOriented(const Gradients& gradients, EdgeMap& edges, Executor& executor,
                      const Counting& counting)
    {
        const bool readsGradients = parameters_.refine != REFINE_NONE;
        OrientedPixels& pixels = images_.oriented;
        executor.readOriented(edges, *counting.plan, readsGradients ? gradients.dxOnDevice : UMat(),
                              readsGradients ? gradients.dyOnDevice : UMat(), pixels);
        if (!pixels.areFinite)
            gradients.onHost().check(pixels.votes.size()); // tells which one is not
        edges.votes = pixels.votes;
        edges.directions = pixels.directions;
        edges.dx = pixels.dx;
        edges.dy = pixels.dy;
    }

    //! From the executor that took the map, which is not at work if another one is in its place.
    void readTaken(EdgeMap& edges, const Executor& executor, const Counting& counting)
    {
        Executor& taker = *counting.executor;
        if (&taker == &executor)
            taker.readTaken(images_.votes);
        else
        {
            const WorkingTime time(taker);
            taker.readTaken(images_.votes);
        }
        edges.votes = images_.votes;
    }

    void detectTaken(unsigned int texture, Size size, EdgeMap& map, Counting& counting,
                     OutputArray lines)
    {
        const Gradients none = Gradients::none();
        prepare("texture", size, none, -1, false, map, counting);
        {
            const WorkingTime time(*counting.executor);
            counting.executor->takeTexture(texture, map.weighted, mask_);
            if (parameters_.threshold == 0)
                map.voters = counting.executor->countTaken();
        }
        map.isTaken = true;
        counting.times.end("edge map");
        std::vector<Vec3f> found, deviations;
        const Input input = {noArray(), none};
        findLines(input, map, counting, found, deviations);
        writeVectors(found, lines);
        deviations_.swap(deviations);
        keep(counting);
    }

    /** Calls work(executor) with the executor that is to count, and sets the counting's; changes
    nothing but what is kept for speed. */
    template<class Work>
    void runWith(bool isUMat, Counting& counting, Work work)
    {
        const Size size = counting.plan->imageSize();
        const bool avoidsDevice =
            parameters_.backend == BACKEND_AUTO && getDefaultBackend() == BACKEND_AUTO &&
            std::find(failedSizes_.begin(), failedSizes_.end(), size) != failedSizes_.end();
        if (!counting.executor)
            counting.executor = executorFor(avoidsDevice ? (int)BACKEND_CPU : parameters_.backend,
                                            isUMat, executors_);
        const Ptr<Executor> first = counting.executor;
        counting.executor = runOn(parameters_.backend, counting.executor,
                                  [&](Executor& executor)
                                  {
                                      // Tables of another device.
                                      if (&executor != executors_[executor.backend()].get())
                                          tables_.release();
                                      if (&executor != first.get()) // which failed
                                          counting.times.restart();
                                      work(executor);
                                  });
        if (counting.executor == first)
            return;
        if (failedSizes_.size() == MOST_FAILED_SIZES)
            failedSizes_.erase(failedSizes_.begin());
        failedSizes_.push_back(size);
        executors_[first->backend()].reset();
    }

    //! The image, or 1 where it is not 0, under the mask.
    const Mat& votingPixels(const Mat& image)
    {
        if (parameters_.edgeWeights)
            image.copyTo(images_.votes);
        else
            cv::min(image, Scalar(1), images_.votes);
        if (mask_.empty())
            return images_.votes;
        images_.masked.create(image.size(), CV_8UC1);
        images_.masked.setTo(0);
        images_.votes.copyTo(images_.masked, mask_);
        return images_.masked;
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
        const Gradients none = Gradients::none();
        const Input input = {edges, none};
        Counting counting;
        prepare(input, level, true, map, counting);
        const Plan& plan = *counting.plan;
        const int l = counting.level;
        runWith(edges.isUMat(), counting,
                [&](Executor& executor)
                {
                    if (!isOnDevice(map, executor, counting))
                        readEdges(input, map, executor, counting);
                    countVotes(executor, map, plan, parameters_.method == METHOD_EXACT, l, tables_,
                               counting.times);
                    write(executor, plan, l, out);
                    executor.settleTimes(counting.times);
                });
        keep(counting);
    }

    void write(Executor& executor, const Plan& plan, int l, OutputArray out)
    {
        VoteTable& table = tables_.of(l);
        const Level& level = plan.level(l);
        const int points = level.cell.borderCount();
        const Size size(level.grid.width * points, level.grid.height * points);
        if (out.isUMat() && executor.takesUMats())
        {
            out.create(size, CV_32SC1);
            const UMat onItsDevice = onDevice(out);
            if (!onItsDevice.empty())
            {
                executor.writeTable(plan, l, table, onItsDevice);
                return;
            }
        }
        executor.fetch(table);
        std::vector<int> rowBits, columnBits;
        plan.cellOrder(l, rowBits, columnBits);
        Mat written(size, CV_32SC1);
        for (int r = 0; r < level.grid.height; ++r)
            for (int c = 0; c < level.grid.width; ++c)
                writeCell(table, level.cell, rowBits[r] + columnBits[c],
                          written(Rect(c * points, r * points, points, points)));
        if (out.fixedSize() || out.isUMat())
            written.copyTo(out);
        else
            out.assign(written);
    }

    Requirement requirementFor(const EdgeMap& edges, const Plan& plan) const
    {
        if (parameters_.threshold > 0)
            return moreVotesThan(parameters_.threshold);
        const double pixels = mask_.empty() ? (double)plan.imageSize().area() : countNonZero(mask_);
        return significance(edges, pixels, plan, parameters_.falseAlarms);
    }

    //! Whether the executor needs no votes on the host.
    static bool isOnDevice(const EdgeMap& edges, const Executor& executor, const Counting& counting)
    {
        return (!edges.source.empty() && executor.takesUMats()) ||
               (edges.isTaken && &executor == counting.executor.get());
    }

    /** Whether lines can be found without planes on the host: the device counts all that is asked for,
    and the refinement has the pixels as bits. */
    bool staysOnDevice(const Input& input, const EdgeMap& edges, const Executor& executor) const
    {
        return executor.readsBits(edges) && !input.gradients.isOriented &&
               parameters_.selection != SELECT_EXPLAIN &&
               (parameters_.threshold > 0 || !parameters_.edgeWeights);
    }

    //! Whether the statistical rule asks first how many pixels vote.
    bool countsPixels(const EdgeMap& edges) const
    {
        return parameters_.threshold == 0 && edges.voters < 0;
    }

    //! The directions of a map that is on the device, for an executor that works there.
    void findDirections(Executor& executor, const Input& input, const Plan& plan,
                        EdgeMap& edges) const
    {
        const Gradients& gradients = input.gradients;
        if ((gradients.areOnDevice() || gradients.areEstimated()) && !edges.source.empty() &&
            edges.votes.empty() && executor.takesUMats())
            edges.directionsOnDevice =
                executor.findDirections(edges, plan, gradients.dxOnDevice, gradients.dyOnDevice,
                                        parameters_.orientationTolerance);
    }

    //! Copies of the edge map for all that counts and refines on the host.
    void readPlanes(const Input& input, EdgeMap& edges, Executor& executor, Counting& counting)
    {
        readEdges(input, edges, executor, counting);
        planes_.reset(edges, counting.plan->frame());
    }

    //! METHOD_STRIPS, which the host does, wherever the map is.
    void findStripLines(const Input& input, EdgeMap& edges, Counting& counting,
                        std::vector<Vec3f>& lines, std::vector<Vec3f>& deviations)
    {
        const Plan& plan = *counting.plan;
        const AngleInterval angles = {parameters_.minTheta, parameters_.maxTheta};
        const bool isReference = chosenBackend(parameters_.backend, false) == BACKEND_REFERENCE;
        const Ptr<Executor> host =
            executorFor(isReference ? BACKEND_REFERENCE : BACKEND_CPU, false, executors_);
        if (edges.isTaken)
        {
            const WorkingTime time(*counting.executor);
            counting.executor->readTaken(images_.votes);
            edges.votes = images_.votes;
            executors_[counting.executor->backend()] = counting.executor;
        }
        counting.executor = host;
        readEdges(input, edges, *host, counting);
        planes_.reset(edges, plan.frame());
        counting.times.end("edge map");
        const Requirement requirement = requirementFor(edges, plan);
        lines.clear();
        deviations.clear();
        if (requirement.threshold == INT_MAX)
            return;
        // What the lines taken explain is lost to the candidates after them, so that more are needed.
        const bool explains = parameters_.selection == SELECT_EXPLAIN;
        const StripWanted wanted = {requirement, angles,
                                    (explains ? CANDIDATES_PER_LINE : 1) *
                                        (size_t)parameters_.maxLines,
                                    parameters_.suppressionDistance};
        const std::vector<Candidate> candidates =
            strips_.find(planes_, plan, wanted, isReference, counting.times);
        const std::vector<Selected> chosen =
            select(edges, plan, requirement, angles, candidates, false);
        for (size_t i = 0; i < chosen.size(); ++i)
            report(chosen[i], angles, lines, deviations);
        counting.times.end("selection");
    }

    void findLines(const Input& input, EdgeMap& edges, Counting& counting,
                   std::vector<Vec3f>& lines, std::vector<Vec3f>& deviations)
    {
        if (parameters_.method == METHOD_STRIPS)
        {
            findStripLines(input, edges, counting, lines, deviations);
            return;
        }
        const Plan& plan = *counting.plan;
        const AngleInterval angles = {parameters_.minTheta, parameters_.maxTheta};
        runWith(input.edges.isUMat(), counting,
                [&](Executor& executor)
                {
                    findDirections(executor, input, plan, edges);
                    bool stays = staysOnDevice(input, edges, executor);
                    if (!stays || !isOnDevice(edges, executor, counting))
                        readEdges(input, edges, executor, counting);
                    bool hasBits = stays && countsPixels(edges) && edges.votes.empty();
                    if (hasBits)
                    {
                        executor.readBits(edges, plan, bits_);
                        edges.voters = bits_.count();
                    }
                    const Requirement requirement = requirementFor(edges, plan);
                    if (requirement.threshold == INT_MAX)
                        return;
                    counting.level = levelForLines(plan, executor);
                    countVotes(executor, edges, plan, parameters_.method == METHOD_EXACT,
                               counting.level, tables_, counting.times);
                    if (stays)
                        planes_.clear(); // of another map, maybe with weights
                    else                 // a device is still counting
                        readPlanes(input, edges, executor, counting);
                    bool areCounted = parameters_.method == METHOD_EXACT;
                    std::vector<Candidate> candidates =
                        candidatesFor(executor, edges, requirement, angles, counting, areCounted);
                    if (!areCounted)
                    {
                        if (stays && ascentRadius() > 0)
                        {
                            readPlanes(input, edges, executor, counting);
                            stays = false;
                        }
                        recount(edges, plan, executor, candidates);
                    }
                    if (parameters_.method != METHOD_EXACT)
                        counting.times.end("ascent");
                    removeIf(candidates,
                             [&](const Candidate& candidate)
                             {
                                 return !requirement.isMet(planes_, plan, candidate) ||
                                        !isInInterval(plan.frame(), angles, candidate.chord());
                             });
                    const bool readsBits = stays && parameters_.refine != REFINE_NONE;
                    if (readsBits && !hasBits && !candidates.empty())
                        executor.readBits(edges, plan, bits_);
                    const std::vector<Selected> chosen =
                        select(edges, plan, requirement, angles, candidates, readsBits);
                    lines.clear();
                    deviations.clear();
                    for (size_t i = 0; i < chosen.size(); ++i)
                        report(chosen[i], angles, lines, deviations);
                    counting.times.end("selection");
                });
    }

    //! Whether candidates are maxima among parallel chords, for the ascent, or by the suppression.
    bool candidatesClimb() const
    {
        return ascentRadius() > 0 && parameters_.suppression == SUPPRESS_RING &&
               parameters_.suppressionRadius <= MAX_ASCENT_RADIUS;
    }

    //! Of large neighbourhoods a table shows more chords at a time.
    bool prunes() const
    {
        return parameters_.pruning && parameters_.method == METHOD_CASCADED &&
               parameters_.suppression == SUPPRESS_RING &&
               parameters_.suppressionRadius <= MOST_PRUNED_RADIUS;
    }

    //! The level whose table lines are found from: the last one, or where bundles or blocks take
    //! over.
    int levelForLines(const Plan& plan, Executor& executor)
    {
        int base = -1;
        if (prunes() && executor.backend() == BACKEND_CPU)
        {
            base = BundleSearch::baseLevel(plan, parameters_.edgeWeights);
            if (base >= 0 && !bundles_.isWorthATry(plan.imageSize()))
                base = -1;
        }
        else if (prunes())
            base = executor.levelForPruning(plan, parameters_.edgeWeights);
        return base < 0 ? plan.levelCount() - 1 : base;
    }

    //! The exact method's votes need no second count and no lower threshold.
    double candidateRatio() const
    {
        return parameters_.method == METHOD_EXACT ? 1 : parameters_.candidateRatio;
    }

    //! Candidates have more votes in the table.
    int candidateThreshold(const Requirement& requirement) const
    {
        return cvFloor(candidateRatio() * requirement.threshold);
    }

    //! The total order, and each maximum once that several candidates came to.
    static void sortOut(std::vector<Candidate>& candidates)
    {
        std::sort(candidates.begin(), candidates.end(), isStronger);
        candidates.erase(std::unique(candidates.begin(), candidates.end(), isSameChord),
                         candidates.end());
    }

    //! The chords of the frame whose exact votes may meet the requirement. Sets areCounted if they
    //! have been counted exactly, and have climbed.
    std::vector<Candidate> candidatesFor(Executor& executor, const EdgeMap& edges,
                                         const Requirement& requirement,
                                         const AngleInterval& angles, Counting& counting,
                                         bool& areCounted)
    {
        const Plan& plan = *counting.plan;
        const double ratio = candidateRatio();
        const Cell& frame = plan.frame();
        Wanted wanted;
        wanted.threshold = candidateThreshold(requirement);
        wanted.most = parameters_.method != METHOD_EXACT && parameters_.maxLines > 0
                          ? poolSize()
                          : std::numeric_limits<size_t>::max();
        if (!requirement.pixels.empty() || !angles.isFull())
            wanted.accepts = [&](const Candidate& candidate)
            {
                return requirement.canBeMet(plan, candidate, ratio) &&
                       isInInterval(frame, angles, candidate.chord());
            };
        wanted.leastVotes = requirement.leastVotes(ratio);
        if (executor.isDevice() && !angles.isFull())
            wanted.ends = &angleEnds_.of(frame, angles);
        const int last = plan.levelCount() - 1, radius = parameters_.suppressionRadius;
        const int climbingRadius = candidatesClimb() ? -1 : radius;
        std::vector<Candidate> found;
        const int ascent = parameters_.method == METHOD_EXACT ? -1 : ascentRadius();
        if (counting.level < last && executor.backend() != BACKEND_CPU)
        {
            const bool isFound =
                executor.findMaximaPruned(edges, plan, counting.level, tables_, wanted,
                                          climbingRadius, ascent, found, areCounted);
            counting.times.end("candidates");
            if (isFound)
            {
                sortOut(found);
                return found;
            }
            mergeVotes(executor, edges, plan, counting.level, last, tables_, counting.times);
        }
        else if (counting.level < last)
        {
            const VoteTable& base = tables_.of(counting.level);
            bundles_.bound(plan, counting.level, base, tables_.besides(counting.level));
            counting.times.end("bounds");
            const bool isFound = bundles_.find(plan, wanted, climbingRadius, base, found);
            counting.times.end("bundles");
            if (isFound)
                return found;
            mergeVotes(executor, edges, plan, counting.level, last, tables_, counting.times);
        }
        VoteTable& table = tables_.of(last);
        const bool isGreedy = parameters_.suppression == SUPPRESS_GREEDY;
        if (!isGreedy && executor.findMaxima(edges, plan, table, wanted, parameters_.suppression,
                                             climbingRadius, ascent, found, areCounted))
            sortOut(found);
        else if (!(isGreedy && suppressGreedily(executor, edges, plan, wanted, found)))
        {
            executor.fetch(table);
            found = candidatesClimb()
                        ? findParallelMaxima(table, frame, wanted)
                        : findCandidates(table, frame, wanted, parameters_.suppression, radius);
        }
        executor.settleTimes(counting.times);
        counting.times.end("candidates");
        return found;
    }

    /** What one chord keeps depends on all stronger ones: by the host, from those that the device finds
    above the threshold. Returns false if it finds none, or so many that they are hardly fewer bytes
    than its table; then the next images are not tried. */
    bool suppressGreedily(Executor& executor, const EdgeMap& edges, const Plan& plan,
                          const Wanted& wanted, std::vector<Candidate>& found)
    {
        if (listPause_ > 0)
        {
            --listPause_;
            return false;
        }
        Wanted all;
        all.threshold = wanted.threshold;
        all.most = plan.frame().chordCount() / 8;
        std::vector<Candidate> above;
        bool areCounted = false;
        if (!executor.findMaxima(edges, plan, tables_.of(plan.levelCount() - 1), all, SUPPRESS_RING,
                                 0, -1, above, areCounted))
            return false;
        if (above.size() == all.most)
        {
            listPause_ = LIST_PAUSE;
            return false;
        }
        found = greedyCandidates(above, plan.frame(), wanted, parameters_.suppressionRadius);
        return true;
    }

    std::vector<Selected> select(const EdgeMap& edges, const Plan& plan,
                                 const Requirement& requirement, const AngleInterval& angles,
                                 const std::vector<Candidate>& candidates, bool hasBits)
    {
        SelectionRule rule;
        rule.requirement = requirement;
        rule.explain = parameters_.selection == SELECT_EXPLAIN;
        rule.distance = parameters_.suppressionDistance;
        rule.most = parameters_.maxLines > 0 ? (size_t)parameters_.maxLines
                                             : std::numeric_limits<size_t>::max();
        rule.refine = [&](Chord chord)
        {
            return refined(edges, plan, chord, angles, hasBits);
        };
        if (rule.explain)
            planes_.copyTo(left_);
        return selectLines(plan, rule, candidates, rule.explain ? left_ : planes_);
    }

    static void report(const Selected& selected, const AngleInterval& angles,
                       std::vector<Vec3f>& lines, std::vector<Vec3f>& deviations)
    {
        FittedLine fitted = selected.fitted;
        const bool wasNegative = std::signbit(fitted.line.rho);
        angles.represent(fitted.line);
        if (std::signbit(fitted.line.rho) != wasNegative) // also of a rho of 0
            fitted.covariance.rhoTheta = -fitted.covariance.rhoTheta;
        const Vec2f polar = angles.round(fitted.line);
        if (!angles.contains(polar[1])) // an interval narrower than a float's step may hold none
            return;
        lines.push_back(Vec3f(polar[0], polar[1], (float)selected.candidate.votes));
        deviations.push_back(fitted.covariance.deviations());
    }

    //! The table of METHOD_EXACT holds exact votes: its maxima are maxima of these.
    int ascentRadius() const
    {
        return parameters_.method == METHOD_EXACT
                   ? 0
                   : std::min<int>(parameters_.suppressionRadius, MAX_ASCENT_RADIUS);
    }

    //! Counts candidates of the cascade exactly, or lets them climb (section 4.2).
    void recount(const EdgeMap& edges, const Plan& plan, Executor& executor,
                 std::vector<Candidate>& candidates)
    {
        if (ascentRadius() > 0)
        {
            squares_.reset(planes_);
            climbToMaxima(plan.frame(), ascentRadius(), squares_, candidates);
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
    FittedLine refined(const EdgeMap& edges, const Plan& plan, Chord chord,
                       const AngleInterval& angles, bool hasBits) const
    {
        const Cell& frame = plan.frame();
        const FittedLine line = chordLine(frame, chord);
        if (parameters_.refine == REFINE_NONE)
            return line;
        const FittedLine result =
            hasBits ? refineLine(plan.imageSize(), bits_, line)
                    : refineLine(edges, planes_, directionBin(frame, chord), line);
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
    std::vector<Ptr<Executor>> executors_; // by back end, of those that were used
    int activeBackend_;
    std::vector<Size> failedSizes_; // the last for which a device failed: it is not tried again
    Images images_;
    VoteTables tables_;
    BundleSearch bundles_;
    EdgePlanes planes_, left_; // left_: see selectLines
    EdgeBits bits_;            // in their place, where the map stays on a device
    VoteSquares squares_;
    StripCandidates strips_;
    AngleEnds angleEnds_;
    int listPause_;                 // images to come that suppressGreedily does not try
    std::vector<Vec3f> deviations_; // of the lines of the last detect
    StageTimes stageTimes_;         // of the last call
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
