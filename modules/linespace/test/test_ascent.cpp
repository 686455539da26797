// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The ascent of many candidates at once (doc/algorithm.md, section 4.2): votes that are counted for
// many chords together, of every kind and length, are those of brute force.

#include "test_precomp.hpp"

#include "expected_lines.hpp"
#include "generators.hpp"
#include "test_support.hpp"

namespace opencv_test {

namespace {

//! What an edge map is made of; weights and gradients are random.
struct AscentCase
{
    Size size;
    double density; //!< 1: all white
    bool weighted, oriented;
    int threshold, radius;
    int cellSize; //!< 50: a frame that is the image
};

void PrintTo(const AscentCase& own, std::ostream* out)
{
    *out << own.size << ", density " << own.density << (own.weighted ? ", weighted" : "")
         << (own.oriented ? ", oriented" : "") << ", threshold " << own.threshold << ", radius "
         << own.radius << ", cellSize " << own.cellSize;
}

struct AscentInput
{
    Mat1b edges;
    Mat1s dx, dy;
    Mat1w directions; //!< empty if not oriented

    explicit AscentInput(const AscentCase& own)
        : edges(own.density == 1 ? generators::whiteEdges(own.size)
                                 : generators::randomEdges(own.size, own.density, 31))
    {
        RNG rng(32);
        if (own.weighted && own.density < 1)
            for (int y = 0; y < edges.rows; ++y)
                for (int x = 0; x < edges.cols; ++x)
                    edges(y, x) = edges(y, x) ? (uchar)rng.uniform(1, 256) : 0;
        if (!own.oriented)
            return;
        dx.create(own.size);
        dy.create(own.size);
        rng.fill(dx, RNG::UNIFORM, -100, 100);
        rng.fill(dy, RNG::UNIFORM, -100, 100);
        directions = brute::directions(dx, dy, TOLERANCE);
    }
    void detect(LineSpaceDetector& detector, Lines& lines) const
    {
        if (directions.empty())
            detector.detect(edges, lines);
        else
            detector.detect(edges, dx, dy, lines);
    }

    static const double TOLERANCE;
};

const double AscentInput::TOLERANCE = 60;

Ptr<LineSpaceDetector> climbing(const AscentCase& own)
{
    Ptr<LineSpaceDetector> detector =
        createPlain(METHOD_CASCADED, own.cellSize, BACKEND_CPU, own.threshold);
    detector->setSuppressionRadius(own.radius);
    detector->setEdgeWeights(own.weighted);
    detector->setOrientationTolerance(AscentInput::TOLERANCE);
    return detector;
}

class WithThreads
{
public:
    explicit WithThreads(int threads) : before_(getNumThreads()) { setNumThreads(threads); }
    ~WithThreads() { setNumThreads(before_); }

private:
    const int before_;
};

} // namespace

// Thousands of candidates, so that all ways of counting are used: frames with and without padding,
// whose sides are multiples of the squares, the groups of columns and the vectors, or not.
const AscentCase crowds[] = {
    {Size(100, 90), 0.4, false, false, 45, 2, 8},  {Size(90, 100), 0.4, false, false, 45, 1, 8},
    {Size(97, 128), 0.3, false, false, 45, 2, 50}, {Size(131, 67), 0.3, false, false, 30, 2, 50},
    {Size(67, 131), 0.3, false, false, 30, 2, 50}, {Size(64, 64), 1, false, false, 30, 2, 8},
    {Size(111, 79), 1, false, false, 70, 1, 50},   {Size(80, 80), 0.7, false, false, 1, 2, 8},
    {Size(100, 90), 0.4, true, false, 5700, 2, 8}, {Size(79, 113), 1, true, false, 17000, 2, 8},
    {Size(100, 90), 0.7, false, true, 55, 2, 8},   {Size(113, 79), 0.7, false, true, 50, 1, 8},
    {Size(81, 100), 0.7, true, true, 6400, 2, 8},
};

typedef testing::TestWithParam<AscentCase> Linespace_AscentCrowd;

TEST_P(Linespace_AscentCrowd, is_that_of_brute_force)
{
    const AscentCase own = GetParam();
    const AscentInput input(own);
    const Selection selection(input.edges, METHOD_CASCADED, own.cellSize, own.weighted,
                              input.directions);
    const std::vector<brute::Candidate> expected =
        selection.select(own.threshold, 0, THIN_RING, own.radius);
    ASSERT_GT(expected.size(), own.density == 1 ? 0u : 100u);
    const Ptr<LineSpaceDetector> detector = climbing(own);
    const int threads[] = {1, 2, 5};
    for (int i = 0; i < 3; ++i)
    {
        const WithThreads own_threads(threads[i]);
        Lines lines;
        input.detect(*detector, lines);
        expectChords(lines, expected, selection.frame, format("%d threads", threads[i]));
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_AscentCrowd, testing::ValuesIn(crowds));

// Chords too long or too many for all of them by brute force: no line has a stronger neighbour. The
// lengths are those at which fractions are rounded more often, and sums are full.
const AscentCase giants[] = {
    {Size(640, 480), 0.15, false, false, 120, 2, 8},
    {Size(517, 700), 0.15, true, false, 18000, 2, 8},
    {Size(640, 480), 0.97, false, false, 500, 2, 8},
    {Size(600, 512), 0.3, false, true, 110, 2, 8},
    {Size(1100, 300), 1, false, false, 1050, 2, 8},
    {Size(300, 1100), 1, true, false, 270000, 2, 8},
    {Size(3400, 17), 0.2, false, false, 650, 2, 8},
    {Size(17, 3400), 1, true, false, 860000, 1, 8},
    {Size(5600, 9), 0.2, false, false, 1050, 2, 8},
    {Size(6000, 12), 0.2, false, true, 900, 2, 8},
};

typedef testing::TestWithParam<AscentCase> Linespace_AscentGiant;

TEST_P(Linespace_AscentGiant, lines_have_no_stronger_neighbour)
{
    const AscentCase own = GetParam();
    const AscentInput input(own);
    const Ptr<LineSpaceDetector> detector = climbing(own);
    detector->setMaxLines(60);
    Lines lines;
    input.detect(*detector, lines);
    ASSERT_GT(lines.size(), own.density == 1 ? 0u : 10u);
    const Size frame = detector->getFrameSize();
    const int points = brute::borderCount(frame);
    for (size_t i = 0; i < lines.size(); ++i)
    {
        brute::Candidate line = {0, 0, (int)lines[i][2]};
        ASSERT_TRUE(brute::chordOf(frame, lines[i], line.s, line.e)) << lines[i];
        for (int j = -own.radius; j <= own.radius; ++j)
            for (int k = -own.radius; k <= own.radius; ++k)
            {
                const int p = (line.s + j + points) % points, q = (line.e + k + points) % points;
                if (!brute::isChord(frame, p, q))
                    continue;
                const int votes = brute::chordVotes(input.edges, frame, std::min(p, q),
                                                    std::max(p, q), own.weighted, input.directions);
                const brute::Candidate neighbour = {std::min(p, q), std::max(p, q), votes};
                if (j == 0 && k == 0)
                    ASSERT_EQ(votes, line.votes) << lines[i];
                else
                    ASSERT_FALSE(brute::isStronger(neighbour, line))
                        << lines[i] << ", (" << p << ", " << q << ")";
            }
    }
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_AscentGiant, testing::ValuesIn(giants));

} // namespace opencv_test
