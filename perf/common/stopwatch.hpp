// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Times of calls that are compared with each other.

#ifndef LINESPACE_MEASURE_STOPWATCH_HPP
#define LINESPACE_MEASURE_STOPWATCH_HPP

#include <functional>
#include <vector>

namespace measure {

double millisecondsOf(const std::function<void()>& work);

//! Times of several functions, by function and run, called in turn so that all meet the same state
//! of the machine; the first call of each is not timed.
std::vector<std::vector<double>> timesInTurn(const std::vector<std::function<void()>>& functions,
                                             int runs);

double median(std::vector<double> values);

//! Medians of such times.
std::vector<double> medians(const std::vector<std::function<void()>>& functions, int runs);

} // namespace measure

#endif // LINESPACE_MEASURE_STOPWATCH_HPP
