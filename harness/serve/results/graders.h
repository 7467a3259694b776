// The threads that grade the programs in the queue.
#pragma once

#include <thread>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/run/runner.h"
#include "harness/serve/queue/queue.h"
#include "harness/serve/results/pages.h"

namespace harness::serve {

class Graders {
  public:
    /// First grades the queue's suspects, one at a time, so that only one of them can be the cause of another crash.
    /// Then starts `jobs` threads. For each program, they print its number, outcome, time and the queue length on
    /// stderr, and nothing that identifies a student. All arguments must outlive this object.
    Graders(Queue& queue, KeptPrograms& kept_programs, const About& about, const Runner& runner, const Marking& marking,
            int jobs);
    /// Waits until the queue hands out no more programs. Call Queue::leave first.
    ~Graders();
    Graders(const Graders&) = delete;
    Graders& operator=(const Graders&) = delete;

  private:
    void grade_next(const Task& task);
    void tidy(const std::stop_token& stop);

    Queue& queue_;
    KeptPrograms& kept_programs_;
    const About& about_;
    const Runner& runner_;
    const Marking& marking_;
    std::vector<std::jthread> threads_;
    std::jthread tidier_;
};

}  // namespace harness::serve
