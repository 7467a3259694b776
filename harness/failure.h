// The machine's failure: fork fails, no compiler, the disk is full, no status line. The submission at hand is then
// "not graded" and the others go on. A student's failure is data, never an exception; our own mistakes are
// std::logic_error.
#pragma once

#include <stdexcept>

namespace harness {

/// what() is a complete sentence for the instructor: what failed, on which path, and the way out.
class HarnessError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace harness
