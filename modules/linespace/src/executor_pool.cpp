// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "executor_pool.hpp"

#include <mutex>

namespace cv {
namespace linespace {

namespace {

struct Pool
{
    std::mutex mutex;
    std::vector<Ptr<Executor>> executors; //!< that given last at the end
};

//! Never destroyed: at the end of the process OpenCV and the device's driver may be gone before.
Pool& pool()
{
    static Pool* const only = new Pool;
    return *only;
}

//! As many calls at the same time find one.
const size_t MOST_KEPT = 4;

} // namespace

Ptr<Executor> takeExecutor(int backend)
{
    Pool& kept = pool();
    const std::lock_guard<std::mutex> lock(kept.mutex);
    for (size_t i = kept.executors.size(); i-- > 0;)
        if (kept.executors[i]->backend() == backend && kept.executors[i]->isUsable())
        {
            const Ptr<Executor> found = kept.executors[i];
            kept.executors.erase(kept.executors.begin() + i);
            return found;
        }
    return Ptr<Executor>();
}

void giveExecutor(const Ptr<Executor>& executor)
{
    if (!executor->takesUMats())
        return;
    Ptr<Executor> oldest; // its buffers are freed without the lock
    Pool& kept = pool();
    const std::lock_guard<std::mutex> lock(kept.mutex);
    kept.executors.push_back(executor);
    if (kept.executors.size() > MOST_KEPT)
    {
        oldest = kept.executors.front();
        kept.executors.erase(kept.executors.begin());
    }
}

} // namespace linespace
} // namespace cv
