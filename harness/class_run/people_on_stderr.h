// Keeps stdout for programs.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

#include "harness/machine/errors.h"
#include "harness/machine/file_descriptor.h"

namespace harness {

/// If wanted, what is printed to stdout goes to stderr until the end.
class PeopleOnStderr {
  public:
    explicit PeopleOnStderr(bool wanted) : stdout_(wanted ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0) : -1) {
        if (!wanted) return;
        std::fflush(stdout);
        if (!stdout_ || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
            throw HarnessError("stdout can't be kept for the summary; is the number of open files limited?");
    }
    PeopleOnStderr(const PeopleOnStderr&) = delete;
    PeopleOnStderr& operator=(const PeopleOnStderr&) = delete;
    ~PeopleOnStderr() { end(); }

    void end() {
        if (!stdout_) return;
        std::fflush(stdout);
        dup2(stdout_.get(), STDOUT_FILENO);
        stdout_ = FileDescriptor();
    }

  private:
    FileDescriptor stdout_;
};

}  // namespace harness
