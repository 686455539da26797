// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "ways.hpp"

#include "gl_shaders_ways.hpp"

#include "benchmark/stage_work.hpp"

namespace ways {

namespace {

using ls::BorderPart;
using ls::GlMerging;
using ls::Merge;
using ls::MergeRectangle;
using ls::VoteTable;

//! Tables of what a way makes, and whether they are the library's.
class Made
{
public:
    explicit Made(Input& input) : input_(input), tables_(input.levels.size())
    {
        for (int l = 0; l < input.plan->levelCount(); ++l)
        {
            const VoteTable& table = input.levels[l];
            input.executor.allocate(input.plan->level(l), table.depth, tables_[l]);
            // No result of an earlier way may stand in for one.
            const std::vector<uchar> other(bytesOf(table), (uchar)0xA5);
            input.device.upload(other, static_cast<ls::GlBuffer&>(*tables_[l].memory));
        }
    }
    VoteTable& at(int l) { return tables_[l]; }
    bool isRight(int l)
    {
        std::vector<uchar> both[2];
        for (int i = 0; i < 2; ++i)
        {
            const VoteTable& table = i == 0 ? tables_[l] : input_.levels[l];
            both[i].resize(bytesOf(table));
            input_.device.read(bufferOf(table), both[i].size(), both[i].data());
        }
        return both[0] == both[1];
    }

private:
    Input& input_;
    std::vector<VoteTable> tables_;
};

//! As the library does, but that chords which cross bring their parts to shared memory.
void mergeShared(Input& input, int l, VoteTable& parent)
{
    const GlMerging merging(input.device, input.levels[l - 1], parent);
    const int chunk = std::min(4, ls::logOf(merging.words)), side = 8;
    bool isBeside = false;
    for (const std::vector<MergeRectangle>& alike : ls::alikeRectangles(input.plan->merge(l)))
    {
        const MergeRectangle& any = alike.front();
        if (any.isCrossing)
            merging.run(ls::GlLaunch(input.device, merge_shared_glsl,
                                     merging.options + ls::define("CHUNK_LOG", chunk)),
                        alike, 0, bytesOf(parent),
                        (any.columns + side - 1) / side * ls::GlDevice::GROUP,
                        (any.rows + side - 1) / side, isBeside);
        else
            merging.run(input.device, alike, 0, bytesOf(parent), isBeside);
        isBeside = true;
    }
}

//! Part of the upper parent's border on one side of one cell of the level before the one below.
struct Piece
{
    BorderPart ofParent, ofChild;
};

std::vector<Piece> piecesOf(const Merge& upper, const Merge& lower)
{
    std::vector<Piece> pieces;
    for (const BorderPart& part : ls::borderParts(upper))
    {
        const int point = upper.childPoint(part.first);
        for (const BorderPart& own : ls::borderParts(lower))
            if (upper.child.sideOf(own.first) == upper.child.sideOf(point))
                pieces.push_back({{part.first + own.first - point, own.count}, own});
    }
    return pieces;
}

//! A rectangle of the lower merge with the ends in this order.
MergeRectangle inOrder(const Merge& lower, const BorderPart& first, const BorderPart& second)
{
    if (first.first < second.first)
        return ls::mergeRectangle(lower, first, second);
    MergeRectangle r = ls::mergeRectangle(lower, second, first);
    std::swap(r.stepS, r.stepE);
    if (!r.isCrossing)
        return r;
    r.childS = 1 - r.childS;
    std::swap(r.partS, r.partE);
    std::swap(r.sharedS, r.sharedE);
    std::swap(r.alongS, r.alongE);
    std::swap(r.alongStepS, r.alongStepE);
    std::swap(r.acrossS, r.acrossE);
    std::swap(r.acrossStepS, r.acrossStepE);
    return r;
}

void append(const MergeRectangle& r, std::vector<cv::Vec4i>& fours)
{
    fours.push_back({r.isCrossing, r.childS, (int)r.partS, (int)r.stepS});
    fours.push_back({(int)r.sharedS, (int)r.partE, (int)r.stepE, (int)r.sharedE});
    fours.push_back({r.alongS, r.alongStepS, r.acrossS, r.acrossStepS});
    fours.push_back({r.alongE, r.alongStepE, r.acrossE, r.acrossStepE});
}

//! As merge_two.glsl has them.
std::vector<cv::Vec4i> rectanglesOfTwo(const Merge& upper, const Merge& lower, cv::Size& largest)
{
    const std::vector<Piece> pieces = piecesOf(upper, lower);
    const auto shared = [&](int child) // its parts, in the order of the border
    {
        std::vector<BorderPart> parts;
        for (const BorderPart& part : ls::borderParts(lower))
            if (lower.parent.sideOf(part.first) == lower.parent.sideOf(upper.sharedPoint(child, 0)))
                parts.push_back(part);
        return parts;
    };
    std::vector<cv::Vec4i> fours;
    for (size_t i = 0; i < pieces.size(); ++i)
        for (size_t k = i + 1; k < pieces.size(); ++k)
        {
            const Piece &s = pieces[i], &e = pieces[k];
            if (!upper.parent.isChord(s.ofParent.first, e.ofParent.first))
                continue;
            const MergeRectangle r = ls::mergeRectangle(upper, s.ofParent, e.ofParent);
            largest.width = std::max(largest.width, r.columns);
            largest.height = std::max(largest.height, r.rows);
            const int child = r.childS;
            fours.push_back({r.columns, r.rows, (int)r.start, r.rowLength});
            fours.push_back({r.isCrossing, child, 0, 0});
            fours.push_back({r.alongS, r.alongStepS, r.acrossS, r.acrossStepS});
            fours.push_back({r.alongE, r.alongStepE, r.acrossE, r.acrossStepE});
            fours.push_back({upper.sharedDirection(child) < 0, upper.sharedDirection(1 - child) < 0,
                             upper.sharedCount(), shared(child).front().count});
            const size_t end = fours.size() + 16;
            if (r.isCrossing)
                for (int j = 0; j < 2; ++j)
                    for (const int half : {0, 1})
                    {
                        const std::vector<BorderPart> parts = shared(j == 0 ? child : 1 - child);
                        append(inOrder(lower, (j == 0 ? s : e).ofChild,
                                       parts[std::min<size_t>(half, parts.size() - 1)]),
                               fours);
                    }
            else
                append(inOrder(lower, s.ofChild, e.ofChild), fours);
            fours.resize(end);
        }
    return fours;
}

//! Levels l - 1 and l from level l - 2.
class TwoLevels
{
public:
    TwoLevels(Input& input, int l, VoteTable& parent)
        : input_(input), merging_(input.device, input.levels[l - 2], parent)
    {
        const std::vector<cv::Vec4i> fours =
            rectanglesOfTwo(input.plan->merge(l), input.plan->merge(l - 1), largest_);
        layers_ = (int)fours.size() / 21;
        input.device.upload(fours, rectangles_);
    }
    void run()
    {
        ls::GlLaunch(input_.device, merge_two_glsl, merging_.options)
            .windows(bufferOf(merging_.child), bytesOf(merging_.child))
            .block(bufferOf(merging_.parent))
            .block(rectangles_)
            .runRows(merging_.numbers(), largest_.width << merging_.lanesLog, largest_.height,
                     layers_, false);
    }

private:
    Input& input_;
    const GlMerging merging_;
    ls::GlBuffer rectangles_;
    cv::Size largest_;
    int layers_;
};

} // namespace

std::vector<Way> mergeWays(Input& input)
{
    const int last = input.plan->levelCount() - 1;
    CV_Assert(last % 2 == 0); // of a square
    double loads = 0, stores = 0, adds = 0, sharedLoads = 0, twoLoads = 0, twoStores = 0;
    const std::vector<benchmark::WordWork> work =
        benchmark::wordWork(input.plan->imageSize(), 8); // that of level l at l + 1
    for (int l = last; l > 0; --l)
    {
        const benchmark::WordWork& level = work[l + 1];
        loads += level.loads;
        stores += level.stores;
        adds += level.adds;
        sharedLoads += level.sharedLoads;
        if ((last - l) % 2 == 0)
        {
            twoLoads += level.fusedLoads;
            twoStores += level.stores;
        }
    }

    const auto everyLevel = [&](const std::string& name, double loaded,
                                const std::function<void(int, VoteTable&)>& merge)
    {
        const auto made = std::make_shared<Made>(input);
        const auto queue = [made, merge, last]()
        {
            for (int l = 1; l <= last; ++l)
                merge(l, made->at(l));
        };
        const auto isRight = [made, last]()
        {
            bool areAll = true;
            for (int l = 1; l <= last; ++l)
                areAll = areAll && made->isRight(l);
            return areAll;
        };
        return Way{"merge", name, 0, nullptr, queue, isRight, false, loaded, stores, adds};
    };
    const auto directly = [&input](int l, VoteTable& parent)
    {
        input.executor.mergeCells(*input.plan, l, input.levels[l - 1], parent);
    };

    const auto made = std::make_shared<Made>(input);
    std::vector<std::shared_ptr<TwoLevels>> pairs;
    for (int l = last; l > 1; l -= 2)
        pairs.push_back(std::make_shared<TwoLevels>(input, l, made->at(l)));
    const auto two = [pairs]()
    {
        for (auto pair = pairs.rbegin(); pair != pairs.rend(); ++pair)
            (*pair)->run();
    };
    const auto areTwoRight = [made, last]()
    {
        bool areAll = true;
        for (int l = last; l > 0; l -= 2)
            areAll = areAll && made->isRight(l);
        return areAll;
    };
    return {everyLevel("directly (the library)", loads, directly),
            everyLevel("shared memory", sharedLoads,
                       [&input](int l, VoteTable& parent) { mergeShared(input, l, parent); }),
            Way{"merge", "2 x 2 cells at once", 0, nullptr, two, areTwoRight, false, twoLoads,
                twoStores, twoLoads - twoStores}};
}

} // namespace ways
