// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "gl_cascade.hpp"

#ifdef LINESPACE_OPENGL

#include "gl_ascent.hpp"
#include "gl_maxima.hpp"
#include "gl_merge.hpp"

#include <climits>
#include <cstring>

namespace cv {
namespace linespace {

namespace {

class OpenGlExecutor : public Executor
{
public:
    OpenGlExecutor() : device_(GlDevice::take()), hasCorners_(false) {}
    ~OpenGlExecutor()
    {
        release();
        GlDevice::giveBack(device_);
    }

    int backend() const CV_OVERRIDE { return BACKEND_OPENGL; }
    bool isUsable() const CV_OVERRIDE { return device_->isForThisThread() && device_->works(); }
    void begin() CV_OVERRIDE
    {
        device_->begin();
        device_->stamp();
    }
    void end() CV_OVERRIDE { device_->end(); }

    void endStage(const String& name, StageTimes& times) CV_OVERRIDE
    {
        device_->stamp();
        times.end(name);
    }
    void settleTimes(StageTimes& times) CV_OVERRIDE { times.correctLast(device_->laps()); }

    void allocate(const Level& level, int depth, VoteTable& table) CV_OVERRIDE
    {
        table.setShape(level, depth);
        const Cell& cell = level.cell;
        if (table.chords > INT_MAX || (double)table.chords * wordsOf(table) > UINT_MAX)
            throw DeviceFailure("the frame has too many chords for 32-bit numbers");
        // Products of crossings and rasters, here and below.
        asShaderInt(4. * cell.width * cell.height + 4. * std::max(cell.width, cell.height));
        if (!table.memory)
            table.memory = makePtr<GlBuffer>();
        device_->allocate(static_cast<GlBuffer&>(*table.memory), bytesOf(table));
    }

    void firstCells(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        prepare(plan);
        bringEdges(edges, plan);
        if (!hasCorners_)
            listCorners(plan);
        const Level& level = plan.level(0);
        const bool isOriented = edges.isOriented();
        const size_t words = wordsOf(table.cells, 1),
                     directionWords = wordsOf(table.cells, sizeof(ushort));
        gather(plan, image_, words, std::string(), planes_);
        if (isOriented)
            gather(plan, directions_, directionWords, define("DIRECTIONS"), directionPlanes_);
        if (table.depth > 2)
            throw DeviceFailure("a cell has too many votes for 16-bit numbers");
        const int lanes = logOf(std::min<size_t>(wordsOf(table), GlDevice::GROUP));
        forEachPart(table,
                    [&](int first, int count, size_t offset, size_t bytes)
                    {
                        GlLaunch launch(*device_, GL_FIRST_CELLS,
                                        define("PARENT_BITS", 8 * table.depth) +
                                            (isOriented ? orientedOptions() : std::string()));
                        launch.block(planes_).block(bufferOf(table), offset, bytes);
                        if (isOriented)
                            launch.block(directionPlanes_);
                        launch.runItems({first, count, level.cell.width, level.cell.height, lanes,
                                         (int)wordsOf(table), (int)words, (int)directionWords},
                                        (size_t)count << lanes);
                    });
    }

    void mergeCells(const Plan& plan, int l, const VoteTable& child, VoteTable& parent) CV_OVERRIDE
    {
        const GlMerging merging(*device_, child, parent);
        bool isBeside = false; // then they read what none of them writes
        for (const std::vector<MergeRectangle>& alike : alikeRectangles(plan.merge(l)))
            if (bytesOf(parent) <= device_->limits().blockBytes)
            {
                merging.run(*device_, alike, 0, bytesOf(parent), isBeside);
                isBeside = true;
            }
            else
                for (const MergeRectangle& rectangle : alike)
                {
                    mergeInParts(merging, rectangle, isBeside);
                    isBeside = true;
                }
    }

    void exactVotes(const EdgeMap& edges, const Plan& plan, VoteTable& table) CV_OVERRIDE
    {
        prepare(plan);
        bringEdges(edges, plan);
        const GlPixels pixels = pixelsOf(edges, plan);
        forEachPart(table,
                    [&](int first, int count, size_t offset, size_t bytes)
                    {
                        GlLaunch launch(*device_, GL_EXACT, pixels.options(EXACT_MAP));
                        launch.block(bufferOf(table), offset, bytes);
                        pixels.giveTo(launch, EXACT_MAP);
                        launch.runItems(pixels.numbers({first, count}), count);
                    });
    }

    bool findMaxima(const EdgeMap& edges, const Plan& plan, const VoteTable& table,
                    const Wanted& wanted, int suppression, int radius, int ascentRadius,
                    std::vector<Candidate>& found, bool& areCounted) CV_OVERRIDE
    {
        bool isDone = false;
        const auto count = [&](const GlBuffer& candidates, int room, bool goesOn)
        {
            // Now, as the wait for the candidates is one for the bits as well.
            if (readsBits(edges))
                ascent_.pack(*device_);
            if (ascentRadius >= 0)
                isDone = ascent_.count(*device_, ascentRadius, candidates, room, goesOn);
        };
        if (!maxima_.find(*device_, edges, plan, bufferOf(table), wanted, suppression, radius,
                          count, found))
            return false;
        areCounted = areCounted || isDone;
        return true;
    }

    bool readsBits(const EdgeMap& edges) const CV_OVERRIDE { return !edges.isOriented(); }
    void readBits(const EdgeMap&, const Plan&, EdgeBits& bits) CV_OVERRIDE
    {
        ascent_.readBits(*device_, bits);
    }

    void rescore(const EdgeMap& edges, const Plan& plan, const std::vector<Chord>& chords,
                 std::vector<int>& votes) CV_OVERRIDE
    {
        votes.resize(chords.size());
        if (chords.empty())
            return;
        static_assert(sizeof(Chord) == 2 * sizeof(int), "an ivec2 of the device");
        device_->upload(chords, chords_);
        device_->allocate(sums_, votes.size() * sizeof(int));
        const GlPixels pixels = pixelsOf(edges, plan);
        const size_t most = device_->limits().blockBytes / sizeof(Chord);
        for (size_t first = 0; first < chords.size(); first += most)
        {
            const size_t count = std::min(most, chords.size() - first);
            GlLaunch launch(*device_, GL_EXACT, pixels.options(EXACT_MAP) + define("LIST"));
            launch.block(sums_, first * sizeof(int), count * sizeof(int))
                .block(chords_, first * sizeof(Chord), count * sizeof(Chord));
            pixels.giveTo(launch, EXACT_MAP);
            launch.runItems(pixels.numbers({0, (int)count}), count);
        }
        device_->finish();
        device_->read(sums_, votes.size() * sizeof(int), votes.data());
    }

    Size textureSize(unsigned int texture) CV_OVERRIDE
    {
        if (!device_->isCallers())
            CV_Error_(Error::StsBadArg, ("texture = %u: no context of OpenGL is current", texture));
        bool isInteger;
        return device_->bindTexture(texture, isInteger);
    }

    void takeTexture(unsigned int texture, bool weighted, const Mat& mask) CV_OVERRIDE
    {
        bool isInteger;
        const Size size = taken_ = device_->bindTexture(texture, isInteger);
        const int pixels = asShaderInt((double)size.width * size.height + sizeof(uint));
        device_->allocate(image_, pixels);
        if (!mask.empty())
            device_->upload(mask.data, mask.total(), mask_);
        GlLaunch launch(*device_, GL_TEXTURE,
                        (isInteger ? define("INTEGER") : std::string()) +
                            (weighted ? std::string() : define("BINARY")) +
                            (mask.empty() ? std::string() : define("MASKED")));
        const int none = 0;
        device_->upload(&none, sizeof(none), voters_);
        launch.block(image_).block(voters_);
        if (!mask.empty())
            launch.block(mask_);
        launch.runItems({size.width, size.area()}, (size.area() + sizeof(uint) - 1) / sizeof(uint));
    }

    int countTaken() CV_OVERRIDE
    {
        int count = 0;
        device_->finish();
        device_->read(voters_, sizeof(count), &count);
        return count;
    }

    void readTaken(Mat& votes) CV_OVERRIDE
    {
        votes.create(taken_, CV_8UC1);
        device_->finish();
        device_->read(image_, votes.total(), votes.data);
    }

    void fetch(VoteTable& table) CV_OVERRIDE
    {
        table.buffer.allocate(table.bytes() + VoteTable::PADDING);
        device_->finish();
        const size_t used = table.cells * table.depth; // bytes of a chord
        device_->readParts(bufferOf(table), bytesOf(table),
                           [&](const void* part, size_t offset, size_t bytes)
                           {
                               uchar* const to = table.buffer.data();
                               if (used >= sizeof(uint))
                               {
                                   std::memcpy(to + offset, part, bytes);
                                   return;
                               }
                               const size_t first = offset / sizeof(uint);
                               const uint* const words = (const uint*)part;
                               for (size_t i = 0; i < bytes / sizeof(uint); ++i)
                                   if (used == sizeof(ushort))
                                       ((ushort*)to)[first + i] = (ushort)words[i];
                                   else
                                       to[first + i] = (uchar)words[i];
                           });
    }

private:
    void release()
    {
        GlBuffer* const buffers[] = {&corners_, &image_,           &mask_,   &voters_, &directions_,
                                     &planes_,  &directionPlanes_, &chords_, &sums_};
        for (GlBuffer* buffer : buffers)
            buffer->release();
        maxima_.release();
        ascent_.release();
        hasCorners_ = false;
    }

    enum
    {
        EXACT_MAP = 2 //!< where exact.glsl has the map
    };

    //! As many rows at a time as a block holds, which begins where it may.
    void mergeInParts(const GlMerging& merging, const MergeRectangle& all, bool isBeside)
    {
        const size_t bytes = merging.words * sizeof(uint), limit = device_->limits().blockBytes;
        const size_t slack = device_->limits().alignment, row = all.rowLength * bytes;
        if (row + slack > limit)
            throw DeviceFailure("a row of chords is more than a storage block holds");
        const int most = (int)std::min<size_t>(all.rows, (limit - slack) / row);
        for (int first = 0; first < all.rows; first += most)
        {
            MergeRectangle part = all;
            part.rows = std::min(most, all.rows - first);
            const size_t begin = (all.start + (size_t)first * all.rowLength) * bytes,
                         end = begin + (part.rows - 1) * row + all.columns * bytes;
            // A whole number of chords before it, as both are powers of two.
            const size_t offset = begin / std::max(slack, bytes) * std::max(slack, bytes);
            part.start = (begin - offset) / bytes;
            part.partS += first * all.stepS;
            part.alongS += first * all.alongStepS;
            part.acrossS += first * all.acrossStepS;
            merging.run(*device_, std::vector<MergeRectangle>(1, part), offset, end - offset,
                        isBeside || first > 0);
        }
    }

    //! Calls launch(first chord, number, offset, bytes) for parts of a table that a block can hold.
    template<class Launch>
    void forEachPart(const VoteTable& table, Launch launch) const
    {
        const size_t bytes = wordsOf(table) * sizeof(uint);
        size_t most = device_->limits().blockBytes / bytes;
        // Parts begin where a block may begin.
        const size_t together = std::max<size_t>(1, device_->limits().alignment / bytes);
        most = most / together * together;
        if (most == 0)
            throw DeviceFailure("the votes of a chord are more than a storage block holds");
        for (size_t first = 0; first < table.chords; first += most)
        {
            const size_t count = std::min(most, table.chords - first);
            launch((int)first, (int)count, first * bytes, count * bytes);
        }
    }

    //! Forgets what is known of another plan.
    void prepare(const Plan& plan)
    {
        const Cell& cell = plan.level(0).cell;
        const Vec<int, 5> key(plan.imageSize().width, plan.imageSize().height, cell.width,
                              cell.height, plan.levelCount());
        if (plan_ == key)
            return;
        plan_ = key;
        hasCorners_ = false;
    }

    //! Of the cells of level 0 in the order of the table.
    void listCorners(const Plan& plan)
    {
        device_->upload(plan.cellCorners(), corners_);
        hasCorners_ = true;
    }

    void bringEdges(const EdgeMap& edges, const Plan& plan)
    {
        ascent_.reset(pixelsOf(edges, plan), edges.weighted);
        if (!edges.isTaken)
            device_->upload(edges.votes.data, edges.votes.total(), image_);
        if (!edges.isOriented())
            return;
        if (std::max(edges.votes.cols, edges.votes.rows) > SHRT_MAX)
            throw DeviceFailure("the image is too large for the 32-bit products of directions");
        device_->upload(edges.directions.data, edges.directions.total() * sizeof(ushort),
                        directions_);
    }

    void gather(const Plan& plan, const GlBuffer& from, size_t words, const std::string& options,
                GlBuffer& planes)
    {
        const Level& level = plan.level(0);
        const size_t pixels = (size_t)level.cell.width * level.cell.height;
        device_->allocate(planes, pixels * words * sizeof(uint));
        GlLaunch(*device_, GL_PLANES, options)
            .block(from)
            .block(corners_)
            .block(planes)
            .runItems({plan.imageSize().width, plan.imageSize().height, level.cell.width,
                       (int)pixels, (int)level.cellCount(), logOf(words)},
                      pixels * words);
    }

    //! The edge map, where the device has it.
    GlPixels pixelsOf(const EdgeMap& edges, const Plan& plan) const
    {
        GlPixels pixels;
        pixels.image = &image_;
        pixels.directions = edges.isOriented() ? &directions_ : 0;
        pixels.size = plan.imageSize();
        pixels.frame = plan.frame();
        return pixels;
    }

    const Ptr<GlDevice> device_;
    Vec<int, 5> plan_; //!< what tells plans apart
    bool hasCorners_;
    GlBuffer corners_;
    GlBuffer image_, directions_; //!< the edge map
    GlBuffer mask_, voters_;      //!< of a texture: the mask, and how many pixels vote
    Size taken_;                  //!< its size
    GlBuffer planes_, directionPlanes_;
    GlBuffer chords_, sums_; //!< of rescore
    GlMaxima maxima_;
    GlAscent ascent_;
};

} // namespace

Ptr<Executor> createOpenGlExecutor()
{
    return makePtr<OpenGlExecutor>();
}

} // namespace linespace
} // namespace cv

#else

namespace cv {
namespace linespace {

Ptr<Executor> createOpenGlExecutor()
{
    throw DeviceFailure("built without OpenGL");
}

} // namespace linespace
} // namespace cv

#endif
