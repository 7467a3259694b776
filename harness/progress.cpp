#include "harness/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>

namespace harness {
namespace {

double seconds(std::chrono::milliseconds time) {
    return static_cast<double>(time.count()) / 1000;
}

std::string time_left(double left) {
    constexpr double minute = 60;
    return left < 2 * minute ? fmt::format("{:.0f} s", left) : fmt::format("{:.0f} min", left / minute);
}

}  // namespace

std::string progress_text(std::size_t finished, std::size_t total, std::chrono::duration<double> elapsed) {
    std::string text = fmt::format("{} of {}", finished, total);
    if (finished == 0 || elapsed.count() <= 0) return text;
    const double rate = static_cast<double>(finished) / elapsed.count();
    text += fmt::format(", {:.{}f} a second", rate, rate < 10 ? 1 : 0);
    if (finished < total) text += fmt::format(", {} left", time_left(static_cast<double>(total - finished) / rate));
    return text;
}

std::string closing_line(const Timeline& timeline) {
    const double compiling = seconds(timeline.total(Stage::build));
    const double headers = seconds(timeline.total(Stage::header));
    const double marking = seconds(timeline.total(Stage::read) + timeline.total(Stage::score));
    std::string text = fmt::format("time, added up over all at work: compiling {:.1f} s", compiling + headers);
    if (headers > 0) text += fmt::format(" ({:.1f} s of it precompiled headers)", headers);
    text +=
        fmt::format(", running {:.1f} s, marking {:.1f} s; {} of {} from earlier runs, {} with a precompiled header",
                    seconds(timeline.total(Stage::run)), marking, timeline.from_store.load(), timeline.finished.load(),
                    timeline.by_header.load());
    return text;
}

Progress::Progress(const Timeline& timeline, std::size_t total)
    : timeline_(timeline), total_(total), is_terminal_(isatty(STDERR_FILENO) == 1) {
    teller_ = std::jthread([this](const std::stop_token& stop) { tell(stop); });
}

Progress::~Progress() {
    teller_.request_stop();
    teller_.join();
    if (is_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::tell(const std::stop_token& stop) const {
    using namespace std::chrono_literals;
    constexpr std::size_t width = 30;
    const auto start = Timeline::Clock::now();
    const auto pause = is_terminal_ ? 100ms : 10000ms;
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any wake;
    while (!stop.stop_requested()) {
        if (is_terminal_ || Timeline::Clock::now() - start >= pause) {
            const std::size_t finished = timeline_.finished;
            const std::string text = progress_text(finished, total_, Timeline::Clock::now() - start);
            const std::size_t filled = total_ == 0 ? width : std::min(width, width * finished / total_);
            if (is_terminal_) {
                fmt::print(stderr, "\r[{}{}] {}\x1b[K", std::string(filled, '#'), std::string(width - filled, '.'),
                           text);
            } else {
                fmt::print(stderr, "{}\n", text);
            }
        }
        wake.wait_for(lock, stop, pause, [] { return false; });
    }
}

}  // namespace harness
