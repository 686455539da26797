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
    std::vector<PooledExecutor> executors; //!< that given last at the end
};

//! Never destroyed: at the end of the process OpenCV and the device's driver may be gone before.
Pool& pool()
{
    static Pool* const only = new Pool;
    return *only;
}

//! As many calls at the same time find one.
const size_t MOST_KEPT = 4;

//! Of a table, on the host or on a device.
const size_t MOST_KEPT_BYTES = 256 << 20;

bool isLarge(const VoteTable& table)
{
    return table.bytes() > MOST_KEPT_BYTES ||
           (table.memory && table.memory->bytes() > MOST_KEPT_BYTES);
}

//! That of a back end that was given last; without an executor if there is none.
PooledExecutor takeLast(int backend)
{
    PooledExecutor found = {Ptr<Executor>(), makePtr<VoteTables>()};
    Pool& kept = pool();
    const std::lock_guard<std::mutex> lock(kept.mutex);
    for (size_t i = kept.executors.size(); i-- > 0 && !found.executor;)
        if (kept.executors[i].executor->backend() == backend)
        {
            found = kept.executors[i];
            kept.executors.erase(kept.executors.begin() + i);
        }
    return found;
}

} // namespace

PooledExecutor takeExecutor(int backend)
{
    // Whether one is usable its driver tells, which is asked without the lock; those that are not,
    // in this thread's context, are for others.
    std::vector<PooledExecutor> others;
    PooledExecutor found = takeLast(backend);
    for (; found.executor && !found.executor->isUsable(); found = takeLast(backend))
        others.push_back(found);
    for (size_t i = others.size(); i-- > 0;)
        giveExecutor(others[i]);
    return found;
}

void giveExecutor(const PooledExecutor& pooled)
{
    if (!pooled.executor->isDevice())
        return;
    if (isLarge(pooled.tables->of(0)) || isLarge(pooled.tables->of(1)))
        pooled.tables->release();
    PooledExecutor oldest; // its buffers are freed without the lock
    Pool& kept = pool();
    const std::lock_guard<std::mutex> lock(kept.mutex);
    kept.executors.push_back(pooled);
    if (kept.executors.size() > MOST_KEPT)
    {
        oldest = kept.executors.front();
        kept.executors.erase(kept.executors.begin());
    }
}

} // namespace linespace
} // namespace cv
