// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// An installed OpenCV and its thread pool are not built with the thread sanitizer, which therefore
// does not see how the pool hands work over and reports races where there are none. Here
// cv::parallel_for_ gets a pool that is built with it: new threads for each loop, which take one
// stripe after the other.

#include "sanitizer_threads.hpp"

#include "test_precomp.hpp"

#ifdef __SANITIZE_THREAD__

#include <opencv2/core/parallel/parallel_backend.hpp>

#include <atomic>
#include <thread>

namespace opencv_test {
namespace {

thread_local int threadIndex = 0;

class SanitizerThreads : public cv::parallel::ParallelForAPI
{
public:
    void parallel_for(int tasks, FN_parallel_for_body_cb_t body, void* data) override
    {
        std::atomic<int> next(0);
        const auto work = [&](int index)
        {
            threadIndex = index;
            for (int task = next++; task < tasks; task = next++)
                body(task, task + 1, data);
        };
        std::vector<std::thread> threads;
        for (int i = 1; i < std::min(count, tasks); i++)
            threads.emplace_back(work, i);
        work(0);
        for (std::thread& thread : threads)
            thread.join();
    }
    int getThreadNum() const override { return threadIndex; }
    int getNumThreads() const override { return count; }
    int setNumThreads(int threads) override
    {
        const int before = count;
        count = threads > 0 ? threads : 4;
        return before;
    }
    const char* getName() const override { return "sanitizer threads"; }

private:
    int count = 4;
};

} // namespace

void useSanitizerThreads()
{
    cv::parallel::setParallelForBackend(std::make_shared<SanitizerThreads>());
}

} // namespace opencv_test

#else

void opencv_test::useSanitizerThreads()
{
}

#endif
