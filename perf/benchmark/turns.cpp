// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "turns.hpp"

#include "instruction_set.hpp"

#include <algorithm>
#include <cstdint>
#include <iostream>

namespace benchmark {

namespace {

//! Sets the number of threads; whether it was another one.
bool useThreads(int threads)
{
    if (cv::getNumThreads() == threads)
        return false;
    cv::setNumThreads(threads);
    return true;
}

} // namespace

int turnsFor(double milliseconds, const Settings& settings)
{
    const int least = milliseconds > 8 * slowCall ? 1 : milliseconds > slowCall ? 2 : 3;
    const double affordable = settings.budget / std::max(milliseconds, 1e-3);
    return std::clamp((int)std::min(affordable, 1e6), std::min(least, settings.turns),
                      settings.turns);
}

bool isDue(int turn, int own, int all)
{
    return (std::int64_t)(turn + 1) * own / all > (std::int64_t)turn * own / all;
}

void timeInTurn(const std::string& section, const Input& input, const std::vector<Call>& calls,
                const Settings& settings, Recorder& recorder)
{
    const auto run = [&](const Call& call, bool warm)
    {
        // After a change of their number, threads must be started before they are timed.
        if (useThreads(call.threads ? call.threads : settings.threads) && warm)
            call.run();
        return call.run();
    };
    const auto record = [&](const Call& call, int turn, const Outcome& outcome)
    {
        recorder.record({section, &input, call.threads ? call.threads : settings.threads,
                         call.isa.empty() ? instructionSet() : call.isa},
                        call.method, turn, outcome);
    };
    std::cerr << "  " << input.name << ", " << input.edges.cols << " x " << input.edges.rows
              << "\n";
    std::vector<int> turns;
    for (const Call& call : calls)
    {
        const Outcome first = run(call, false);
        turns.push_back(turnsFor(first.milliseconds, settings));
        if (first.milliseconds > slowCall)
        {
            record(call, 0, first);
            --turns.back();
        }
    }
    for (int turn = 0; turn < settings.turns; ++turn)
        for (std::size_t i = 0; i < calls.size(); ++i)
            if (isDue(turn, turns[i], settings.turns))
                record(calls[i], turn + 1, run(calls[i], true));
}

} // namespace benchmark
