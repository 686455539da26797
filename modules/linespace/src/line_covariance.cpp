// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "line_covariance.hpp"

namespace cv {
namespace linespace {

Vec3f Covariance::deviations() const
{
    // Rounding may leave a variance of nothing a little below 0.
    const double rhoDeviation = std::sqrt(std::max(rho, 0.)),
                 thetaDeviation = std::sqrt(std::max(theta, 0.));
    const double product = rhoDeviation * thetaDeviation;
    const double correlation = product > 0 ? std::min(std::max(rhoTheta / product, -1.), 1.) : 0;
    return Vec3f((float)rhoDeviation, (float)thetaDeviation, (float)correlation);
}

namespace {

//! tau = start + i * step: where column i is along the line, from the foot of its normal.
void alongLine(const Columns& columns, const Line& line, double& start, double& step)
{
    const double cosine = std::cos(line.theta), sine = std::sin(line.theta);
    // The line's points are rho (cosine, sine) + tau (-sine, cosine).
    step = columns.xMajor ? -1 / sine : 1 / cosine;
    start = columns.xMajor ? line.rho * cosine / sine : -line.rho * sine / cosine;
}

} // namespace

Line moved(const Columns& columns, double middle, const Line& line, const Offset& offset)
{
    const double cosine = std::cos(line.theta), sine = std::sin(line.theta);
    double start, step;
    alongLine(columns, line, start, step);
    // The points at the middle column and one column further, moved along the normal.
    const double tau = start + middle * step, next = tau + step;
    const Point2d p((line.rho + offset.a) * cosine - tau * sine,
                    (line.rho + offset.a) * sine + tau * cosine),
        q((line.rho + offset.a + offset.b) * cosine - next * sine,
          (line.rho + offset.a + offset.b) * sine + next * cosine);
    Line result;
    result.theta = line.theta - std::atan(offset.b / step);
    result.rho =
        0.5 * ((p.x + q.x) * std::cos(result.theta) + (p.y + q.y) * std::sin(result.theta));
    return result;
}

Covariance polarCovariance(const Columns& columns, double middle, const Line& line,
                           const OffsetCovariance& covariance)
{
    double start, step;
    alongLine(columns, line, start, step);
    // A small turn moves the point at tau by -tau d(theta) + d(rho) = a + b t, and
    // tau = start + middle step + t step: d(theta) = -b / step, d(rho) = a + tau(middle) d(theta).
    const double tau = start + middle * step;
    const double theta = covariance.bb / (step * step), cross = -covariance.ab / step;
    Covariance result;
    result.theta = theta;
    result.rhoTheta = cross + tau * theta;
    result.rho = covariance.aa + 2 * tau * cross + tau * tau * theta;
    return result;
}

bool offsetCovariance(double first, const std::vector<ColumnScore>& columns,
                      OffsetCovariance& covariance)
{
    // Pairs of columns weigh 1 - lag / WINDOW, which is the share of the windows of that length
    // over either that are over both: so the variance of a sum is a sum over all windows.
    enum
    {
        WINDOW = 5
    };
    double s = 0, st = 0, stt = 0; // sensitivities
    double v = 0, vt = 0, vtt = 0; // variance of the sums of scores
    double scores[WINDOW] = {0}, moments[WINDOW] = {0}, inWindow = 0, momentInWindow = 0;
    const int count = (int)columns.size();
    for (int i = 0, slot = 0; i < count + WINDOW - 1; ++i, slot = slot + 1 < WINDOW ? slot + 1 : 0)
    {
        inWindow -= scores[slot];
        momentInWindow -= moments[slot];
        scores[slot] = moments[slot] = 0;
        if (i < count)
        {
            const ColumnScore& column = columns[i];
            const double t = first + i, weighted = column.sensitivity * t;
            s += column.sensitivity;
            st += weighted;
            stt += weighted * t;
            scores[slot] = column.score;
            moments[slot] = column.score * t;
        }
        inWindow += scores[slot];
        momentInWindow += moments[slot];
        v += inWindow * inWindow;
        vt += inWindow * momentInWindow;
        vtt += momentInWindow * momentInWindow;
    }
    v /= WINDOW;
    vt /= WINDOW;
    vtt /= WINDOW;
    const double determinant = s * stt - st * st;
    if (!(determinant > 1e-9 * s * stt) || !(s > 0))
        return false;
    // Inverse of the sensitivity, on both sides of the scores' covariance.
    const double p = stt / determinant, q = -st / determinant, r = s / determinant;
    covariance.aa = p * p * v + 2 * p * q * vt + q * q * vtt;
    covariance.ab = p * q * v + (p * r + q * q) * vt + q * r * vtt;
    covariance.bb = q * q * v + 2 * q * r * vt + r * r * vtt;
    return true;
}

} // namespace linespace
} // namespace cv
