// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "caches.hpp"
#include "limits.hpp"
#include "stage_work.hpp"
#include "turns.hpp"

namespace benchmark {

namespace {

std::vector<int> threadCounts(const Settings& settings)
{
    return settings.threads > 1 ? std::vector<int>{1, settings.threads} : std::vector<int>{1};
}

void measureLimits(const Settings& settings)
{
    CsvFile file(settings.output + "/limits.csv", "threads,place,capacity,what,bytes,per_second");
    const double milliseconds = settings.quick ? 2 : 40;
    struct Place
    {
        std::string name;
        std::size_t capacity; //!< of all threads together; 0: memory
        std::size_t bytes;    //!< that are moved through
    };
    for (const int threads : threadCounts(settings))
    {
        std::vector<Place> places;
        for (const Cache& cache : caches())
        {
            const std::size_t capacity = cache.isShared ? cache.bytes : cache.bytes * threads;
            places.push_back({cache.name, capacity, capacity / 2});
        }
        // Four times the last cache; but half a gigabyte shows memory on any machine's share of one.
        const std::size_t largest = std::size_t(1) << (settings.quick ? 26 : 29);
        places.push_back({"memory", 0, std::min(4 * places.back().capacity, largest)});
        for (const Place& place : places)
            for (const auto& motion :
                 {std::make_pair(Motion::READ, "read"), std::make_pair(Motion::COPY, "copy"),
                  std::make_pair(Motion::ADD, "add")})
                file.row(threads, place.name, place.capacity, motion.second, place.bytes,
                         bytesPerSecond(motion.first, place.bytes, threads, milliseconds));
        file.row(threads, "registers", 0, "adds", 0, addsPerSecond(threads, milliseconds));
    }
    file.close();
}

} // namespace

void timeStages(const Settings& settings, Recorder& recorder)
{
    measureLimits(settings);
    CsvFile file(settings.output + "/stage-work.csv",
                 "width,height,stage,bytes_read,bytes_written,bytes_loaded,bytes_stored,adds,"
                 "bytes_per_vote");
    for (const cv::Size size : photographSizes(settings))
    {
        for (const StageWork& work : stageWork(size, 8))
            file.row(size.width, size.height, work.stage, work.bytesRead, work.bytesWritten,
                     work.bytesLoaded, work.bytesStored, work.adds, work.bytesPerVote);
        for (const std::string& name : photographNames(settings))
        {
            const Input input = photograph(settings.data, name, size);
            const std::vector<Call> one = detections(input, {Kind::DETECT, Kind::UNPRUNED});
            std::vector<Call> calls;
            for (const int threads : threadCounts(settings))
                for (Call call : one)
                {
                    call.threads = threads;
                    calls.push_back(call);
                }
            timeInTurn("stages", input, calls, settings, recorder);
        }
    }
    file.close();
}

} // namespace benchmark
