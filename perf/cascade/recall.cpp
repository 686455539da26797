// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "recall.hpp"

#include "line_error.hpp"

#include "opencv2/linespace.hpp"

#include <functional>
#include <iomanip>
#include <set>

namespace cascade {

namespace ls = cv::linespace;

namespace {

const char* refineName(int refine)
{
    return refine == ls::REFINE_NONE ? "none" : "least squares";
}

//! Sums of a group of images for one setting.
struct Total
{
    int exactLines = 0, found = 0, foundLonger = 0, foundLongest = 0;
    double worst = 1; //!< smallest share of an image
    std::string worstName;
    std::set<std::string> images;

    void add(const Recall& recall)
    {
        if (recall.exactLines == 0)
            return;
        images.insert(recall.source.group + "/" + recall.source.name);
        exactLines += recall.exactLines;
        found += recall.found;
        foundLonger += recall.foundLonger;
        foundLongest += recall.foundLongest;
        const double share = (double)recall.found / recall.exactLines;
        if (share < worst)
        {
            worst = share;
            worstName = recall.source.name;
        }
    }
};

using Belongs = std::function<bool(const Recall&)>;

Total totalOf(const std::vector<Recall>& recalls, const Belongs& belongs)
{
    Total total;
    for (const Recall& recall : recalls)
        if (belongs(recall))
            total.add(recall);
    return total;
}

double percent(int part, int whole)
{
    return whole == 0 ? 0 : 100. * part / whole;
}

//! A table over cell size (rows) and pool (columns); each entry is the share of lines and the
//! smallest share of an image.
void writeTable(std::ostream& out, const std::vector<Recall>& recalls, const Belongs& belongs)
{
    out << "| k |";
    for (const int pool : poolSizes())
        out << " pool " << poolName(pool) << " |";
    out << "\n| ---: |";
    for (std::size_t i = 0; i < poolSizes().size(); ++i)
        out << " ---: |";
    out << "\n";
    for (const int k : cellSizes())
    {
        out << "| " << k << " |";
        for (const int pool : poolSizes())
        {
            const Total total = totalOf(recalls,
                                        [&](const Recall& recall) {
                                            return recall.detection.cellSize == k &&
                                                   recall.detection.poolSize == pool &&
                                                   belongs(recall);
                                        });
            out << " " << std::setprecision(2) << percent(total.found, total.exactLines) << " ("
                << std::setprecision(0) << 100 * total.worst << ") |";
        }
        out << "\n";
    }
    out << "\n";
}

//! The default setting by groups of images: lists of several lengths, and the worst image.
void writeGroups(std::ostream& out, const std::vector<Recall>& recalls)
{
    std::vector<std::string> groups;
    for (const Recall& recall : recalls)
        if (groups.empty() || groups.back() != recall.source.group)
            groups.push_back(recall.source.group);
    out << "| images | votes | refinement | images with lines | exact lines | " << STRONGEST
        << " lines | " << LONGER << " lines | " << LONGEST
        << " lines | worst image |\n"
           "| --- | --- | --- | ---: | ---: | ---: | ---: | ---: | --- |\n";
    const Detection usual;
    for (const std::string& group : groups)
        for (const bool oriented : {false, true})
            for (const int refine : {ls::REFINE_NONE, ls::REFINE_LEAST_SQUARES})
            {
                const Total total =
                    totalOf(recalls,
                            [&](const Recall& recall)
                            {
                                const Detection& d = recall.detection;
                                return recall.source.group == group && d.oriented == oriented &&
                                       d.refine == refine && d.cellSize == usual.cellSize &&
                                       d.poolSize == usual.poolSize;
                            });
                out << "| " << group << " | " << (oriented ? "oriented" : "plain") << " | "
                    << refineName(refine) << " | " << total.images.size() << " | "
                    << total.exactLines << " | " << std::setprecision(2)
                    << percent(total.found, total.exactLines) << " | "
                    << percent(total.foundLonger, total.exactLines) << " | "
                    << percent(total.foundLongest, total.exactLines) << " | "
                    << (total.worstName.empty() ? "-" : total.worstName) << " "
                    << std::setprecision(0) << 100 * total.worst << " |\n";
            }
    out << "\n";
}

} // namespace

std::vector<cv::Vec3f> linesOf(const Input& input, const Detection& detection)
{
    const bool exact = detection.cellSize == 0;
    const auto detector = ls::LineSpaceDetector::create(
        input.threshold, detection.maxLines, exact ? ls::METHOD_EXACT : ls::METHOD_CASCADED,
        exact ? 8 : detection.cellSize);
    detector->setRefine(detection.refine);
    detector->setPoolSize(detection.poolSize);
    detector->setCandidateRatio(detection.candidateRatio);
    detector->setSuppressionRadius(detection.suppressionRadius);
    std::vector<cv::Vec3f> lines;
    if (detection.oriented)
        detector->detect(input.edges, input.dx, input.dy, lines);
    else
        detector->detect(input.edges, lines);
    return lines;
}

const std::vector<int>& cellSizes()
{
    static const std::vector<int> sizes = {4, 8, 16, 32};
    return sizes;
}

const std::vector<int>& poolSizes()
{
    static const std::vector<int> sizes = {1024, 4096, 8192, 16384, INT_MAX};
    return sizes;
}

std::string poolName(int poolSize)
{
    return poolSize == INT_MAX ? "all" : std::to_string(poolSize);
}

std::vector<Recall> recallsOf(const Input& input)
{
    std::vector<Recall> recalls;
    for (const bool oriented : {false, true})
        for (const int refine : {ls::REFINE_NONE, ls::REFINE_LEAST_SQUARES})
        {
            Detection detection;
            detection.oriented = oriented;
            detection.refine = refine;
            detection.cellSize = 0;
            std::vector<cv::Vec4f> ends;
            ls::lineEndPoints(linesOf(input, detection), input.edges.size(), ends);
            for (const int cellSize : cellSizes())
                for (const int poolSize : poolSizes())
                {
                    detection.cellSize = cellSize;
                    detection.poolSize = poolSize;
                    // A shorter list of the same pool is the beginning of a longer one.
                    const bool isPoolKept = poolSize / 16 >= LONGEST;
                    detection.maxLines = isPoolKept ? LONGEST : STRONGEST;
                    const auto lines = linesOf(input, detection);
                    recalls.push_back({input.source, detection, (int)ends.size(),
                                       countFound(ends, lines, STRONGEST),
                                       isPoolKept ? countFound(ends, lines, LONGER) : -1,
                                       isPoolKept ? countFound(ends, lines, LONGEST) : -1});
                }
        }
    return recalls;
}

std::vector<FrameRecall> frameRecallsOf(const Input& input)
{
    const auto cascaded = ls::LineSpaceDetector::create();
    std::vector<cv::Vec3f> unused;
    cascaded->detect(input.edges, unused); // the frame follows from the size
    const cv::Size frame = cascaded->getFrameSize(), image = input.edges.size();
    Input padded = input;
    const auto pad = [&](const cv::Mat& from, cv::Mat& to)
    {
        cv::copyMakeBorder(from, to, 0, frame.height - image.height, 0, frame.width - image.width,
                           cv::BORDER_CONSTANT, 0);
    };
    pad(input.edges, padded.edges);
    pad(input.dx, padded.dx);
    pad(input.dy, padded.dy);

    std::vector<FrameRecall> recalls;
    for (const bool oriented : {false, true})
    {
        Detection detection;
        detection.oriented = oriented;
        const auto reported = linesOf(input, detection);
        detection.cellSize = 0;
        std::vector<cv::Vec4f> ends;
        ls::lineEndPoints(linesOf(input, detection), image, ends);
        const auto onFrame = linesOf(padded, detection);
        recalls.push_back({oriented, frame != image, (int)ends.size(),
                           countFound(ends, reported, STRONGEST),
                           countFound(ends, onFrame, STRONGEST)});
    }
    return recalls;
}

void writeFrameTable(std::ostream& out, const std::vector<FrameRecall>& recalls)
{
    out << std::fixed << std::setprecision(2)
        << "| frame | votes | images | exact lines | cascade | exact method on the frame |\n"
           "| --- | --- | ---: | ---: | ---: | ---: |\n";
    for (const bool padded : {false, true})
        for (const bool oriented : {false, true})
        {
            int images = 0, exactLines = 0, byCascade = 0, onFrame = 0;
            for (const FrameRecall& recall : recalls)
                if (recall.padded == padded && recall.oriented == oriented)
                {
                    ++images;
                    exactLines += recall.exactLines;
                    byCascade += recall.foundByCascade;
                    onFrame += recall.foundOnFrame;
                }
            out << "| " << (padded ? "padded" : "the image") << " | "
                << (oriented ? "oriented" : "plain") << " | " << images << " | " << exactLines
                << " | " << percent(byCascade, exactLines) << " | " << percent(onFrame, exactLines)
                << " |\n";
        }
    out << "\n";
}

void writeRecallTables(std::ostream& out, const std::vector<Recall>& recalls)
{
    out << std::fixed << "### At the defaults\n\nk = 8, pool " << Detection().poolSize
        << ", by the number of lines asked "
           "for; percent of the exact method's lines.\n\n";
    writeGroups(out, recalls);
    for (const bool synthetic : {false, true})
        for (const bool oriented : {false, true})
            for (const int refine : {ls::REFINE_NONE, ls::REFINE_LEAST_SQUARES})
            {
                const Belongs belongs = [&](const Recall& recall)
                {
                    return (recall.source.group == "synthetic") == synthetic &&
                           recall.detection.oriented == oriented &&
                           recall.detection.refine == refine;
                };
                if (totalOf(recalls, belongs).images.empty())
                    continue;
                out << "### " << (synthetic ? "Synthetic scenes" : "Photographs") << ", "
                    << (oriented ? "oriented" : "plain") << ", refinement: " << refineName(refine)
                    << "\n\n";
                writeTable(out, recalls, belongs);
            }
}

void writeRecallCsv(std::ostream& out, const std::vector<Recall>& recalls)
{
    out << "group,image,oriented,refine,k,pool,exact_lines,found_in_100,found_in_105,found_in_"
           "256\n";
    for (const Recall& recall : recalls)
    {
        const Detection& d = recall.detection;
        out << recall.source.group << "," << recall.source.name << "," << d.oriented << ","
            << d.refine << "," << d.cellSize << "," << poolName(d.poolSize) << ","
            << recall.exactLines << "," << recall.found << "," << recall.foundLonger << ","
            << recall.foundLongest << "\n";
    }
}

} // namespace cascade
