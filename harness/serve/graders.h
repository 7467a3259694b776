// The threads that grade what waits at the desk.
#pragma once

#include <future>
#include <thread>
#include <vector>

#include "harness/grade.h"
#include "harness/serve/desk.h"
#include "harness/serve/pages.h"

namespace harness::serve {

class Graders {
  public:
    /// As many at a time as `jobs` says. Each tells on stderr how many programs it has checked, how they ended and how
    /// long it took, and nothing that leads to a student. All arguments must outlive this.
    Graders(Desk& desk, Spool& spool, const About& about, const Workshop& workshop,
            const std::shared_future<Marking>& marking, int jobs);
    /// Waits until the desk has nothing more to grade, which ends only when it is closed or left.
    ~Graders();
    Graders(const Graders&) = delete;
    Graders& operator=(const Graders&) = delete;

  private:
    void work();
    Result grade_one(const Task& task, std::string& outcome) const;
    void tidy(const std::stop_token& stop);

    Desk& desk_;
    Spool& spool_;
    const About& about_;
    const Workshop& workshop_;
    const std::shared_future<Marking>& marking_;
    std::vector<std::jthread> threads_;
    std::jthread tidier_;
};

/// The result of a program that brought raygrade down, each time it was tried.
Result given_up(const About& about);

}  // namespace harness::serve
