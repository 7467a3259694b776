// Programs that were at work when raygrade crashed: one of them may be the reason, the others are not.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "harness/serve/queue/queue.h"

namespace harness::serve {

/// The result of `work`, which is done in a process of its own; empty if that process crashes or takes too long. Call
/// it while there are no other threads. Throws HarnessError if there can be no process.
std::optional<Result> in_own_process(const std::function<Result()>& work, std::chrono::seconds longest);

/// Grades the queue's suspects one after another, each in a process of its own, so that one that crashes it is known. A
/// program that does so twice gets `given_up`, all others get their result. Call it before any grader starts.
void try_suspects(Queue& queue, const std::function<Result(const Task&)>& grade, const Result& given_up);

}  // namespace harness::serve
