// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "edge_profile.hpp"

namespace cv {
namespace linespace {

namespace {

const int REACH = 3;           // pixels on either side of the line that weigh
const int MAX_GAP = 8;         // columns
const double MAX_OFFSET = 1;   // pixels at the ends; a fit farther away is of something else
const float MOST_GRADIENT = 2; // times the largest one at an edge pixel: no pixel weighs more
const int MAX_STEPS = 20;
const double STILL = 1e-3; // pixels; a step that is smaller at both ends is the last

/** The gradients' components along the normal of a line. In double precision, where neither the
largest nor the smallest floats leave the range, and shorts are what the same floats are. */
class NormalGradients
{
public:
    NormalGradients(const Mat& dx, const Mat& dy, const Columns& columns, const Line& line)
        : dx_(dx, columns.xMajor), dy_(dy, columns.xMajor), isFloat_(dx.type() == CV_32FC1),
          cosine_(std::cos(line.theta)), sine_(std::sin(line.theta))
    {
    }
    double at(int i, int k) const
    {
        return isFloat_ ? component<float>(i, k) : component<short>(i, k);
    }
    /** Those at pixels k, k + 1, ... of column i times a scale, at least 0 and at most `most`, into
    every stride-th float. */
    void read(int i, int k, int count, double scale, float most, float* out, int stride) const
    {
        if (isFloat_)
            readAs<float>(i, k, count, scale, most, out, stride);
        else
            readAs<short>(i, k, count, scale, most, out, stride);
    }

private:
    struct Plane
    {
        const uchar* data;
        size_t alongStep, acrossStep; //!< bytes
        Plane(const Mat& values, bool xMajor)
            : data(values.data), alongStep(xMajor ? values.elemSize() : values.step[0]),
              acrossStep(xMajor ? values.step[0] : values.elemSize())
        {
        }
        const uchar* at(int i, int k) const { return data + i * alongStep + k * acrossStep; }
    };
    template<class Value>
    double component(int i, int k) const
    {
        return *(const Value*)dx_.at(i, k) * cosine_ + *(const Value*)dy_.at(i, k) * sine_;
    }
    template<class Value>
    void readAs(int i, int k, int count, double scale, float most, float* out, int stride) const
    {
        const double cosine = cosine_ * scale, sine = sine_ * scale;
        const uchar *x = dx_.at(i, k), *y = dy_.at(i, k);
        for (int j = 0; j < count; ++j, x += dx_.acrossStep, y += dy_.acrossStep)
        {
            const double scaled = *(const Value*)x * cosine + *(const Value*)y * sine;
            out[j * stride] = (float)std::min(std::max(scaled, 0.), (double)most);
        }
    }

    Plane dx_, dy_;
    bool isFloat_;
    double cosine_, sine_;
};

/** The sign that an edge has in the columns of its line: that of the gradient at the supporting
pixel nearest to the line; 0 without one. */
class EdgeSigns
{
public:
    EdgeSigns(const Columns& columns, const Support& support, const NormalGradients& gradients)
        : range_(columns.within(SUPPORT_DISTANCE)), signs_(range_.size(), 0), supporting_(0),
          largest_(0)
    {
        columns.forEachWithin(
            SUPPORT_DISTANCE, support,
            [&](int i, int first, int mask)
            {
                ++supporting_;
                const double gradient = gradients.at(i, nearest(columns.centre(i), first, mask));
                largest_ = std::max(largest_, std::abs(gradient));
                signs_[i - range_.start] = gradient > 0 ? 1 : gradient < 0 ? -1 : 0;
                if (gradient != 0)
                    own_.push_back(i);
            });
        closeGaps();
    }

    const Range& range() const { return range_; }
    int at(int i) const { return signs_[i - range_.start]; }
    //! The columns whose sign is that of their own pixel, not of their neighbours.
    const std::vector<int>& own() const { return own_; }
    //! Columns with a supporting pixel, whatever its gradient.
    int supporting() const { return supporting_; }
    //! The largest gradient at these pixels.
    double largest() const { return largest_; }

private:
    //! The pixel of a column's mask that is nearest to the line, of two the first.
    static int nearest(double centre, int first, int mask)
    {
        int result = first + (int)trailingZeros32(mask);
        for (mask &= mask - 1; mask != 0; mask &= mask - 1)
        {
            const int k = first + (int)trailingZeros32(mask);
            if (std::abs(k - centre) < std::abs(result - centre))
                result = k;
        }
        return result;
    }

    /** An edge detector leaves out columns by chance, or puts noise in the place of the edge: a
    sign between two of the other one is dropped, and columns between two of one sign take it, if
    these are at most MAX_GAP apart. */
    void closeGaps()
    {
        std::vector<int> kept;
        for (size_t j = 0; j < own_.size(); ++j)
        {
            const bool inside =
                j > 0 && j + 1 < own_.size() && own_[j + 1] - own_[j - 1] <= MAX_GAP;
            if (!inside || at(own_[j]) == at(own_[j - 1]) || at(own_[j]) == at(own_[j + 1]))
                kept.push_back(own_[j]);
        }
        std::vector<schar> signs(signs_.size(), 0);
        for (size_t j = 0; j < kept.size(); ++j)
            signs[kept[j] - range_.start] = (schar)at(kept[j]);
        signs_.swap(signs);
        for (size_t j = 1; j < kept.size(); ++j)
            if (kept[j] - kept[j - 1] <= MAX_GAP && at(kept[j]) == at(kept[j - 1]))
                std::fill(signs_.begin() + (kept[j - 1] - range_.start),
                          signs_.begin() + (kept[j] - range_.start), (schar)at(kept[j]));
        own_.swap(kept);
    }

    Range range_;
    std::vector<schar> signs_;
    std::vector<int> own_;
    int supporting_;
    double largest_;
};

enum
{
    BLOCK = 4 //!< columns that are summed up at once
};

//! Sums of values, values times t and values times t^2, each in BLOCK parts.
class BlockSums
{
public:
    BlockSums()
    {
        for (int power = 0; power < 3; ++power)
            std::fill(sums_[power], sums_[power] + BLOCK, 0.);
    }
    void add(const float* t, const float* values)
    {
#if LINESPACE_SIMD128_64F
        const v_float32x4 ts = v_load(t), all = v_load(values);
        addHalf(0, v_cvt_f64(ts), v_cvt_f64(all));
        addHalf(2, v_cvt_f64_high(ts), v_cvt_f64_high(all));
#else
        for (int l = 0; l < BLOCK; ++l)
        {
            double value = values[l];
            for (int power = 0; power < 3; ++power, value *= t[l])
                sums_[power][l] += value;
        }
#endif
    }
    double sum(int power) const
    {
        const double* parts = sums_[power];
        return (parts[0] + parts[1]) + (parts[2] + parts[3]);
    }

private:
#if LINESPACE_SIMD128_64F
    void addHalf(int l, const v_float64x2& t, v_float64x2 value)
    {
        for (int power = 0; power < 3; ++power, value = v_mul(value, t))
            v_store(sums_[power] + l, v_add(v_load(sums_[power] + l), value));
    }
#endif
    double sums_[3][BLOCK];
};

/** The gradients around a line, and how they pull at it. Tap by tap for a block of columns, so that
the inner loop of a sum is over columns and has no branch. */
class Profile
{
public:
    Profile(const Columns& columns, const EdgeSigns& signs, const NormalGradients& gradients)
        : columns_(columns), middle_(0.5 * (columns.length - 1)), step_((float)columns.minor),
          taps_(cvFloor(2 * (REACH + MAX_OFFSET) / std::abs(columns.minor))), own_(0)
    {
        std::vector<int> firstTaps;
        size_t nextOwn = 0;
        for (int i = signs.range().start; i < signs.range().end; ++i)
        {
            if (signs.at(i) == 0)
                continue;
            const bool isOwn = nextOwn < signs.own().size() && signs.own()[nextOwn] == i;
            nextOwn += isOwn;
            // Not so where a window would be cut off by the border of the image, and pull to one
            // side.
            const int first = cvCeil(columns_.centre(i) - 0.5 * taps_);
            if (first < 0 || first + taps_ > columns_.limit)
                continue;
            index_.push_back(i);
            firstTaps.push_back(first);
            own_ += isOwn;
        }
        const size_t blocks = (index_.size() + BLOCK - 1) / BLOCK, n = blocks * BLOCK;
        gradient_.resize(n * taps_);
        position_.resize(n);
        first_.resize(n);
        moment_.resize(n);
        change_.resize(n);
        for (size_t j = 0; j < index_.size(); ++j)
        {
            const int i = index_[j], first = firstTaps[j];
            position_[j] = (float)(i - middle_);
            first_[j] = (float)columns.distance(i, first);
            // So the largest one at an edge pixel becomes 1 but for rounding, whatever the unit is.
            const double scale = signs.at(i) / signs.largest();
            gradients.read(i, first, taps_, scale, MOST_GRADIENT,
                           &gradient_[j / BLOCK * BLOCK * taps_ + j % BLOCK], BLOCK);
        }
    }

    //! Columns that have a sign of their own.
    int ownColumns() const { return own_; }
    double middle() const { return middle_; }
    //! Of the first column, from the middle of the image.
    double firstPosition() const { return position_[0]; }

    //! Moves the line to where it is pulled to neither side, if there is such a place.
    bool fit(Offset& offset, std::vector<ColumnScore>& scores)
    {
        const double end = 0.5 * columns_.length;
        for (int i = 0; i < MAX_STEPS; ++i)
        {
            Normal weights, changes;
            sumUp(offset, weights, changes);
            // Newton's step where the sums are as steep as near their zero, else that of the
            // weighted mean.
            const Normal& system =
                changes.s > weights.s / 4 && changes.stt > weights.stt / 4 && changes.isDefinite()
                    ? changes
                    : weights;
            if (!system.isDefinite())
                return false;
            Offset step;
            system.solve(step);
            offset.a += step.a;
            offset.b += step.b;
            if (std::abs(step.a) + std::abs(step.b) * end < STILL)
            {
                scoresAfter(step, scores);
                // Gradients that are as large everywhere tell no position.
                return changes.s > weights.s / 16 && changes.stt > weights.stt / 16;
            }
            if (std::abs(offset.a) + std::abs(offset.b) * end > MAX_OFFSET)
                return false;
        }
        return false;
    }

private:
    //! Weighted least squares of distances over columns.
    struct Normal
    {
        double s, st, stt, d, dt;
        double determinant() const { return s * stt - st * st; }
        bool isDefinite() const { return s > 0 && determinant() > 1e-9 * s * stt; }
        void solve(Offset& offset) const
        {
            offset.a = (d * stt - dt * st) / determinant();
            offset.b = (dt * s - d * st) / determinant();
        }
    };

    /** Sums over each column's pixels: weights, which are the gradient times
    (1 - (distance / REACH)^2)^2, weighted distances, and how fast these change; and what they sum
    up to. */
    void sumUp(const Offset& offset, Normal& weights, Normal& changes)
    {
        BlockSums w, c, m;
        for (size_t j = 0; j < position_.size(); j += BLOCK)
        {
            float weight[BLOCK];
            sumBlock(j, (float)offset.a, (float)offset.b, weight, &moment_[j], &change_[j]);
            w.add(&position_[j], weight);
            c.add(&position_[j], &change_[j]);
            m.add(&position_[j], &moment_[j]);
        }
        const double d = m.sum(0), dt = m.sum(1);
        const Normal byWeight = {w.sum(0), w.sum(1), w.sum(2), d, dt},
                     byChange = {c.sum(0), c.sum(1), c.sum(2), d, dt};
        weights = byWeight;
        changes = byChange;
    }

    void sumBlock(size_t j, float a, float b, float* weight, float* moment, float* change) const
    {
        const float unit = 1.f / (REACH * REACH);
        const float* gradients = &gradient_[j * taps_];
#if LINESPACE_SIMD128
        const v_float32x4 zero = v_setzero_f32(), one = v_setall_f32(1), four = v_setall_f32(4),
                          units = v_setall_f32(unit), step = v_setall_f32(step_);
        const v_float32x4 rise = v_mul(v_setall_f32(b), v_load(&position_[j])),
                          first = v_sub(v_load(&first_[j]), v_add(v_setall_f32(a), rise));
        v_float32x4 tap = zero, weights = zero, moments = zero, changes = zero;
        for (int k = 0; k < taps_; ++k, gradients += BLOCK, tap = v_add(tap, one))
        {
            const v_float32x4 distance = v_add(first, v_mul(tap, step)),
                              u = v_mul(v_mul(distance, distance), units),
                              rest = v_max(v_sub(one, u), zero),
                              slope = v_mul(v_load(gradients), rest), weighted = v_mul(slope, rest);
            weights = v_add(weights, weighted);
            moments = v_add(moments, v_mul(weighted, distance));
            changes = v_add(changes, v_mul(slope, v_sub(rest, v_mul(four, u))));
        }
        v_store(weight, weights);
        v_store(moment, moments);
        v_store(change, changes);
#else
        for (int l = 0; l < BLOCK; ++l)
        {
            const float first = first_[j + l] - (a + b * position_[j + l]);
            weight[l] = moment[l] = change[l] = 0;
            for (int k = 0; k < taps_; ++k)
            {
                const float distance = first + k * step_, u = distance * distance * unit,
                            rest = std::max(1 - u, 0.f), slope = gradients[k * BLOCK + l] * rest;
                weight[l] += slope * rest;
                moment[l] += slope * rest * distance;
                change[l] += slope * (rest - 4 * u);
            }
        }
#endif
    }

    //! What is left of the sums after a small step, to first order; from the first column on.
    void scoresAfter(const Offset& step, std::vector<ColumnScore>& scores) const
    {
        const ColumnScore nothing = {0, 0};
        scores.assign(index_.back() - index_[0] + 1, nothing);
        for (size_t j = 0; j < index_.size(); ++j)
        {
            const double moved = step.a + step.b * position_[j];
            const ColumnScore score = {moment_[j] - change_[j] * moved, change_[j]};
            scores[index_[j] - index_[0]] = score;
        }
    }

    const Columns& columns_;
    double middle_;
    float step_; // from tap to tap, pixels along the normal
    int taps_, own_;
    std::vector<int> index_; // of the columns, along the major axis
    // In blocks of columns, the last one filled up with gradients of 0.
    std::vector<float> gradient_; // by block, tap and column; 0 where not of the edge's sign
    std::vector<float> position_; // of the columns, from the middle of the image
    std::vector<float> first_;    // distances of the first taps from the line
    std::vector<float> moment_, change_;
};

} // namespace

bool fitGradients(const EdgeMap& edges, const EdgePlanes& planes, int bin, const FittedLine& line,
                  FittedLine& fitted)
{
    const Columns columns(edges.votes.size(), line.line);
    const NormalGradients gradients(edges.dx, edges.dy, columns, line.line);
    const EdgeSigns signs(columns, Support(planes, bin, columns.xMajor), gradients);
    Profile profile(columns, signs, gradients);
    Offset offset = {0, 0};
    std::vector<ColumnScore> scores;
    if (2 * profile.ownColumns() < signs.supporting() || !profile.fit(offset, scores))
        return false;
    fitted.line = moved(columns, profile.middle(), line.line, offset);
    OffsetCovariance covariance;
    fitted.covariance = offsetCovariance(profile.firstPosition(), scores, covariance)
                            ? polarCovariance(columns, profile.middle(), fitted.line, covariance)
                            : line.covariance;
    return true;
}

} // namespace linespace
} // namespace cv
