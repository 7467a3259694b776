// Makes system calls of a program and of all its descendants fail, by a seccomp filter that asks another process.
#pragma once

#include <string>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {

/// Which calls fail, and how. Calls that read from or write to a pipe are not counted and never fail.
struct KernelError {
    std::string call;         ///< the system call's name: "openat"
    int error = 0;            ///< ENOSPC
    long first = 1;           ///< of all such calls by any process, from 1: the first that fails
    bool is_lasting = false;  ///< all later ones fail too

    std::string text() const;  ///< "openat fails with No space left on device from call 12 on"
};

/// The calls counted while a program ran; shared with the process that counts them.
class CountedCalls {
  public:
    CountedCalls();
    ~CountedCalls();
    CountedCalls(const CountedCalls&) = delete;
    CountedCalls& operator=(const CountedCalls&) = delete;

    /// The number of calls of that name by the program and its descendants.
    long of(const std::string& call) const;

    /// To be given to raygrade(): counts these calls.
    Preparation count(const std::vector<std::string>& calls, const Preparation& more = {});
    /// To be given to raygrade(): counts the calls of that name, and makes some of them fail.
    Preparation fail(const KernelError& error, const Preparation& more = {});

  private:
    struct Shared;
    Preparation answer(const std::vector<std::string>& calls, const KernelError& error, const Preparation& more);
    Shared* shared_;
};

}  // namespace scenario
