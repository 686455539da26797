// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The detector, whole and by stage. A detector keeps its buffers, so all but the first cycle are
// warm, as in a program that detects lines in one frame after the other.

#include "edge_maps.hpp"

namespace opencv_test {
namespace {

namespace ls = cv::linespace;

typedef perf::TestBaseWithParam<tuple<std::string, cv::Size>> Detector_Photograph;

//! The 100 strongest lines above a fixed threshold, refined.
PERF_TEST_P(Detector_Photograph, detect,
            testing::Combine(testing::Values("building.jpg", "home.jpg"), LINESPACE_SIZES))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    const int threshold = std::min(edges.cols, edges.rows) / 5;
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create(threshold, 100);
    std::vector<cv::Vec3f> lines;
    TEST_CYCLE() detector->detect(edges, lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

//! The same, counting everything.
PERF_TEST_P(Detector_Photograph, detect_unpruned,
            testing::Combine(testing::Values("building.jpg", "home.jpg"), LINESPACE_SIZES))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    const int threshold = std::min(edges.cols, edges.rows) / 5;
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create(threshold, 100);
    detector->setPruning(false);
    std::vector<cv::Vec3f> lines;
    TEST_CYCLE() detector->detect(edges, lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

//! A detector's first image: the plan and all memory are new.
PERF_TEST_P(Detector_Photograph, detect_first,
            testing::Combine(testing::Values("building.jpg"), LINESPACE_SIZES))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    const int threshold = std::min(edges.cols, edges.rows) / 5;
    std::vector<cv::Vec3f> lines;
    TEST_CYCLE() ls::LineSpaceDetector::create(threshold, 100)->detect(edges, lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

//! With the statistical threshold, and one line per edge.
PERF_TEST_P(Detector_Photograph, detect_significant,
            testing::Combine(testing::Values("building.jpg", "home.jpg"), LINESPACE_SIZES))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create(0, 100);
    detector->setSelection(ls::SELECT_EXPLAIN);
    std::vector<cv::Vec3f> lines;
    TEST_CYCLE() detector->detect(edges, lines);
    SANITY_CHECK_NOTHING();
}

//! The same with oriented voting, by given gradients.
PERF_TEST_P(Detector_Photograph, detect_oriented,
            testing::Combine(testing::Values("building.jpg", "home.jpg"), LINESPACE_SIZES))
{
    const cv::Mat grey = greyPhotograph(get<0>(GetParam()), get<1>(GetParam()));
    cv::Mat edges, dx, dy;
    cv::Canny(grey, edges, 50, 150);
    cv::Sobel(grey, dx, CV_16S, 1, 0);
    cv::Sobel(grey, dy, CV_16S, 0, 1);
    // 64 pixels of clutter are too few for a line that chance would not draw as well.
    const int threshold = edges.rows > 64 ? 0 : 16;
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create(threshold, 100);
    detector->setSelection(ls::SELECT_EXPLAIN);
    std::vector<cv::Vec3f> lines;
    TEST_CYCLE() detector->detect(edges, dx, dy, lines);
    EXPECT_FALSE(lines.empty());
    SANITY_CHECK_NOTHING();
}

//! By gradients that are estimated from the edge map.
PERF_TEST_P(Detector_Photograph, detect_oriented_by_edges,
            testing::Combine(testing::Values("building.jpg"), LINESPACE_SIZES))
{
    const cv::Mat edges = photographEdges(get<0>(GetParam()), get<1>(GetParam()));
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create(0, 100);
    detector->setSelection(ls::SELECT_EXPLAIN);
    std::vector<cv::Vec3f> lines;
    TEST_CYCLE() detector->detect(edges, cv::noArray(), cv::noArray(), lines);
    SANITY_CHECK_NOTHING();
}

typedef perf::TestBaseWithParam<cv::Size> Detector_Table;

//! METHOD_EXACT: O(n^3), so small images only.
PERF_TEST_P(Detector_Table, exact,
            testing::Values(cv::Size(64, 64), cv::Size(128, 128), cv::Size(256, 256)))
{
    const cv::Mat edges = photographEdges("building.jpg", GetParam());
    const cv::Ptr<ls::LineSpaceDetector> detector =
        ls::LineSpaceDetector::create(20, 100, ls::METHOD_EXACT);
    std::vector<cv::Vec3f> lines;
    TEST_CYCLE() detector->detect(edges, lines);
    SANITY_CHECK_NOTHING();
}

PERF_TEST_P(Detector_Table, compute,
            testing::Values(cv::Size(64, 64), cv::Size(256, 256), cv::Size(512, 512)))
{
    const cv::Mat edges = photographEdges("building.jpg", GetParam());
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create();
    cv::Mat table;
    TEST_CYCLE() detector->compute(edges, table);
    EXPECT_GT(cv::countNonZero(table), 0);
    SANITY_CHECK_NOTHING();
}

typedef perf::TestBaseWithParam<int> Detector_Level;

typedef perf::TestBaseWithParam<tuple<cv::Size, int>> Detector_Stage;

/** The stages of detect, by their own clock: the first cells, the merges, the search of the last
levels, what counts candidates exactly, and the choice of lines. */
PERF_TEST_P(Detector_Stage, detect, testing::Combine(LINESPACE_SIZES, testing::Range(0, 5)))
{
    static const char* const prefixes[][3] = {{"level 0", "", ""},
                                              {"level ", "", ""},
                                              {"bounds", "bundles", "candidates"},
                                              {"ascent", "", ""},
                                              {"selection", "", ""}};
    const cv::Mat edges = photographEdges("building.jpg", get<0>(GetParam()));
    const int threshold = std::min(edges.cols, edges.rows) / 5, wanted = get<1>(GetParam());
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create(threshold, 100);
    std::vector<cv::Vec3f> lines;
    std::vector<cv::String> stages;
    std::vector<double> milliseconds;
    const double ticks = cv::getTickFrequency() / 1000;
    while (next())
    {
        detector->detect(edges, lines);
        detector->getStageTimes(stages, milliseconds);
        double sum = 0;
        for (size_t i = 0; i < stages.size(); ++i)
            for (int k = 0; k < 3; ++k)
            {
                const cv::String prefix = prefixes[wanted][k];
                if (!prefix.empty() && stages[i].compare(0, prefix.size(), prefix) == 0 &&
                    (wanted != 1 || stages[i] != "level 0"))
                    sum += milliseconds[i];
            }
        // The harness times what runs between start and stop, and a stage has no call of its own:
        // it is given a wait of the stage's time.
        const int64 begin = cv::getTickCount();
        startTimer();
        while (cv::getTickCount() - begin < (int64)(sum * ticks))
            ;
        stopTimer();
    }
    SANITY_CHECK_NOTHING();
}

//! One level after the other of 512 x 512, written out as a table: the difference of two is a
//! merge.
PERF_TEST_P(Detector_Level, computeLevel, testing::Range(0, 13))
{
    const cv::Mat edges = photographEdges("building.jpg", cv::Size(512, 512));
    const cv::Ptr<ls::LineSpaceDetector> detector = ls::LineSpaceDetector::create();
    cv::Mat table;
    TEST_CYCLE() detector->computeLevel(edges, GetParam(), table);
    SANITY_CHECK_NOTHING();
}

} // namespace
} // namespace opencv_test
