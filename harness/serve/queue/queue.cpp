#include "harness/serve/queue/queue.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/machine/errors.h"
#include "harness/machine/say.h"
#include "harness/serve/queue/result_address.h"

namespace harness::serve {
namespace {

/// The server forgets further lost programs: with so many, the disk has been full for hours.
constexpr std::size_t most_lost = 1'000;

}  // namespace

Queue::Queue(KeptPrograms& kept_programs, std::size_t longest_queue)
    : kept_programs_(kept_programs), longest_queue_(longest_queue), suspects_(kept_programs.suspects()) {
    for (std::string& key : kept_programs.waiting()) waiting_.push_back(std::move(key));
}

std::optional<Refusal> Queue::refusal() const {
    const std::lock_guard guard(mutex_);
    if (waiting_.size() >= longest_queue_) return Refusal::full;
    return {};
}

std::variant<std::string, Refusal> Queue::accept(const std::string& source, const std::string& file) {
    if (const auto why = refusal()) return *why;
    const std::string address = new_result_address();
    const std::string key = key_of(address);
    try {
        kept_programs_.add(key, source, file);
    } catch (const HarnessError& error) {
        complain(error);
        return Refusal::no_room_on_disk;
    }
    const std::lock_guard guard(mutex_);
    waiting_.push_back(key);
    grew_.notify_one();
    return address;
}

Standing Queue::standing(const std::string& result_address) const {
    const std::string key = key_of(result_address);
    {
        const std::lock_guard guard(mutex_);
        const auto place = std::find(waiting_.begin(), waiting_.end(), key);
        if (place != waiting_.end()) {
            const std::size_t position = static_cast<std::size_t>(place - waiting_.begin()) + 1;
            return Waiting{position, waiting_.size(), last_took_};
        }
        if (at_work_.contains(key)) return BeingGraded{last_took_};
        if (lost_.contains(key)) return Lost{};
    }
    const auto result = kept_programs_.points(key);
    if (!result) return Unknown{};
    return Done{result->points, result->max_points};
}

std::optional<std::string> Queue::page(const std::string& result_address) const {
    auto result = kept_programs_.result(key_of(result_address));
    if (!result) return {};
    return std::move(result->page);
}

std::optional<Task> Queue::next() {
    for (;;) {
        Task task;
        {
            std::unique_lock lock(mutex_);
            grew_.wait(lock, [&] { return left_ || !waiting_.empty(); });
            if (left_) return {};
            task.key = std::move(waiting_.front());
            waiting_.pop_front();
            at_work_.insert(task.key);
            task.number = ++begun_;
            task.begun = std::chrono::steady_clock::now();
        }
        try {
            Program program = kept_programs_.begin(task.key);
            task.source = std::move(program.source);
            task.file = std::move(program.file);
            task.crashes = program.crashes;
            return task;
        } catch (const HarnessError& error) {
            complain(error);
            lose(task.key);
        }
    }
}

void Queue::lose(const std::string& key) {
    const std::lock_guard guard(mutex_);
    at_work_.erase(key);
    if (lost_.size() < most_lost) lost_.insert(key);
}

void Queue::finish(const Task& task, const Result& result) {
    try {
        kept_programs_.finish(task.key, result);
    } catch (const HarnessError& error) {
        complain(error);
        lose(task.key);
        return;
    }
    const std::lock_guard guard(mutex_);
    at_work_.erase(task.key);
    last_took_ = std::chrono::steady_clock::now() - task.begun;
}

std::size_t Queue::unfinished() const {
    const std::lock_guard guard(mutex_);
    return waiting_.size() + at_work_.size();
}

std::size_t Queue::leave() {
    const std::lock_guard guard(mutex_);
    left_ = true;
    grew_.notify_all();
    for (const std::string& key : at_work_) kept_programs_.give_back(key);
    return waiting_.size() + at_work_.size();
}

std::size_t Queue::queue_length() const {
    const std::lock_guard guard(mutex_);
    return waiting_.size();
}

}  // namespace harness::serve
