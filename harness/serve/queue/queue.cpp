#include "harness/serve/desk.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/failure.h"
#include "harness/serve/result_address.h"

namespace harness::serve {
namespace {

/// More are forgotten: where so many could not be written, the disk has been full for hours.
constexpr std::size_t most_lost = 1'000;

}  // namespace

Desk::Desk(Spool& spool, std::size_t longest_queue) : spool_(spool), longest_queue_(longest_queue) {
    for (std::string& key : spool.waiting()) waiting_.push_back(std::move(key));
}

std::optional<Refusal> Desk::refusal() const {
    const std::lock_guard guard(mutex_);
    if (closed_) return Refusal::closed;
    if (waiting_.size() >= longest_queue_) return Refusal::full;
    return {};
}

std::variant<std::string, Refusal> Desk::accept(const std::string& source, const std::string& file) {
    if (const auto why = refusal()) return *why;
    const std::string address = new_result_address();
    const std::string key = key_of(address);
    try {
        spool_.add(key, source, file);
    } catch (const HarnessError& error) {
        fmt::print(stderr, "raygrade: {}\n", error.what());
        return Refusal::no_room_on_disk;
    }
    const std::lock_guard guard(mutex_);
    waiting_.push_back(key);
    grew_.notify_one();
    return address;
}

Standing Desk::standing(const std::string& result_address) const {
    const std::string key = key_of(result_address);
    {
        const std::lock_guard guard(mutex_);
        const auto place = std::find(waiting_.begin(), waiting_.end(), key);
        if (place != waiting_.end()) {
            return Waiting{static_cast<std::size_t>(place - waiting_.begin()) + 1, waiting_.size()};
        }
        if (at_work_.contains(key)) return BeingGraded{};
        if (lost_.contains(key)) return Lost{};
    }
    const auto result = spool_.points(key);
    if (!result) return Unknown{};
    return Done{result->points, result->max_points};
}

std::optional<std::string> Desk::page(const std::string& result_address) const {
    auto result = spool_.result(key_of(result_address));
    if (!result) return {};
    return std::move(result->page);
}

std::optional<Task> Desk::next() {
    for (;;) {
        Task task;
        {
            std::unique_lock lock(mutex_);
            grew_.wait(lock, [&] { return left_ || closed_ || !waiting_.empty(); });
            if (left_ || waiting_.empty()) return {};
            task.key = std::move(waiting_.front());
            waiting_.pop_front();
            at_work_.insert(task.key);
            task.number = ++begun_;
        }
        try {
            Program program = spool_.begin(task.key);
            task.source = std::move(program.source);
            task.file = std::move(program.file);
            return task;
        } catch (const HarnessError& error) {
            fmt::print(stderr, "raygrade: {}\n", error.what());
            lose(task.key);
        }
    }
}

void Desk::lose(const std::string& key) {
    const std::lock_guard guard(mutex_);
    at_work_.erase(key);
    if (lost_.size() < most_lost) lost_.insert(key);
}

void Desk::finish(const Task& task, const Result& result) {
    try {
        spool_.finish(task.key, result);
    } catch (const HarnessError& error) {
        fmt::print(stderr, "raygrade: {}\n", error.what());
        lose(task.key);
        return;
    }
    const std::lock_guard guard(mutex_);
    at_work_.erase(task.key);
}

void Desk::close() {
    const std::lock_guard guard(mutex_);
    closed_ = true;
    grew_.notify_all();
}

std::size_t Desk::unfinished() const {
    const std::lock_guard guard(mutex_);
    return waiting_.size() + at_work_.size();
}

std::size_t Desk::leave() {
    const std::lock_guard guard(mutex_);
    closed_ = left_ = true;
    grew_.notify_all();
    for (const std::string& key : at_work_) spool_.give_back(key);
    return waiting_.size() + at_work_.size();
}

std::size_t Desk::queue_length() const {
    const std::lock_guard guard(mutex_);
    return waiting_.size();
}

}  // namespace harness::serve
