// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Times of calls that are compared with each other.

#ifndef LINESPACE_BENCHMARK_TURNS_HPP
#define LINESPACE_BENCHMARK_TURNS_HPP

#include "recorder.hpp"
#include "settings.hpp"

namespace benchmark {

/** Calls the methods in turn, so that all meet the same states of the machine, and records every
call. A method gets as many of the turns as its budget allows, spread over all of them, but three; two
if a call takes more than a second, one if more than eight. The first call of a method only warms
caches and tells its time, but counts if it takes more than a second. */
void timeInTurn(const std::string& section, const Input& input, const std::vector<Call>& calls,
                const Settings& settings, Recorder& recorder);

//! How many turns a call of so many milliseconds gets.
int turnsFor(double milliseconds, const Settings& settings);

//! Whether a method that gets `own` of `all` turns has its turn in this one.
bool isDue(int turn, int own, int all);

//! Milliseconds from which on the first call counts.
const double slowCall = 1000;

} // namespace benchmark

#endif // LINESPACE_BENCHMARK_TURNS_HPP
