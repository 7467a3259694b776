#include "harness/class_run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <condition_variable>
#include <csignal>
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

/// The time between two updates.
std::chrono::milliseconds pause_of(bool is_terminal) {
    using namespace std::chrono_literals;
    return is_terminal ? 100ms : 10000ms;
}

// What the handler of Ctrl-C tells of. It may call only what is safe in a signal handler.
const Timeline* interrupted_timeline = nullptr;
std::size_t interrupted_total = 0;
const char* interrupted_goes_on = nullptr;

void write_to_stderr(std::string_view text) {
    if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nobody is left to be told
}

void write_to_stderr(std::size_t number) {
    char digits[20];
    const char* end = std::to_chars(std::begin(digits), std::end(digits), number).ptr;
    write_to_stderr({digits, static_cast<std::size_t>(end - digits)});
}

/// Whether the program was started so, as a shell does in the background; then Ctrl-C is for others.
bool ignores_interrupts() {
    struct sigaction now {};
    return sigaction(SIGINT, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

/// Ends the program as Ctrl-C would without it, so that a shell's loop ends too.
void tell_and_end(int signal) {
    if (isatty(STDERR_FILENO) == 1) write_to_stderr("\r\x1b[K");
    write_to_stderr("stopped, ");
    write_to_stderr(interrupted_timeline->finished);
    write_to_stderr(" of ");
    write_to_stderr(interrupted_total);
    write_to_stderr(" done; ");
    write_to_stderr(interrupted_goes_on);
    write_to_stderr("\n");
    std::signal(signal, SIG_DFL);
    std::raise(signal);
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
    std::string text = fmt::format("time, summed over all jobs: compiling {:.1f} s", compiling + headers);
    if (headers > 0) text += fmt::format(" ({:.1f} s of it precompiled headers)", headers);
    text +=
        fmt::format(", running {:.1f} s, marking {:.1f} s; {} of {} from earlier runs, {} with a precompiled header",
                    seconds(timeline.total(Stage::run)), marking, timeline.from_cache.load(), timeline.finished.load(),
                    timeline.by_header.load());
    return text;
}

const char* after_interrupt(const Runner& runner) {
    if (!runner.result_cache) return "the same command begins anew";
    return runner.fresh ? "without --fresh the same command goes on" : "the same command goes on";
}

Progress::Progress(const Timeline& timeline, std::size_t total, const char* after_interrupt)
    : timeline_(timeline), total_(total), is_terminal_(isatty(STDERR_FILENO) == 1) {
    interrupted_timeline = &timeline;
    interrupted_total = total;
    interrupted_goes_on = after_interrupt;
    if (!ignores_interrupts()) std::signal(SIGINT, tell_and_end);
    teller_ = std::jthread([this](const std::stop_token& stop) { tell(stop); });
}

Progress::~Progress() {
    if (!ignores_interrupts()) std::signal(SIGINT, SIG_DFL);
    teller_.request_stop();
    teller_.join();
    if (is_terminal_) say("\r\x1b[K");
}

void Progress::tell(const std::stop_token& stop) const {
    const auto start = Timeline::Clock::now();
    const auto pause = pause_of(is_terminal_);
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any wake;
    while (!stop.stop_requested()) {
        if (is_terminal_ || Timeline::Clock::now() - start >= pause) {
            const std::size_t finished = timeline_.finished;
            const std::string text = progress_text(finished, total_, Timeline::Clock::now() - start);
            if (is_terminal_) {
                const double share = total_ == 0 ? 1.0 : static_cast<double>(finished) / static_cast<double>(total_);
                say("{} {}\x1b[K", bar(share), text);
            } else {
                say("{}\n", text);
            }
        }
        wake.wait_for(lock, stop, pause, [] { return false; });
    }
}

std::string share_text(double done, std::chrono::duration<double> elapsed) {
    constexpr double least = 0.01;
    std::string text = fmt::format("{:.0f} %", 100 * done);
    if (done >= least && done < 1) text += fmt::format(", {} left", time_left(elapsed.count() * (1 - done) / done));
    return text;
}

ShareProgress::ShareProgress()
    : is_terminal_(isatty(STDERR_FILENO) == 1), start_(Timeline::Clock::now()), told_(start_) {}

ShareProgress::~ShareProgress() {
    if (is_terminal_) say("\r\x1b[K");
}

void ShareProgress::tell(double done) {
    const auto now = Timeline::Clock::now();
    if (now - told_ < pause_of(is_terminal_)) return;
    told_ = now;
    const std::string text = share_text(done, now - start_);
    if (is_terminal_) {
        say("{} {}\x1b[K", bar(done), text);
    } else {
        say("{}\n", text);
    }
}

}  // namespace harness
