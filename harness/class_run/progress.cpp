#include "harness/class_run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>

#include "harness/machine/say.h"
#include "harness/run/timeline.h"

namespace harness {
namespace {

double seconds(std::chrono::milliseconds time) {
    return static_cast<double>(time.count()) / 1000;
}

std::string time_left(double left) {
    constexpr double minute = 60;
    return left < 2 * minute ? fmt::format("{:.0f} s", left) : fmt::format("{:.0f} min", left / minute);
}

std::string bar(double done) {
    constexpr std::size_t width = 30;
    const auto filled = static_cast<std::size_t>(static_cast<double>(width) * std::clamp(done, 0.0, 1.0));
    return fmt::format("\r[{}{}]", std::string(filled, '#'), std::string(width - filled, '.'));
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
    std::string text = fmt::format("time of all jobs together: compiling {:.1f} s", compiling + headers);
    if (headers > 0) text += fmt::format(" ({:.1f} s of it for precompiled headers)", headers);
    text += fmt::format(
        ", running {:.1f} s, marking {:.1f} s; {} of {} reused from earlier runs, {} compiled with a precompiled "
        "header",
        seconds(timeline.total(Stage::run)), marking, timeline.from_cache.load(), timeline.finished.load(),
        timeline.by_header.load());
    return text;
}

std::string share_text(double done, std::chrono::duration<double> elapsed) {
    constexpr double least = 0.01;
    std::string text = fmt::format("{:.0f} %", 100 * done);
    if (done >= least && done < 1) text += fmt::format(", {} left", time_left(elapsed.count() * (1 - done) / done));
    return text;
}

ProgressLine::ProgressLine()
    : is_terminal_(isatty(STDERR_FILENO) == 1), start_(Timeline::Clock::now()), told_(start_) {}

ProgressLine::~ProgressLine() {
    if (is_terminal_) say("\r\x1b[K");
}

void ProgressLine::tell(double done, const std::string& text) {
    told_ = Timeline::Clock::now();
    if (is_terminal_) {
        say("{} {}\x1b[K", bar(done), text);
    } else {
        say("{}\n", text);
    }
}

Progress::Progress(const Timeline& timeline, std::size_t total) : timeline_(timeline), total_(total) {
    teller_ = std::jthread([this](const std::stop_token& stop) { tell(stop); });
}

void Progress::tell(const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any wake;
    while (!wake.wait_for(lock, stop, line_.pause(), [&] { return stop.stop_requested(); })) {
        const std::size_t finished = timeline_.finished;
        const double share = total_ == 0 ? 1.0 : static_cast<double>(finished) / static_cast<double>(total_);
        line_.tell(share, progress_text(finished, total_, line_.elapsed()));
    }
}

void ShareProgress::tell(double done) {
    if (line_.is_due()) line_.tell(done, share_text(done, line_.elapsed()));
}

}  // namespace harness
