// A known right program. If it fails, the machine is at fault.
#pragma once

#include <memory>
#include <mutex>

#include "harness/build/build.h"
#include "harness/sandbox/host/sandbox.h"
#include "harness/sandbox/host/scratch.h"

namespace harness {

/// It is compiled when it is first needed. Any number of threads may use it.
class KnownProgram {
  public:
    /// The sandbox must outlive it.
    KnownProgram(BuildSettings settings, const Sandbox& sandbox);

    /// Runs it where students' programs run. Throws HarnessError unless it prints what it should.
    void require_that_it_runs(const Limits& limits) const;

  private:
    BuildSettings settings_;
    const Sandbox& sandbox_;
    mutable std::mutex one_at_a_time_;
    mutable std::unique_ptr<Scratch> scratch_;  ///< null until it is compiled
    mutable Build build_;
};

}  // namespace harness
