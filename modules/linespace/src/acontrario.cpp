// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "acontrario.hpp"

#include <cmath>

namespace cv {
namespace linespace {

namespace {

//! P(Binomial(n, p) >= k) for 0 < p < 1, k > n p: the terms fall at least geometrically.
double binomialTail(int n, int k, double p, const std::vector<double>& logFactorial)
{
    const double odds = p / (1 - p);
    double term = std::exp(logFactorial[n] - logFactorial[k] - logFactorial[n - k] +
                           k * std::log(p) + (n - k) * std::log1p(-p));
    double sum = 0;
    for (; k <= n && term > sum * 1e-17; ++k)
    {
        sum += term;
        term *= odds * (n - k) / (k + 1);
    }
    return sum;
}

} // namespace

std::vector<int> significantVotes(int maxLength, double density, double tests, double falseAlarms)
{
    std::vector<double> logFactorial(maxLength + 1, 0.);
    for (int i = 2; i <= maxLength; ++i)
        logFactorial[i] = logFactorial[i - 1] + std::log((double)i);

    // Expected false alarms are compared, not probabilities, as the product may exceed any double's
    // range only downwards.
    std::vector<int> votes(maxLength + 1);
    int k = tests < falseAlarms ? 0 : 1; // k = 0 votes have probability 1
    for (int n = 0; n <= maxLength; ++n)
    {
        // One more pixel never lowers k, and raises it by one at most.
        for (; k <= n; ++k)
        {
            const double tail = k == 0         ? 1
                                : density <= 0 ? 0
                                : density >= 1 || k <= n * density
                                    ? 1
                                    : binomialTail(n, k, density, logFactorial);
            if (tests * tail < falseAlarms)
                break;
        }
        votes[n] = k;
    }
    return votes;
}

} // namespace linespace
} // namespace cv
