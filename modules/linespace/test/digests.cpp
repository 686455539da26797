// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "test_precomp.hpp"

#include "digests.hpp"
#include "test_support.hpp"

#include <iomanip>

namespace opencv_test {
namespace {

//! FNV-1a of 64 bits, over the size and all elements.
uint64 digest(const Mat& array)
{
    uint64 hash = 14695981039346656037u;
    const auto add = [&hash](const uchar* bytes, size_t count)
    {
        for (size_t i = 0; i < count; ++i)
            hash = (hash ^ bytes[i]) * 1099511628211u;
    };
    const int32_t shape[] = {array.rows, array.cols, array.type()};
    add((const uchar*)shape, sizeof shape);
    for (int y = 0; y < array.rows; ++y)
        add(array.ptr(y), array.cols * array.elemSize());
    return hash;
}

//! Noisy regions that straight lines separate.
struct Scene
{
    Mat1b edges; //!< 1 to 255, where the region changes, and some pixels anywhere
    Mat dx, dy;  //!< CV_16SC1

    Scene(const Size& size, int lineCount, unsigned seed)
    {
        RNG rng(seed);
        Mat1b isLight(size, (uchar)0), grey(size);
        for (int i = 0; i < lineCount; ++i)
        {
            const int normalX = rng.uniform(-1000, 1001);
            const int normalY = rng.uniform(-1000, 1001);
            // One number per declaration: compilers evaluate arguments in any order.
            const int throughX = rng.uniform(size.width / 4, 3 * size.width / 4);
            const int throughY = rng.uniform(size.height / 4, 3 * size.height / 4);
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    isLight(y, x) ^= normalX * (x - throughX) + normalY * (y - throughY) > 0;
        }
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                grey(y, x) = (uchar)((isLight(y, x) ? 170 : 60) + rng.uniform(0, 25));
        Sobel(grey, dx, CV_16S, 1, 0);
        Sobel(grey, dy, CV_16S, 0, 1);
        edges.create(size);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
            {
                const uchar right = isLight(y, std::min(x + 1, size.width - 1)),
                            below = isLight(std::min(y + 1, size.height - 1), x);
                const bool isEdge = isLight(y, x) != right || isLight(y, x) != below;
                const int weight = rng.uniform(1, 256);
                edges(y, x) = isEdge || rng.uniform(0, 40) == 0 ? (uchar)weight : (uchar)0;
            }
    }
};

class Writer
{
public:
    Writer(std::ostream& out, const std::string& prefix) : out_(out), prefix_(prefix) {}

    void write(const std::string& what, const Mat& array)
    {
        out_ << prefix_ << ' ' << what << ' ' << array.size() << ' ' << std::hex
             << std::setfill('0') << std::setw(16) << digest(array) << std::dec << '\n';
    }

    //! The votes and their order are integers; position and deviations are floating point.
    void writeLines(const std::string& what, const Mat& lines, const Mat& deviations = Mat())
    {
        Mat votes;
        if (!lines.empty())
            extractChannel(lines, votes, 2);
        write(what + " votes", votes);
        write(what + " lines", lines);
        if (!deviations.empty())
            write(what + " deviations", deviations);
    }

private:
    std::ostream& out_;
    std::string prefix_;
};

void writeTables(Writer& writer, const std::string& name, LineSpaceDetector& detector,
                 const Mat& edges)
{
    Mat table;
    detector.compute(edges, table);
    writer.write(name, table);
    for (int level = 0; level + 1 < detector.getLevelCount(); ++level)
    {
        detector.computeLevel(edges, level, table);
        writer.write(name + " level " + std::to_string(level), table);
    }
}

void writeDetected(Writer& writer, const std::string& name, LineSpaceDetector& detector,
                   const Scene& scene)
{
    Mat lines, deviations;
    detector.detect(scene.edges, lines);
    detector.getDeviations(deviations);
    writer.writeLines(name, lines, deviations);
    detector.detect(scene.edges, scene.dx, scene.dy, lines);
    detector.getDeviations(deviations);
    writer.writeLines(name + " oriented", lines, deviations);
}

void writeScene(std::ostream& out, const Size& size, int cellSize, unsigned seed)
{
    const Scene scene(size, 9, seed);
    std::ostringstream prefix;
    prefix << size << " cells " << cellSize;
    Writer writer(out, prefix.str());
    for (int weights = 0; weights < 2; ++weights)
    {
        const std::string kind = weights ? "weights" : "pixels";
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(0, 0, METHOD_CASCADED, cellSize, BACKEND_CPU);
        detector->setEdgeWeights(weights != 0);
        // The statistical threshold is for pixels; lines of weights need one.
        detector->setThreshold(weights ? 100 * size.width : 0);
        writeTables(writer, kind, *detector, scene.edges);
        writeDetected(writer, kind, *detector, scene);
        detector->setSelection(SELECT_EXPLAIN);
        writeDetected(writer, kind + " explained", *detector, scene);
        detector->setSelection(SELECT_PEAKS);
        // Hundreds of lines, and all that is between candidates and lines has to do.
        detector->setSuppressionDistance(0);
        detector->setThreshold((weights ? 100 : 1) * size.width / 12);
        detector->setMaxLines(500);
        writeDetected(writer, kind + " strongest", *detector, scene);
        detector->setPruning(false);
        detector->setRefine(REFINE_NONE);
        writeDetected(writer, kind + " strongest chords", *detector, scene);
    }
    Mat lines;
    linespace::HoughLines(scene.edges, lines, 1, CV_PI / 180, size.width / 4);
    writer.write("HoughLines 1 degree", lines);
    linespace::HoughLines(scene.edges, lines, 0.5, CV_PI / 720, size.width / 4);
    writer.write("HoughLines 1/4 degree", lines);
}

void writeExact(std::ostream& out, const Size& size, unsigned seed)
{
    const Scene scene(size, 5, seed);
    std::ostringstream prefix;
    prefix << size << " exact";
    Writer writer(out, prefix.str());
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(0, 0, METHOD_EXACT, 8, BACKEND_CPU);
    writeTables(writer, "pixels", *detector, scene.edges);
    writeDetected(writer, "pixels", *detector, scene);
    detector->setEdgeWeights(true);
    writeTables(writer, "weights", *detector, scene.edges);
}

} // namespace

void writeDigests(std::ostream& out)
{
    writeScene(out, Size(320, 320), 8, 1);
    writeScene(out, Size(333, 217), 5, 2);
    writeScene(out, Size(512, 384), 16, 3);
    writeExact(out, Size(120, 97), 4);
}

} // namespace opencv_test
