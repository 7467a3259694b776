// Spreads independent work over the machine's cores.
#pragma once

#include <cstddef>
#include <functional>

namespace harness {

/// Calls `work(i)` for each i below `count`, in any order and from as many threads as the machine has cores; only from
/// this thread if no thread can be started. Returns when all is done. Rethrows an exception of a call; some calls are
/// then skipped.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace harness
