// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// From votes to lines (doc/algorithm.md, section 4): which chords LineSpaceDetector::detect
// reports, with which votes and in which order, for every way of thinning them out.

#include "test_precomp.hpp"

#include "brute_force.hpp"
#include "expected_lines.hpp"
#include "generators.hpp"
#include "test_support.hpp"

#include <thread>

namespace opencv_test {
namespace {

using namespace generators;
using brute::Candidate;

class Linespace_Detect : public testing::TestWithParam<tuple<int, int>> // back end, method
{
protected:
    int backend() const { return get<0>(GetParam()); }
    int method() const { return get<1>(GetParam()); }
    Ptr<LineSpaceDetector> plain(int threshold, int cellSize = 3) const
    {
        return createPlain(method(), cellSize, backend(), threshold);
    }
};

TEST_P(Linespace_Detect, every_chord_above_the_threshold_in_total_order)
{
    const Size sizes[] = {Size(1, 1), Size(2, 1), Size(5, 5), Size(20, 13), Size(46, 37)};
    for (int i = 0; i < 5; ++i)
    {
        const Mat1b edges = i == 4 ? smallScene() : randomEdges(sizes[i], 0.5, i);
        const Selection selection(edges, method(), 3);
        const int thresholds[] = {1, 2, 5, 9, 20, 46};
        for (int j = 0; j < 6; ++j)
        {
            const Ptr<LineSpaceDetector> detector = plain(thresholds[j]);
            const Lines lines = detectLines(*detector, edges);
            expectChords(lines, selection.select(thresholds[j], 0, THIN_NOT, 0), selection.frame,
                         format("%d x %d, threshold %d", edges.cols, edges.rows, thresholds[j]));
            if (HasFatalFailure())
                return;
        }
    }
}

TEST_P(Linespace_Detect, suppression)
{
    const struct
    {
        int suppression, thinning;
    } modes[] = {
        {SUPPRESS_RING, THIN_RING}, {SUPPRESS_BLOCKS, THIN_BLOCKS}, {SUPPRESS_GREEDY, THIN_GREEDY}};
    for (unsigned seed = 0; seed < 3; ++seed)
    {
        // Many equal votes, so that the order of ties matters; and lines over the corners, where
        // the ring closes.
        Mat1b edges = seed == 0 ? whiteEdges(Size(21, 16)) : smallScene(seed);
        edges.row(0).setTo(255);
        edges.col(0).setTo(255);
        const Selection selection(edges, method(), 3);
        for (int mode = 0; mode < 3; ++mode)
            for (int radius = 0; radius <= 5; ++radius)
            {
                const int threshold = 8;
                Ptr<LineSpaceDetector> detector = plain(threshold);
                detector->setSuppression(modes[mode].suppression);
                detector->setSuppressionRadius(radius);
                detector->setCandidateRatio(0.75);
                expectChords(detectLines(*detector, edges),
                             selection.select(threshold, 0.75,
                                              radius ? modes[mode].thinning : THIN_NOT, radius),
                             selection.frame,
                             format("suppression %d, radius %d, seed %d", modes[mode].suppression,
                                    radius, seed));
                if (HasFatalFailure())
                    return;
            }
    }
}

// A neighbourhood that is wider than the ring must not meet itself.
TEST_P(Linespace_Detect, large_radius_wraps_around_the_ring)
{
    const Size sizes[] = {Size(2, 1), Size(2, 2), Size(3, 2), Size(7, 5)}; // 6 to 24 border points
    for (unsigned seed = 0; seed < 5; ++seed)
        for (int i = 0; i < 4; ++i)
        {
            const Mat1b edges = randomEdges(sizes[i], 0.6, seed);
            const Selection selection(edges, method(), 3);
            const int radii[] = {1, 2, 3, 4, 5, 7, 12, 64};
            for (int j = 0; j < 8; ++j)
            {
                Ptr<LineSpaceDetector> detector = plain(1);
                detector->setSuppressionRadius(radii[j]);
                expectChords(detectLines(*detector, edges),
                             selection.select(1, 0, THIN_RING, radii[j]), selection.frame,
                             format("%d x %d, radius %d, seed %d", edges.cols, edges.rows, radii[j],
                                    (int)seed));
                if (HasFatalFailure())
                    return;
            }
        }
}

TEST_P(Linespace_Detect, candidate_ratio)
{
    const Mat1b edges = smallScene(5);
    const Selection selection(edges, method(), 2);
    const double ratios[] = {0, 0.5, 0.75, 0.8, 1};
    for (int i = 0; i < 5; ++i)
        for (int threshold = 8; threshold <= 20;
             threshold += 4) // 0.75 T and 0.5 T are whole: strictly above
        {
            Ptr<LineSpaceDetector> detector = plain(threshold, 2);
            detector->setCandidateRatio(ratios[i]);
            expectChords(detectLines(*detector, edges),
                         selection.select(threshold, ratios[i], THIN_NOT, 0), selection.frame,
                         format("ratio %f, threshold %d", ratios[i], threshold));
            if (HasFatalFailure())
                return;
        }
}

TEST_P(Linespace_Detect, pool)
{
    const Mat1b edges = smallScene(6);
    const Selection selection(edges, method(), 2);
    const int maxLines[] = {1, 3, 20};
    const int poolSizes[] = {1, 40, 100};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 6; ++j)
        {
            const int radius = j / 3, size = poolSizes[j % 3];
            Ptr<LineSpaceDetector> detector = plain(10, 2);
            detector->setMaxLines(maxLines[i]);
            detector->setPoolSize(size);
            detector->setSuppressionRadius(radius);
            std::vector<Candidate> expected = selection.select(
                10, 0, radius ? THIN_RING : THIN_NOT, radius, std::max(size, 16 * maxLines[i]));
            expected.resize(std::min(expected.size(), (size_t)maxLines[i]));
            expectChords(detectLines(*detector, edges), expected, selection.frame,
                         format("maxLines %d, pool %d, radius %d", maxLines[i], size, radius));
            if (HasFatalFailure())
                return;
        }
}

// Many strong chords from one border point say nothing of the others': the pool must be filled from
// these all the same.
TEST_P(Linespace_Detect, pool_of_a_fan)
{
    Mat1b edges = randomEdges(Size(64, 64), 0.05, 3);
    for (int x = 0; x < 64; x += 4)
        line(edges, Point(16, 0), Point(x, 63), Scalar(255));
    const Selection selection(edges, method(), 4);
    for (int size = 50; size <= 800; size *= 2)
        for (int radius = 0; radius <= 3; radius += 3)
        {
            Ptr<LineSpaceDetector> detector = plain(3, 4);
            detector->setPoolSize(size);
            detector->setMaxLines(size / 16);
            detector->setSuppressionRadius(radius);
            std::vector<Candidate> expected =
                selection.select(3, 0, radius ? THIN_RING : THIN_NOT, radius, size);
            expected.resize(std::min(expected.size(), (size_t)size / 16));
            expectChords(detectLines(*detector, edges), expected, selection.frame,
                         format("pool %d, radius %d", size, radius));
            if (HasFatalFailure())
                return;
        }
}

TEST_P(Linespace_Detect, max_lines_takes_the_first_of_all)
{
    const Mat1b edges = smallScene(2);
    for (int distance = 0; distance <= 3; distance += 3)
    {
        Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(9, 0, method(), 3, backend());
        detector->setSuppressionDistance(distance);
        detector->setPoolSize(1 << 20); // all candidates, as for maxLines 0
        const Lines all = detectLines(*detector, edges);
        ASSERT_GT(all.size(), 8u);
        const int counts[] = {
            1, 2, 7, (int)all.size() - 1, (int)all.size(), (int)all.size() + 1, 1 << 20, INT_MAX};
        for (int i = 0; i < 8; ++i)
        {
            detector->setMaxLines(counts[i]);
            const Lines first(all.begin(), all.begin() + std::min((size_t)counts[i], all.size()));
            expectSameLines(detectLines(*detector, edges), first, format("maxLines %d", counts[i]));
        }
    }
}

TEST_P(Linespace_Detect, threshold_is_strict)
{
    Mat1b edges(20, 30, (uchar)0);
    edges.row(11).setTo(1);
    Ptr<LineSpaceDetector> detector = plain(29, 4);
    const Lines lines = detectLines(*detector, edges);
    ASSERT_EQ(1u, lines.size());
    EXPECT_NEAR(11, lines[0][0], 1e-4);
    EXPECT_NEAR(CV_PI / 2, lines[0][1], 1e-6);
    EXPECT_EQ(30, lines[0][2]);
    detector->setThreshold(30);
    EXPECT_TRUE(detectLines(*detector, edges).empty());
}

TEST_P(Linespace_Detect, reported_votes_are_the_chords_exact_votes)
{
    const char* names[] = {"building.jpg", "board.jpg", "home.jpg", "sudoku.png"};
    for (int i = 0; i < 4; ++i)
    {
        const Mat1b edges = photographEdges(names[i], backend() == BACKEND_REFERENCE ? 160 : 320);
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(edges.cols / 6, 0, method(), 8, backend());
        detector->setRefine(REFINE_NONE);
        const Lines lines = detectLines(*detector, edges);
        ASSERT_FALSE(lines.empty()) << names[i];
        Candidate before = {-1, -1, INT_MAX};
        for (size_t j = 0; j < lines.size(); ++j)
        {
            Candidate line;
            ASSERT_TRUE(brute::chordOf(detector->getFrameSize(), lines[j], line.s, line.e))
                << lines[j];
            line.votes = brute::chordVotes(edges, detector->getFrameSize(), line.s, line.e);
            ASSERT_EQ((float)line.votes, lines[j][2]) << names[i] << ", line " << j;
            ASSERT_TRUE(brute::isStronger(before, line)) << names[i] << ", order of line " << j;
            ASSERT_GT(line.votes, detector->getThreshold());
            ASSERT_GE(lines[j][1], 0);
            ASSERT_LT((double)lines[j][1], CV_PI);
            before = line;
        }
    }
}

// Greedy in the total order: nothing stays that is within the distance of a stronger line, as its
// chord or refined, nothing is dropped without one.
TEST_P(Linespace_Detect, near_duplicates)
{
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
        const Mat1b edges = smallScene(seed);
        Ptr<LineSpaceDetector> detector = plain(9);
        const Lines chords = detectLines(*detector, edges);
        ASSERT_GT(chords.size(), 50u);
        const double distances[] = {0.4, 1.5, 3, 8.25};
        for (int i = 0; i < 8; ++i)
        {
            const double distance = distances[i % 4];
            detector->setRefine(i < 4 ? REFINE_NONE : REFINE_LEAST_SQUARES);
            detector->setSuppressionDistance(0);
            const Lines all = detectLines(*detector, edges);
            ASSERT_EQ(chords.size(), all.size());
            detector->setSuppressionDistance(distance);
            const Lines kept = detectLines(*detector, edges);
            ASSERT_FALSE(kept.empty());
            ASSERT_LT(kept.size(), all.size());
            size_t next = 0; // of kept
            for (size_t j = 0; j < all.size(); ++j)
            {
                double nearest = DBL_MAX;
                const Vec2d chord(chords[j][0], chords[j][1]), line(all[j][0], all[j][1]);
                for (size_t k = 0; k < next; ++k)
                {
                    const Vec2d taken(kept[k][0], kept[k][1]);
                    nearest =
                        std::min(nearest, std::min(brute::endDistance(chord, taken, edges.size()),
                                                   brute::endDistance(line, taken, edges.size())));
                }
                if (nearest <= distance - 1e-4)
                    continue;
                const bool isNext = next < kept.size() && kept[next] == all[j];
                ASSERT_TRUE(isNext || nearest < distance + 1e-4) << "line " << j << " " << all[j];
                next += isNext;
            }
            ASSERT_EQ(kept.size(), next)
                << "kept lines that are not of the whole list, or not in its order";
        }
    }
}

// SELECT_EXPLAIN: pixels along a line do not vote for weaker ones, so a broad edge is one line.
// Votes and order are as always.
TEST_P(Linespace_Detect, explained_pixels_do_not_vote)
{
    const Size size(150, 120);
    Mat1b edges(size, (uchar)0);
    const Vec2d drawn[] = {Vec2d(60, 0.4), Vec2d(80, 0.7), Vec2d(70, 1.5)};
    for (int i = 0; i < 3; ++i)
        for (int offset = -1; offset <= 1; ++offset)
            addLine(edges, drawn[i][0] + offset, drawn[i][1]);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(70, 0, method(), 8, backend());
    detector->setRefine(REFINE_NONE);
    detector->setSuppressionRadius(0);
    detector->setSuppressionDistance(0.25);
    const Lines peaks = detectLines(*detector, edges);
    detector->setSelection(SELECT_EXPLAIN);
    const Lines lines = detectLines(*detector, edges);
    EXPECT_GT(peaks.size(), 2 * lines.size());
    EXPECT_EQ(3u, lines.size());
    for (int i = 0; i < 3; ++i)
    {
        double nearest = DBL_MAX;
        for (size_t j = 0; j < lines.size(); ++j)
            nearest = std::min(nearest,
                               brute::endDistance(drawn[i], Vec2d(lines[j][0], lines[j][1]), size));
        EXPECT_LT(nearest, 2) << drawn[i];
    }
    Candidate before = {-1, -1, INT_MAX};
    for (size_t j = 0; j < lines.size(); ++j)
    {
        Candidate line;
        ASSERT_TRUE(brute::chordOf(detector->getFrameSize(), lines[j], line.s, line.e)) << lines[j];
        line.votes = brute::chordVotes(edges, detector->getFrameSize(), line.s, line.e);
        ASSERT_EQ((float)line.votes, lines[j][2]);
        ASSERT_TRUE(brute::isStronger(before, line)) << "order of line " << j;
        before = line;
    }
}

TEST_P(Linespace_Detect, angle_range)
{
    const Mat1b edges = smallScene(3);
    const int threshold = 7;
    const Selection selection(edges, method(), 3);
    const std::vector<Candidate> all = selection.select(threshold, 0, THIN_NOT, 0);
    const double pi = CV_PI;
    const double ranges[][2] = {
        {0, pi},           {0, 0.5},         {-0.3, 0.4}, {2.8, 3.5},       {-7, -6.2},      {1, 6},
        {-pi / 2, pi / 2}, {pi / 4, pi / 2}, {40, 40.5},  {pi / 2, pi / 2}, {0.3, 0.3 + pi}, {0, 0},
        {-1000, 1000},     {1.3, 1.31},      {pi, pi}};
    for (size_t i = 0; i < sizeof(ranges) / sizeof(ranges[0]); ++i)
    {
        const double from = ranges[i][0], to = std::min(ranges[i][1], from + pi);
        Ptr<LineSpaceDetector> detector = plain(threshold);
        detector->setAngleRange(ranges[i][0], ranges[i][1]);
        const Lines lines = detectLines(*detector, edges);
        std::set<std::pair<int, int>> found;
        Candidate before = {-1, -1, INT_MAX};
        for (size_t j = 0; j < lines.size(); ++j)
        {
            // As floats are compared by a caller: after rounding, without a tolerance.
            ASSERT_GE((double)lines[j][1], ranges[i][0]) << "range " << i;
            ASSERT_LE((double)lines[j][1], ranges[i][1]) << "range " << i;
            const double open = ranges[i][1] - ranges[i][0] >= pi ? from + pi : DBL_MAX;
            ASSERT_LT((double)lines[j][1], open) << "range " << i;
            Candidate line;
            ASSERT_TRUE(brute::chordOf(selection.frame, lines[j], line.s, line.e)) << lines[j];
            line.votes = (int)lines[j][2];
            ASSERT_TRUE(brute::isStronger(before, line)) << "range " << i << ", line " << j;
            ASSERT_TRUE(found.insert(std::make_pair(line.s, line.e)).second) << "reported twice";
            before = line;
        }
        size_t expected = 0;
        for (size_t j = 0; j < all.size(); ++j)
        {
            const double theta = brute::lineOf(selection.frame, all[j].s, all[j].e, from)[1];
            // The next float may be outside where the chord is at the end of the range.
            const double rounding = 2.5e-7 * std::max(1.0, std::abs(from));
            if (std::min(std::abs(theta - from), std::abs(theta - to)) < rounding ||
                std::abs(theta - from - pi) < rounding)
                continue;
            const bool isInside = theta < to;
            expected += isInside;
            ASSERT_EQ(isInside, found.count(std::make_pair(all[j].s, all[j].e)) == 1)
                << "range " << i << ", theta " << theta << ", chord (" << all[j].s << ", "
                << all[j].e << ")";
        }
        EXPECT_TRUE(to - from < 0.4 || expected > 10) << "range " << i;
    }
}

// A vertical line has theta 0, in every range around it, and the sign of rho follows.
TEST_P(Linespace_Detect, angle_range_through_zero)
{
    Mat1b edges(40, 40, (uchar)0);
    edges.col(13).setTo(255);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(35, 1, method(), 4, backend());
    const struct
    {
        double from, to;
        float rho, theta;
    } cases[] = {{0, 0.1, 13, 0},
                 {-0.1, 0.1, 13, 0},
                 {3, 3.2, -13, (float)CV_PI},
                 {-3.2, -3, -13, (float)-CV_PI},
                 {6.2, 6.3, 13, (float)(2 * CV_PI)}};
    for (int i = 0; i < 5; ++i)
    {
        detector->setAngleRange(cases[i].from, cases[i].to);
        const Lines lines = detectLines(*detector, edges);
        ASSERT_EQ(1u, lines.size()) << i;
        EXPECT_NEAR(cases[i].rho, lines[0][0], 1e-3) << i;
        EXPECT_NEAR(cases[i].theta, lines[0][1], 1e-5) << i;
    }
    detector->setAngleRange(0.2, 3);
    EXPECT_TRUE(detectLines(*detector, edges).empty());
}

// Ranges that end between a chord's angle and that of its refined line.
TEST_P(Linespace_Detect, refined_lines_stay_in_the_angle_range)
{
    const Mat1b edges = smallScene(4);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(12, 0, method(), 3, backend());
    detector->setSuppressionDistance(0); // refined lines may come near each other
    const Lines refined = detectLines(*detector, edges);
    detector->setRefine(REFINE_NONE);
    const Lines chords = detectLines(*detector, edges);
    ASSERT_EQ(chords.size(), refined.size());
    detector->setRefine(REFINE_LEAST_SQUARES);
    int tested = 0;
    for (size_t i = 0; i < chords.size(); ++i)
    {
        const double middle = 0.5 * ((double)chords[i][1] + refined[i][1]);
        const double turn = (double)refined[i][1] - chords[i][1];
        if (std::abs(turn) < 1e-4 || std::abs(turn) > 1)
            continue;
        const double from = turn > 0 ? middle - 0.3 : middle, to = turn > 0 ? middle : middle + 0.3;
        detector->setAngleRange(from, to);
        const Lines lines = detectLines(*detector, edges);
        EXPECT_FALSE(lines.empty());
        for (size_t j = 0; j < lines.size(); ++j)
        {
            ASSERT_GE((double)lines[j][1], from) << "line " << i;
            ASSERT_LE((double)lines[j][1], to) << "line " << i;
        }
        ++tested;
    }
    EXPECT_GT(tested, 3);
}

TEST_P(Linespace_Detect, mask)
{
    const Mat1b edges = smallScene(7);
    Mat1b mask = randomEdges(edges.size(), 0.7, 8);
    mask.colRange(0, 12).setTo(0);
    Mat1b masked = edges.clone();
    masked.setTo(0, mask == 0);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(6, 0, method(), 3, backend());
    const Lines unmasked = detectLines(*detector, edges), expected = detectLines(*detector, masked);
    Mat expectedTable, table;
    detector->compute(masked, expectedTable);
    ASSERT_FALSE(expected.empty());
    ASSERT_NE(expected.size(), unmasked.size());

    detector->setMask(asWindow(mask));
    expectSameLines(detectLines(*detector, edges), expected, "mask");
    detector->compute(edges, table);
    EXPECT_EQ(0, cvtest::norm(table, expectedTable, NORM_INF));
    Mat got;
    detector->getMask(got);
    EXPECT_EQ(0, cvtest::norm(got != 0, mask != 0, NORM_INF));
    detector->setMask(noArray());
    expectSameLines(detectLines(*detector, edges), unmasked, "mask removed");
    detector->getMask(got);
    EXPECT_TRUE(got.empty());
}

TEST_P(Linespace_Detect, edge_weights)
{
    const Mat1b edges = randomEdges(Size(33, 28), 0.4, 12);
    const Selection selection(edges, method(), 3, true);
    const int thresholds[] = {800, 1500, 2500};
    for (int i = 0; i < 3; ++i)
    {
        Ptr<LineSpaceDetector> detector = plain(thresholds[i]);
        detector->setEdgeWeights(true);
        expectChords(detectLines(*detector, edges), selection.select(thresholds[i], 0, THIN_NOT, 0),
                     selection.frame, format("threshold %d", thresholds[i]));
        if (HasFatalFailure())
            return;
    }
}

// Chords longer than the sums of bytes and shorts last, of all kinds: candidates climb on exact
// votes that are counted for many chords at once.
TEST_P(Linespace_Detect, long_chords)
{
    const Size sizes[] = {Size(280, 10), Size(10, 280), Size(40, 31)};
    const double densities[] = {0.9, 1};
    for (int i = 0; i < 12; ++i)
    {
        const Size size = sizes[i % 3];
        const bool weighted = i / 3 % 2 == 1;
        const double density = densities[i / 6];
        const Mat1b edges = density == 1 ? whiteEdges(size) : randomEdges(size, density, i);
        const Selection selection(edges, method(), 4, weighted);
        // Few candidates more than those of the longest chords, for brute force to climb from.
        const int length = std::max(size.width, size.height);
        Ptr<LineSpaceDetector> detector =
            plain((int)(0.9 * density * length) * (!weighted      ? 1
                                                   : density == 1 ? 255
                                                                  : 128),
                  4);
        detector->setEdgeWeights(weighted);
        detector->setSuppressionRadius(2);
        expectChords(detectLines(*detector, edges),
                     selection.select(detector->getThreshold(), 0, THIN_RING, 2), selection.frame,
                     format("%d x %d, case %d", size.width, size.height, i));
        if (HasFatalFailure())
            return;
    }
}

TEST_P(Linespace_Detect, kinds_of_arrays)
{
    const Mat1b edges = smallScene(9);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(8, 0, method(), 3, backend());
    const Lines expected = detectLines(*detector, edges);
    ASSERT_GT(expected.size(), 3u);
    EXPECT_EQ(backend(), detector->getActiveBackend());
    expectSameLines(detectLines(*detector, asWindow(edges)), expected, "window");

    UMat device, deviceLines;
    edges.copyTo(device);
    expectSameLines(
        [&]()
        {
            Lines lines;
            detector->detect(device, lines);
            return lines;
        }(),
        expected, "UMat");
    detector->detect(device, deviceLines);
    ASSERT_EQ(CV_32FC3, deviceLines.type());
    ASSERT_EQ(Size(1, (int)expected.size()), deviceLines.size());
    expectSameLines(Lines(deviceLines.getMat(ACCESS_READ)), expected, "UMat to UMat");

    Mat untyped, used(3, 5, CV_8UC1, Scalar(1));
    detector->detect(edges, untyped);
    ASSERT_EQ(CV_32FC3, untyped.type());
    ASSERT_EQ(Size(1, (int)expected.size()), untyped.size());
    expectSameLines(Lines(untyped), expected, "Mat");
    detector->detect(edges, used);
    expectSameLines(Lines(used), expected, "Mat of another type and size");
    Mat_<Vec3f> typed;
    detector->detect(edges, typed);
    expectSameLines(Lines(typed), expected, "Mat_<Vec3f>");

    // No lines: an empty array, also where there were some.
    const Mat1b black(edges.size(), (uchar)0);
    detector->detect(black, untyped);
    EXPECT_TRUE(untyped.empty());
    detector->detect(black, deviceLines);
    EXPECT_TRUE(deviceLines.empty());
    EXPECT_TRUE(detectLines(*detector, black).empty());
}

TEST_P(Linespace_Detect, the_same_on_every_run_thread_count_and_back_end)
{
    std::vector<Vec2d> drawn;
    const Mat1b edges = linesInNoise(Size(230, 170), 7, 0.03, 3, drawn);
    const int suppressions[] = {SUPPRESS_RING, SUPPRESS_BLOCKS, SUPPRESS_GREEDY};
    for (int i = 0; i < 3; ++i)
        for (int threshold = 0; threshold <= 30; threshold += 30)
        {
            Ptr<LineSpaceDetector> reference =
                LineSpaceDetector::create(threshold, 0, method(), 8, BACKEND_REFERENCE);
            Ptr<LineSpaceDetector> detector =
                LineSpaceDetector::create(threshold, 0, method(), 8, backend());
            reference->setSuppression(suppressions[i]);
            detector->setSuppression(suppressions[i]);
            const Lines expected = detectLines(*reference, edges);
            ASSERT_GE(expected.size(), 7u);
            const int threads[] = {1, 2, 5, 1};
            for (int j = 0; j < 4; ++j)
            {
                ThreadCount count(threads[j]);
                expectSameLines(detectLines(*detector, edges), expected,
                                format("%d threads, suppression %d, threshold %d", threads[j],
                                       suppressions[i], threshold));
            }
            // The strongest few: candidates above a cut, lines refined ahead of their turn.
            for (int selection = SELECT_PEAKS; i == 0 && selection <= SELECT_EXPLAIN; ++selection)
            {
                reference->setSelection(selection);
                detector->setSelection(selection);
                reference->setMaxLines(7);
                detector->setMaxLines(7);
                const Lines few = detectLines(*reference, edges);
                for (int j = 0; j < 3; ++j)
                {
                    ThreadCount count(threads[j]);
                    expectSameLines(
                        detectLines(*detector, edges), few,
                        format("7 lines, %d threads, selection %d", threads[j], selection));
                }
            }
        }
}

TEST_P(Linespace_Detect, detectors_in_different_threads)
{
    const int count = 4;
    std::vector<Mat1b> edges;
    std::vector<Lines> expected, actual(count);
    for (int i = 0; i < count; ++i)
    {
        edges.push_back(randomEdges(Size(60 + 7 * (i % 2), 50), 0.15, i));
        expected.push_back(
            detectLines(*LineSpaceDetector::create(14, 0, method(), 4, backend()), edges.back()));
    }
    std::vector<std::thread> threads;
    for (int i = 0; i < count; ++i)
        threads.push_back(std::thread(
            [&, i]()
            {
                Ptr<LineSpaceDetector> detector =
                    LineSpaceDetector::create(14, 0, method(), 4, backend());
                for (int run = 0; run < 5; ++run)
                    actual[i] = detectLines(*detector, edges[i]);
            }));
    for (int i = 0; i < count; ++i)
        threads[i].join();
    for (int i = 0; i < count; ++i)
        expectSameLines(actual[i], expected[i], format("thread %d", i));
}

TEST_P(Linespace_Detect, black_and_white)
{
    const Size sizes[] = {Size(1, 1), Size(9, 1), Size(40, 33), Size(64, 64)};
    for (int i = 0; i < 4; ++i)
        for (int threshold = 0; threshold <= 20; threshold += 10)
        {
            Ptr<LineSpaceDetector> detector =
                LineSpaceDetector::create(threshold, 0, method(), 8, backend());
            EXPECT_TRUE(detectLines(*detector, Mat1b(sizes[i], (uchar)0)).empty());
            const Lines lines = detectLines(*detector, whiteEdges(sizes[i]));
            for (size_t j = 0; j < lines.size(); ++j)
            {
                ASSERT_LE(lines[j][2], std::max(sizes[i].width, sizes[i].height));
                ASSERT_GT(lines[j][2], threshold);
            }
            if (threshold == 0) // where every pixel is an edge, no line is a surprise
                EXPECT_TRUE(lines.empty()) << sizes[i];
            else
                EXPECT_EQ(std::max(sizes[i].width, sizes[i].height) <= threshold, lines.empty())
                    << sizes[i];
        }
}

// Refinement moves a line by at most a pixel at its ends; votes and order stay.
TEST_P(Linespace_Detect, refinement_moves_lines_by_a_pixel_at_most)
{
    std::vector<Vec2d> drawn;
    const Size size(160, 120);
    const Mat1b edges = linesInNoise(size, 6, 0.02, 5, drawn);
    Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(30, 0, method(), 8, backend());
    detector->setSuppressionRadius(0);
    detector->setSuppressionDistance(0); // refined lines may come near each other
    const Lines refined = detectLines(*detector, edges);
    detector->setRefine(REFINE_NONE);
    const Lines chords = detectLines(*detector, edges);
    ASSERT_EQ(chords.size(), refined.size());
    ASSERT_GT(chords.size(), 20u);
    for (size_t i = 0; i < chords.size(); ++i)
    {
        ASSERT_EQ(chords[i][2], refined[i][2]) << "line " << i;
        ASSERT_LE(brute::endDistance(Vec2d(chords[i][0], chords[i][1]),
                                     Vec2d(refined[i][0], refined[i][1]), size),
                  1 + 1e-3)
            << "line " << i << " " << chords[i] << " became " << refined[i];
    }
}

// Drawn lines are found: each has a reported line whose ends are near, and refinement brings them
// nearer.
TEST_P(Linespace_Detect, drawn_lines_are_found_and_refined)
{
    double error[2] = {0, 0};
    const Size size(160, 120);
    for (unsigned seed = 1; seed <= 4; ++seed)
    {
        std::vector<Vec2d> drawn;
        const Mat1b edges = linesInNoise(size, 6, 0.02, seed, drawn);
        Ptr<LineSpaceDetector> detector = LineSpaceDetector::create(50, 0, method(), 8, backend());
        const int refinements[] = {REFINE_NONE, REFINE_LEAST_SQUARES};
        for (int r = 0; r < 2; ++r)
        {
            detector->setRefine(refinements[r]);
            const Lines lines = detectLines(*detector, edges);
            for (size_t i = 0; i < drawn.size(); ++i)
            {
                double nearest = DBL_MAX;
                for (size_t j = 0; j < lines.size(); ++j)
                    nearest = std::min(
                        nearest,
                        brute::endDistance(drawn[i], Vec2d(lines[j][0], lines[j][1]), size));
                EXPECT_LT(nearest, r == 0 ? 4 : 1.5) << "seed " << seed << ", line " << drawn[i];
                error[r] += nearest / (4 * drawn.size());
            }
        }
    }
    // Means over the lines, in pixels.
    EXPECT_LT(error[1], 0.75 * error[0]);
    EXPECT_LT(error[1], 0.35);
}

// The cascade's own maximum near a line is often a neighbour of its chord, with far fewer exact
// votes: the candidates climb.
TEST_P(Linespace_Detect, a_line_alone_is_found)
{
    const Size size(200, 150);
    RNG rng(77);
    int drawn = 0, lost = 0;
    while (drawn < (backend() == BACKEND_REFERENCE ? 10 : 100))
    {
        const double theta = rng.uniform(0., CV_PI);
        const Vec2d line(rng.uniform(0., 200.) * std::cos(theta) +
                             rng.uniform(0., 150.) * std::sin(theta),
                         theta);
        Mat1b edges(size, (uchar)0);
        addLine(edges, line[0], line[1]);
        const int pixels = countNonZero(edges);
        if (pixels < 50)
            continue;
        ++drawn;
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(pixels * 7 / 10, 0, method(), 8, backend());
        detector->setCandidateRatio(0.5);
        const Lines lines = detectLines(*detector, edges);
        double nearest = DBL_MAX;
        for (size_t i = 0; i < lines.size(); ++i)
            nearest =
                std::min(nearest, brute::endDistance(line, Vec2d(lines[i][0], lines[i][1]), size));
        lost += nearest > 1.5;
    }
    EXPECT_LE(lost, method() == METHOD_EXACT ? 0 : 2);
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_Detect,
                        testing::Combine(LINESPACE_TEST_BACKENDS,
                                         testing::Values((int)METHOD_EXACT, (int)METHOD_CASCADED)));

// threshold 0: section 7.

class Linespace_AContrario : public testing::TestWithParam<tuple<int, int>> // back end, method
{
protected:
    Ptr<LineSpaceDetector> create(double falseAlarms) const
    {
        Ptr<LineSpaceDetector> detector =
            LineSpaceDetector::create(0, 0, get<1>(GetParam()), 8, get<0>(GetParam()));
        detector->setFalseAlarms(falseAlarms);
        return detector;
    }
};

TEST_P(Linespace_AContrario, noise_gives_nearly_nothing)
{
    const double densities[] = {0.01, 0.05, 0.2, 0.5, 0.9};
    size_t lines = 0;
    for (int i = 0; i < 20; ++i)
        lines +=
            detectLines(*create(1), randomEdges(Size(110, 90), densities[i % 5], 50 + i)).size();
    EXPECT_LE(lines, 20u); // expected: less than 1 for each image
}

// The rule of independent pixels finds hundreds of lines in each of these.
TEST_P(Linespace_AContrario, edge_maps_without_lines_give_nearly_nothing)
{
    RNG rng(3);
    size_t lines = 0;
    for (int i = 0; i < 10; ++i)
    {
        Mat1b image(200, 230, 128), edges;
        if (i % 2 == 0)
            rng.fill(image, RNG::NORMAL, 128, 10);
        else
            for (int k = 0; k < 12; ++k)
                circle(image, Point(rng.uniform(0, 230), rng.uniform(0, 200)), rng.uniform(8, 25),
                       Scalar(rng.uniform(0, 256)), -1, LINE_AA);
        Canny(image, edges, 50, 150);
        lines += detectLines(*create(1), edges).size();
        Mat dx, dy;
        Sobel(image, dx, CV_16S, 1, 0);
        Sobel(image, dy, CV_16S, 0, 1);
        Lines oriented;
        create(1)->detect(edges, dx, dy, oriented);
        lines += oriented.size();
    }
    EXPECT_LE(lines, 1u);
}

TEST_P(Linespace_AContrario, line_in_noise_is_found)
{
    const double densities[] = {0, 0.01, 0.1, 0.3};
    for (int i = 0; i < 4; ++i)
    {
        const Size size(110, 90);
        Mat1b edges = randomEdges(size, densities[i], 60 + i);
        const Vec2d drawn(61.3, 0.9);
        addLine(edges, drawn[0], drawn[1]);
        const Lines lines = detectLines(*create(1), edges);
        ASSERT_FALSE(lines.empty()) << "density " << densities[i];
        EXPECT_LT(brute::endDistance(drawn, Vec2d(lines[0][0], lines[0][1]), size), 1.5);
    }
}

Mat1i cascadeTop(const Mat& edges, int cellSize, const Mat& directions)
{
    const brute::Cascade cascade = brute::cascadeOf(edges.size(), cellSize);
    return brute::cascadeTable(edges, cascade, cascade.levelCount() - 1, false, directions);
}

// By chance, the pixels of a chord are a chain: edge pixels have the share `density`, and the pixel
// after an edge pixel is one with probability `persistence`.
struct Chain
{
    explicit Chain(double share)
        : density(share), persistence(std::max(share, 0.75)),
          begins(share * (1 - persistence) / (1 - share))
    {
    }
    double density, persistence, begins;

    // P(v or more edge pixels in l), by counting through the chain.
    double tail(int length, int votes) const
    {
        // By the number of edge pixels so far, whether the last pixel is one. The pixel before the
        // chord has a state, too, but does not count.
        std::vector<double> outside(length + 1, 0.), inside(length + 1, 0.);
        outside[0] = 1 - density;
        inside[0] = density;
        for (int i = 0; i < length; ++i)
        {
            const std::vector<double> before = outside, beforeInside = inside;
            for (int k = 0; k <= length; ++k)
            {
                outside[k] = before[k] * (1 - begins) + beforeInside[k] * (1 - persistence);
                inside[k] = k == 0 ? 0 : before[k - 1] * begins + beforeInside[k - 1] * persistence;
            }
        }
        double sum = 0;
        for (int k = votes; k <= length; ++k)
            sum += outside[k] + inside[k];
        return sum;
    }
};

double falseAlarms(double chords, int length, double density, int votes)
{
    if (density <= 0 || density >= 1)
        return chords * (density >= 1 || votes == 0);
    return chords * Chain(density).tail(length, votes);
}

// With a mask the density is that within it; with weights the pixels decide, not their sum; with
// gradients those of the chord's direction.
TEST_P(Linespace_AContrario, every_chord_by_the_rule)
{
    const double epsilons[] = {1e-6, 1, 1000, 1e20};
    enum Kind
    {
        PLAIN,
        MASKED,
        WEIGHTED,
        ORIENTED_WEIGHTED
    };
    for (unsigned seed = 1; seed <= 7; ++seed)
    {
        const Kind kind = seed < 5 ? PLAIN : Kind(seed - 4);
        const bool weighted = kind == WEIGHTED || kind == ORIENTED_WEIGHTED;
        const Mat1b given = seed == 4 ? randomEdges(Size(37, 25), 0.8, 9) : smallScene(seed);
        Mat1b edges = given.clone(), mask;
        double pixels = (double)given.total();
        if (kind == MASKED)
        {
            mask = Mat1b(given.size(), (uchar)0);
            mask(Rect(5, 0, given.cols / 2, given.rows)).setTo(1);
            edges.setTo(0, mask == 0);
            pixels = countNonZero(mask);
        }
        const int method = get<1>(GetParam()), cellSize = 4;
        Mat dx, dy, directions;
        if (kind == ORIENTED_WEIGHTED)
        {
            RNG rng(seed);
            dx.create(edges.size(), CV_16SC1);
            dy.create(edges.size(), CV_16SC1);
            rng.fill(dx, RNG::UNIFORM, -50, 51);
            rng.fill(dy, RNG::UNIFORM, -200, 201); // unlike densities of the directions
            directions = brute::directions(dx, dy, 22.5);
        }
        std::vector<double> densities;
        for (int bin = 0; bin < 16; ++bin)
        {
            const Mat voting =
                directions.empty() ? edges : edges & ((directions & (1 << bin)) != 0);
            densities.push_back(countNonZero(voting) / pixels);
        }
        const Size frame = method == METHOD_EXACT
                               ? edges.size()
                               : brute::cascadeOf(edges.size(), cellSize).frame();
        const Mat1i lengths = brute::exactTable(whiteEdges(edges.size()), frame);
        const Mat1i counts = brute::exactTable(edges, frame, false, directions);
        const Mat1i votes = brute::exactTable(edges, frame, weighted, directions);
        // What the cascade does not see at all is no candidate.
        const Mat1i seen =
            method == METHOD_EXACT ? counts : cascadeTop(edges, cellSize, directions);
        double chords = 0;
        for (int s = 0; s < votes.rows; ++s)
            for (int e = s + 1; e < votes.cols; ++e)
                chords += brute::isChord(frame, s, e);
        for (int i = 0; i < 4; ++i)
        {
            Ptr<LineSpaceDetector> detector = createPlain(method, cellSize, get<0>(GetParam()), 0);
            detector->setFalseAlarms(epsilons[i]);
            detector->setMask(mask);
            detector->setEdgeWeights(weighted);
            std::vector<Candidate> expected;
            for (int s = 0; s < votes.rows; ++s)
                for (int e = s + 1; e < votes.cols; ++e)
                {
                    if (seen(s, e) == 0 || counts(s, e) == 0 || !brute::isChord(frame, s, e))
                        continue;
                    const int bin = brute::directionBin(brute::borderPoint(frame, e) -
                                                        brute::borderPoint(frame, s));
                    if (falseAlarms(chords, lengths(s, e), densities[bin], counts(s, e)) <
                        epsilons[i])
                    {
                        const Candidate candidate = {s, e, votes(s, e)};
                        expected.push_back(candidate);
                    }
                }
            std::sort(expected.begin(), expected.end(), brute::isStronger);
            Lines lines;
            if (directions.empty())
                lines = detectLines(*detector, given);
            else
                detector->detect(given, dx, dy, lines);
            expectChords(lines, expected, frame, format("seed %d, epsilon %g", seed, epsilons[i]));
            if (HasFatalFailure())
                return;
            EXPECT_TRUE(epsilons[i] <= 1 || seed == 4 || !expected.empty()) << seed;
        }
    }
}

TEST_P(Linespace_AContrario, fewer_false_alarms_fewer_lines)
{
    std::vector<Vec2d> drawn;
    const Mat1b edges = linesInNoise(Size(110, 90), 3, 0.1, 70, drawn);
    const double falseAlarms[] = {1e-12, 1e-6, 1e-3, 1, 1e3, 1e6};
    size_t before = 0;
    for (int i = 0; i < 6; ++i)
    {
        Ptr<LineSpaceDetector> detector = create(falseAlarms[i]);
        detector->setSuppressionRadius(0); // with it, a stronger neighbour may hide a line
        detector->setSuppressionDistance(0);
        const size_t count = detectLines(*detector, edges).size();
        EXPECT_GE(count, before) << falseAlarms[i];
        before = count;
    }
    EXPECT_GT(before, 3u);
}

INSTANTIATE_TEST_CASE_P(/**/, Linespace_AContrario,
                        testing::Combine(LINESPACE_TEST_BACKENDS,
                                         testing::Values((int)METHOD_EXACT, (int)METHOD_CASCADED)));

} // namespace
} // namespace opencv_test
