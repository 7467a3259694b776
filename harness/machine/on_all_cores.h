// Spreads independent work over the machine's cores.
#pragma once

#include <cstddef>
#include <functional>

namespace harness {

/// Calls `work(i)` for each i below `count`, in any order and from as many threads as the machine has cores; from this
/// thread alone where it starts none. Returns when all is done. Throws what a call threw; then some are left out.
void on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace harness
