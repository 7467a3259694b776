// Failures of the machine and mistakes of the user. When the machine fails (fork fails, no compiler, the disk is full,
// no status line), the current submission is "not graded" and the others go on. A student's failure is data, never an
// exception. A mistake of raygrade's own is a std::logic_error.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

namespace harness {

/// what() is a complete sentence for the instructor: what failed, on which path, and how to fix it.
class HarnessError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A mistake in the command line: what() names the path and how to fix it.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Whether the machine refused memory or a thread.
inline bool is_for_want_of_memory(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
    const auto* of_system = dynamic_cast<const std::system_error*>(&error);
    return of_system != nullptr && (of_system->code() == std::errc::not_enough_memory ||
                                    of_system->code() == std::errc::resource_unavailable_try_again);
}

}  // namespace harness
