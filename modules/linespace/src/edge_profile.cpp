// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "edge_profile.hpp"

namespace cv {
namespace linespace {

namespace {

const int REACH = 3;            // pixels on either side of the line that weigh
const int MAX_GAP = 8;          // columns
const double MAX_OFFSET = 1;    // pixels at the ends; a fit farther away is of something else
const double MOST_GRADIENT = 2; // times the largest one at an edge pixel: no pixel weighs more
const int MAX_TAPS = 11;        // pixels of a column within REACH + MAX_OFFSET, at 45 degrees
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
    //! At pixels k, k + 1, ... of column i.
    void read(int i, int k, int count, double* components) const
    {
        isFloat_ ? readAs<float>(i, k, count, components) : readAs<short>(i, k, count, components);
    }
    double at(int i, int k) const
    {
        double component;
        read(i, k, 1, &component);
        return component;
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
    void readAs(int i, int k, int count, double* components) const
    {
        const uchar *x = dx_.at(i, k), *y = dy_.at(i, k);
        for (int j = 0; j < count; ++j, x += dx_.acrossStep, y += dy_.acrossStep)
            components[j] = *(const Value*)x * cosine_ + *(const Value*)y * sine_;
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

/** The gradients around a line, and how they pull at it. Tap by tap for all columns, so that the
inner loop of a sum is over columns and has no branch. */
class Profile
{
public:
    Profile(const Columns& columns, const EdgeSigns& signs, const NormalGradients& gradients)
        : columns_(columns), middle_(0.5 * (columns.length - 1)), step_((float)columns.minor),
          taps_(cvFloor(2 * (REACH + MAX_OFFSET) / std::abs(columns.minor))), own_(0)
    {
        CV_DbgAssert(taps_ <= MAX_TAPS);
        for (int i = signs.range().start; i < signs.range().end; ++i)
            if (signs.at(i) != 0 && isInside(i))
                index_.push_back(i);
        for (size_t j = 0; j < signs.own().size(); ++j)
            own_ += isInside(signs.own()[j]);
        const size_t n = index_.size();
        gradient_.resize(taps_ * n);
        position_.resize(n);
        first_.resize(n);
        distance_.resize(n);
        weight_.resize(n);
        moment_.resize(n);
        change_.resize(n);
        double components[MAX_TAPS];
        for (size_t j = 0; j < n; ++j)
        {
            const int i = index_[j], first = firstTap(i);
            position_[j] = (float)(i - middle_);
            first_[j] = (float)columns.distance(i, first);
            gradients.read(i, first, taps_, components);
            // So the largest one at an edge pixel becomes 1, whatever the unit is.
            const double scale = signs.at(i) / signs.largest();
            for (int k = 0; k < taps_; ++k)
                gradient_[k * n + j] =
                    (float)std::min(std::max(scale * components[k], 0.), MOST_GRADIENT);
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
            sumUp(offset);
            Normal weights, changes;
            for (size_t j = 0; j < index_.size(); ++j)
            {
                const double t = position_[j];
                weights.add(t, weight_[j], moment_[j]);
                changes.add(t, change_[j], moment_[j]);
            }
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
        double s = 0, st = 0, stt = 0, d = 0, dt = 0;
        void add(double t, double weight, double moment)
        {
            s += weight;
            st += weight * t;
            stt += weight * t * t;
            d += moment;
            dt += moment * t;
        }
        double determinant() const { return s * stt - st * st; }
        bool isDefinite() const { return s > 0 && determinant() > 1e-9 * s * stt; }
        void solve(Offset& offset) const
        {
            offset.a = (d * stt - dt * st) / determinant();
            offset.b = (dt * s - d * st) / determinant();
        }
    };

    int firstTap(int i) const { return cvCeil(columns_.centre(i) - 0.5 * taps_); }
    //! Not so where a window would be cut off by the border of the image, and pull to one side.
    bool isInside(int i) const
    {
        const int first = firstTap(i);
        return first >= 0 && first + taps_ <= columns_.limit;
    }

    /** The sums over each column's pixels: weights, which are the gradient times
    (1 - (distance / REACH)^2)^2, weighted distances, and how fast these change. */
    void sumUp(const Offset& offset)
    {
        const int n = (int)index_.size();
        const float a = (float)offset.a, b = (float)offset.b;
        float *const distances = distance_.data(), *const weights = weight_.data(),
                     *const moments = moment_.data(), *const changes = change_.data();
        for (int j = 0; j < n; ++j)
        {
            distances[j] = first_[j] - (a + b * position_[j]);
            weights[j] = moments[j] = changes[j] = 0;
        }
        for (int k = 0; k < taps_; ++k)
        {
            const float* const gradients = gradient_.data() + (size_t)k * n;
            const float shift = k * step_;
            for (int j = 0; j < n; ++j)
            {
                const float distance = distances[j] + shift;
                const float u = distance * distance * (1.f / (REACH * REACH));
                const float rest = std::max(1 - u, 0.f), slope = gradients[j] * rest;
                weights[j] += slope * rest;
                moments[j] += slope * rest * distance;
                changes[j] += slope * (rest - 4 * u);
            }
        }
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
    std::vector<int> index_;      // of the columns, along the major axis
    std::vector<float> gradient_; // by tap, then column; of the edge's sign, 0 where of the other
    std::vector<float> position_; // of the columns, from the middle of the image
    std::vector<float> first_;    // distances of the first taps from the line
    std::vector<float> distance_; // the same from the line moved by an offset
    std::vector<float> weight_, moment_, change_;
};

} // namespace

bool fitGradients(const EdgeMap& edges, const EdgePlanes& planes, ushort bit,
                  const FittedLine& line, FittedLine& fitted)
{
    const Columns columns(edges.votes.size(), line.line);
    const NormalGradients gradients(edges.dx, edges.dy, columns, line.line);
    const EdgeSigns signs(columns, Support(planes, bit, columns.xMajor), gradients);
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
