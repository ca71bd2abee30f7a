#pragma once
// Loops over index ranges on a fixed number of threads. A loop body must write only to its own indices;
// results then do not depend on the number of threads.

#include <cstddef>
#include <functional>

namespace ashlar::core {

/// Threads used by parallel loops (1 until it is set).
int thread_count();
void set_thread_count(int threads);

/// Calls body(begin, end) over disjoint ranges that cover [0, count). The first exception is rethrown.
/// Ranges hold at least `grain` indices, so small loops stay on the calling thread.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace ashlar::core
