// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "edge_profile.hpp"

namespace cv {
namespace linespace {

namespace {

const int REACH = 3;            // pixels on either side of the line that weigh
const int MAX_GAP = 8;          // columns
const int SUPPORT_DISTANCE = 1; // pixels from the line to the edge pixel that gives the sign
const int MOST_MOVED = 1;       // pixels at the ends
const int FRACTION_BITS = 10;   // distances are integers in units of 2^-10 pixels
const int MAX_TAPS = 13;        // pixels of a column within REACH + MOST_MOVED, at 45 degrees
const int MAX_ITERATIONS = 20;
const double STILL = 1e-3; // pixels; a step that is smaller at both ends is the last

//! The pixels of one column around the line.
struct ProfileColumn
{
    int index;                //!< along the major axis
    int distance;             //!< of the first pixel from the line, signed
    short gradient[MAX_TAPS]; //!< along the normal; only those of the edge's sign, others 0
};

//! Sums over a column's pixels: weights, weighted distances, and how fast these change.
struct ColumnSums
{
    int64 weight, moment, change;
};

class Profile
{
public:
    Profile(const EdgeMap& edges, const Mat& gradients, ushort bit, const Line& line)
        : columns_(edges.votes.size(), line), support_(edges, bit), gradients_(gradients),
          cosine_(cvRound(std::cos(line.theta) * (1 << 14))),
          sine_(cvRound(std::sin(line.theta) * (1 << 14))), middle_(0.5 * (columns_.length - 1)),
          step_(toFixed(columns_.minor)),
          taps_(
              std::min<int>(MAX_TAPS, cvFloor(2 * (REACH + MOST_MOVED) / std::abs(columns_.minor))))
    {
        std::vector<schar> signs(columns_.length);
        for (int i = 0; i < columns_.length; ++i)
            signs[i] = signAt(i);
        closeGaps(signs);
        for (int i = 0; i < columns_.length; ++i)
            if (signs[i] != 0)
                addColumn(i, signs[i]);
    }

    bool fit(Offset& offset) const
    {
        const double end = 0.5 * columns_.length;
        for (int iteration = 0; iteration < MAX_ITERATIONS; ++iteration)
        {
            Normal weights, changes;
            for (size_t i = 0; i < profile_.size(); ++i)
            {
                const double t = profile_[i].index - middle_;
                const ColumnSums sums = sumsOf(profile_[i], offset);
                weights.add(t, (double)sums.weight, (double)sums.moment);
                changes.add(t, (double)sums.change, (double)sums.moment);
            }
            // Newton's step where the sums are as steep as near their zero, else that of the
            // weighted mean.
            Offset step;
            const Normal& system =
                changes.s > weights.s / 4 && changes.stt > weights.stt / 4 && changes.isDefinite()
                    ? changes
                    : weights;
            if (!system.isDefinite())
                return false;
            system.solve(step);
            offset.a += step.a / (1 << FRACTION_BITS);
            offset.b += step.b / (1 << FRACTION_BITS);
            const double atEnds = std::abs(step.a) + std::abs(step.b) * end;
            if (atEnds < STILL * (1 << FRACTION_BITS))
                // Gradients that are as large everywhere tell no position.
                return changes.s > weights.s / 16 && changes.stt > weights.stt / 16;
            if (std::abs(offset.a) + std::abs(offset.b) * end > MOST_MOVED)
                return false;
        }
        return false;
    }

    bool covariance(const Offset& offset, OffsetCovariance& result) const
    {
        std::vector<ColumnScore> scores(profile_.size());
        for (size_t i = 0; i < profile_.size(); ++i)
        {
            const ColumnSums sums = sumsOf(profile_[i], offset);
            scores[i].t = profile_[i].index - middle_;
            scores[i].score = (double)sums.moment / (1 << FRACTION_BITS);
            scores[i].sensitivity = (double)sums.change;
        }
        return offsetCovariance(scores, result);
    }

    const Columns& columns() const { return columns_; }
    double middle() const { return middle_; }

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

    static int toFixed(double pixels) { return cvRound(pixels * (1 << FRACTION_BITS)); }

    int gradientAt(int i, int k) const
    {
        const Point pixel = columns_.pixel(i, k);
        const Vec2s g = gradients_.ptr<Vec2s>(pixel.y)[pixel.x];
        return (g[0] * cosine_ + g[1] * sine_) >> 14;
    }

    //! The sign of the gradient at the supporting pixel nearest to the line; 0 without one.
    schar signAt(int i) const
    {
        const double centre = columns_.centre(i),
                     reach = SUPPORT_DISTANCE / std::abs(columns_.minor);
        // Written such that what is not in the image at all does not overflow an int.
        if (!(centre > -1 && centre < columns_.limit))
            return 0;
        int nearest = -1;
        for (int k = std::max(0, cvCeil(centre - reach)),
                 last = std::min(columns_.limit - 1, cvFloor(centre + reach));
             k <= last; ++k)
            if (support_.has(columns_.pixel(i, k)) &&
                (nearest < 0 || std::abs(k - centre) < std::abs(nearest - centre)))
                nearest = k;
        const int gradient = nearest < 0 ? 0 : gradientAt(i, nearest);
        return gradient > 0 ? 1 : gradient < 0 ? -1 : 0;
    }

    /** An edge detector leaves out columns by chance, or puts noise in the place of the edge: a sign
    between two of the other one is dropped, and columns between two of one sign take it, if these are at
    most MAX_GAP apart. */
    static void closeGaps(std::vector<schar>& signs)
    {
        std::vector<int> supported;
        for (int i = 0; i < (int)signs.size(); ++i)
            if (signs[i] != 0)
                supported.push_back(i);
        std::vector<int> kept;
        for (size_t i = 0; i < supported.size(); ++i)
        {
            const bool inside =
                i > 0 && i + 1 < supported.size() && supported[i + 1] - supported[i - 1] <= MAX_GAP;
            if (!inside || signs[supported[i]] == signs[supported[i - 1]] ||
                signs[supported[i]] == signs[supported[i + 1]])
                kept.push_back(supported[i]);
        }
        for (size_t i = 1; i < kept.size(); ++i)
            if (kept[i] - kept[i - 1] <= MAX_GAP && signs[kept[i]] == signs[kept[i - 1]])
                std::fill(signs.begin() + kept[i - 1], signs.begin() + kept[i], signs[kept[i]]);
    }

    void addColumn(int i, int sign)
    {
        const int first = cvCeil(columns_.centre(i) - 0.5 * taps_);
        if (first < 0 || first + taps_ > columns_.limit)
            return;
        ProfileColumn column;
        column.index = i;
        column.distance = toFixed(columns_.distance(i, first));
        for (int k = 0; k < taps_; ++k)
            column.gradient[k] = (short)std::max(0, sign * gradientAt(i, first + k));
        profile_.push_back(column);
    }

    //! Weights are the gradient times (1 - (distance / REACH)^2)^2.
    ColumnSums sumsOf(const ProfileColumn& column, const Offset& offset) const
    {
        const int reachSquared = REACH * REACH << 2 * FRACTION_BITS, windowBits = 10;
        int distance = column.distance - toFixed(offset.a + offset.b * (column.index - middle_));
        ColumnSums sums = {0, 0, 0};
        for (int k = 0; k < taps_; ++k, distance += step_)
        {
            // (distance / REACH)^2 with windowBits bits, and 1 less it.
            const int square = distance * distance;
            if (square >= reachSquared)
                continue;
            const int u = square / (reachSquared >> windowBits), rest = (1 << windowBits) - u;
            const int64 slope = (int64)column.gradient[k] * rest;
            sums.weight += slope * rest;
            sums.moment += slope * rest * distance;
            sums.change += slope * (rest - 4 * u);
        }
        return sums;
    }

    Columns columns_;
    Support support_;
    const Mat& gradients_;
    int cosine_, sine_;
    double middle_;
    int step_, taps_;
    std::vector<ProfileColumn> profile_;
};

} // namespace

Mat profileGradients(const Mat& dx, const Mat& dy)
{
    const int bits = 12;
    double low[2], high[2];
    minMaxLoc(dx, &low[0], &high[0]);
    minMaxLoc(dy, &low[1], &high[1]);
    const double largest = std::max(std::max(-low[0], high[0]), std::max(-low[1], high[1]));
    Mat both[2], result;
    if (dx.type() == CV_16SC1)
    {
        int shift = 0;
        while (largest > (double)((1 << bits) << shift))
            ++shift;
        if (shift == 0)
        {
            both[0] = dx;
            both[1] = dy;
        }
        else
            for (int i = 0; i < 2; ++i)
                (i == 0 ? dx : dy).convertTo(both[i], CV_16S, std::ldexp(1., -shift));
    }
    else
    {
        int exponent = 0;
        std::frexp(largest, &exponent);
        for (int i = 0; i < 2; ++i)
            (i == 0 ? dx : dy).convertTo(both[i], CV_16S, std::ldexp(1., bits - exponent));
    }
    merge(both, 2, result);
    return result;
}

bool fitGradients(const EdgeMap& edges, const Mat& gradients, ushort bit, const Line& line,
                  FittedLine& fitted)
{
    const Profile profile(edges, gradients, bit, line);
    Offset offset = {0, 0};
    OffsetCovariance covariance;
    if (!profile.fit(offset) || !profile.covariance(offset, covariance))
        return false;
    fitted.line = moved(profile.columns(), profile.middle(), line, offset);
    fitted.covariance =
        polarCovariance(profile.columns(), profile.middle(), fitted.line, covariance);
    return true;
}

} // namespace linespace
} // namespace cv
