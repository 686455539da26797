// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "losses.hpp"

#include "line_error.hpp"
#include "recall.hpp"

#include "opencv2/linespace.hpp"

#include <iomanip>
#include <map>

namespace cascade {

namespace ls = cv::linespace;

namespace {

const char* nameOf(Cause cause)
{
    static const char* const names[CAUSE_COUNT] = {
        "rank, among 105 lines", "rank, among 256 lines",   "pool",         "candidate ratio",
        "not a maximum",         "ratio and not a maximum", "none of these"};
    return names[cause];
}

//! The number of the border point of a frame that is nearest to a point on its border, in OpenCV's
//! coordinates.
int borderPointAt(cv::Size frame, double x, double y)
{
    x += 0.5;
    y += 0.5;
    const auto along = [](double position, int length)
    {
        return std::clamp(cvFloor(position), 0, length - 1);
    };
    const double toTop = y, toRight = frame.width - x, toBottom = frame.height - y, toLeft = x;
    const double least = std::min(std::min(toTop, toRight), std::min(toBottom, toLeft));
    if (least == toTop)
        return along(x, frame.width);
    if (least == toRight)
        return frame.width + along(y, frame.height);
    if (least == toBottom)
        return frame.width + frame.height + along(frame.width - x, frame.width);
    return 2 * frame.width + frame.height + along(frame.height - y, frame.height);
}

//! Votes of the cascade for the chord nearest to a line, and the most of the 3 x 3 around it.
void readVotes(const cv::Mat1i& votes, cv::Size frame, const cv::Vec3f& line, Loss& loss)
{
    std::vector<cv::Vec4f> ends;
    ls::lineEndPoints(std::vector<cv::Vec3f>{line}, frame, ends);
    const int s = borderPointAt(frame, ends[0][0], ends[0][1]);
    const int e = borderPointAt(frame, ends[0][2], ends[0][3]);
    loss.cascadeVotes = loss.cascadeAround = votes(s, e);
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            loss.cascadeAround =
                std::max(loss.cascadeAround, votes((s + i + votes.rows) % votes.rows,
                                                   (e + j + votes.rows) % votes.rows));
}

//! The lists of lines with the changes of Cause, computed when first needed.
class ChangedLists
{
public:
    ChangedLists(const Input& input, bool oriented) : input_(input), oriented_(oriented) {}

    const std::vector<cv::Vec3f>& operator[](Cause cause)
    {
        const auto found = lists_.find(cause);
        if (found != lists_.end())
            return found->second;
        Detection detection;
        detection.oriented = oriented_;
        detection.maxLines = cause == RANK_LONGER ? LONGER : LONGEST;
        if (cause >= POOL)
            detection.poolSize = INT_MAX;
        if (cause == RATIO || cause == BOTH)
            detection.candidateRatio = 0.5;
        if (cause == NO_MAXIMUM || cause == BOTH)
            detection.suppressionRadius = 0;
        return lists_[cause] = linesOf(input_, detection);
    }

private:
    const Input& input_;
    bool oriented_;
    std::map<Cause, std::vector<cv::Vec3f>> lists_;
};

Cause causeOf(ChangedLists& lists, const cv::Vec4f& ends)
{
    for (int cause = 0; cause < NEVER; ++cause)
        if (leastError(ends, lists[(Cause)cause], LONGEST) <= SAME_LINE)
            return (Cause)cause;
    return NEVER;
}

void addLosses(const Input& input, bool oriented, std::vector<Loss>& losses)
{
    Detection detection;
    detection.oriented = oriented;
    const auto reported = linesOf(input, detection);
    detection.cellSize = 0;
    const auto exact = linesOf(input, detection);
    std::vector<cv::Vec4f> ends;
    ls::lineEndPoints(exact, input.edges.size(), ends);

    ChangedLists lists(input, oriented);
    cv::Mat1i votes;
    cv::Size frame;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
        const double neighbour = leastError(ends[i], reported, reported.size());
        if (neighbour <= SAME_LINE)
            continue;
        if (frame.empty())
        {
            const auto detector = ls::LineSpaceDetector::create();
            detector->compute(input.edges, votes);
            frame = detector->getFrameSize();
        }
        Loss loss{input.source,
                  oriented,
                  exact[i],
                  (int)i + 1,
                  input.threshold,
                  reported.empty() ? 0 : (int)reported.back()[2],
                  neighbour,
                  frame != input.edges.size(),
                  -1,
                  -1,
                  causeOf(lists, ends[i])};
        if (!oriented)
            readVotes(votes, frame, exact[i], loss);
        losses.push_back(loss);
    }
}

//! A few examples of each cause, each of another image.
void writeExamples(std::ostream& out, const std::vector<Loss>& losses)
{
    out << "| image | votes | rho | theta | exact votes | rank | threshold | cascade's votes | "
           "best "
           "of 3 x 3 | weakest reported | nearest reported, px | cause |\n"
           "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n";
    const std::size_t most = 3;
    std::map<std::pair<bool, Cause>, std::vector<std::string>> shown;
    for (const Loss& loss : losses)
    {
        auto& images = shown[{loss.oriented, loss.cause}];
        if (images.size() == most || (!images.empty() && images.back() == loss.source.name))
            continue;
        images.push_back(loss.source.name);
        const auto number = [](int votes)
        {
            return votes < 0 ? "-" : std::to_string(votes);
        };
        out << "| " << loss.source.name << " | " << (loss.oriented ? "oriented" : "plain") << " | "
            << std::setprecision(1) << loss.line[0] << " | " << std::setprecision(3) << loss.line[1]
            << " | " << (int)loss.line[2] << " | " << loss.rank << " | " << loss.threshold << " | "
            << number(loss.cascadeVotes) << " | " << number(loss.cascadeAround) << " | "
            << loss.weakest << " | " << std::setprecision(1) << loss.neighbour << " | "
            << nameOf(loss.cause) << " |\n";
    }
    out << "\n";
}

} // namespace

std::vector<Loss> lossesOf(const Input& input)
{
    std::vector<Loss> losses;
    addLosses(input, false, losses);
    addLosses(input, true, losses);
    return losses;
}

void writeLosses(std::ostream& out, const std::vector<Loss>& losses)
{
    out << std::fixed
        << "| brought back by | plain | of them with a line reported within 3 px | in a padded "
           "frame "
           "| oriented | of them with a line reported within 3 px | in a padded frame |\n"
           "| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (int cause = 0; cause < CAUSE_COUNT; ++cause)
    {
        int all[2] = {}, displaced[2] = {}, padded[2] = {};
        for (const Loss& loss : losses)
            if (loss.cause == cause)
            {
                ++all[loss.oriented];
                displaced[loss.oriented] += loss.neighbour <= 3;
                padded[loss.oriented] += loss.padded;
            }
        out << "| " << nameOf((Cause)cause);
        for (const int i : {0, 1})
            out << " | " << all[i] << " | " << displaced[i] << " | " << padded[i];
        out << " |\n";
    }
    out << "\n";
    writeExamples(out, losses);
}

void writeLossesCsv(std::ostream& out, const std::vector<Loss>& losses)
{
    out << "group,image,oriented,rho,theta,exact_votes,rank,threshold,weakest_reported,"
           "nearest_reported_px,padded,cascade_votes,cascade_votes_3x3,cause\n";
    for (const Loss& loss : losses)
        out << loss.source.group << "," << loss.source.name << "," << loss.oriented << ","
            << loss.line[0] << "," << loss.line[1] << "," << loss.line[2] << "," << loss.rank << ","
            << loss.threshold << "," << loss.weakest << "," << loss.neighbour << "," << loss.padded
            << "," << loss.cascadeVotes << "," << loss.cascadeAround << ",\"" << nameOf(loss.cause)
            << "\"\n";
}

} // namespace cascade
