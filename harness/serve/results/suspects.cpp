#include "harness/serve/results/suspects.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "harness/machine/errors.h"
#include "harness/machine/file_descriptor.h"
#include "harness/machine/say.h"

namespace harness::serve {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

constexpr auto longest_grading = 10min;
constexpr int most_crashes = 2;

std::string text_of(const Result& result) {
    json all{{"page", json::binary({result.page.begin(), result.page.end()})}, {"max_points", result.max_points}};
    if (result.points) all["points"] = *result.points;
    const std::vector<std::uint8_t> bytes = json::to_cbor(all);
    return {bytes.begin(), bytes.end()};
}

/// Empty if the text is not whole.
std::optional<Result> result_of(const std::string& text) {
    const json all = json::from_cbor(text, true, false);
    if (!all.is_object() || !all.contains("page")) return std::nullopt;
    const auto& page = all.at("page").get_binary();
    Result result{std::string(page.begin(), page.end()), std::nullopt, all.at("max_points").get<double>()};
    if (all.contains("points")) result.points = all.at("points").get<double>();
    return result;
}

[[noreturn]] void work_in_child(const std::function<Result()>& work, int out) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    std::string text;
    try {
        text = text_of(work());
    } catch (...) {
        _exit(1);
    }
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t written = write(out, text.data() + at, text.size() - at);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) _exit(1);
        at += static_cast<std::size_t>(written);
    }
    _exit(0);
}

/// All bytes until the other end is closed, or until `end`.
std::string read_until(int in, std::chrono::steady_clock::time_point end) {
    std::string text;
    std::array<char, 65536> bytes;
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        if (left <= 0ms) return text;
        pollfd wait{in, POLLIN, 0};
        if (poll(&wait, 1, static_cast<int>(left.count())) <= 0) continue;
        const ssize_t got = read(in, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return text;
        text.append(bytes.data(), static_cast<std::size_t>(got));
    }
}

}  // namespace

std::optional<Result> in_own_process(const std::function<Result()>& work, std::chrono::seconds longest) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw HarnessError("There can be no pipe: " + std::generic_category().message(errno));
    const FileDescriptor in(ends[0]);
    FileDescriptor out(ends[1]);
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw HarnessError("There can be no process: " + std::generic_category().message(errno));
    if (child == 0) work_in_child(work, out.get());
    out = FileDescriptor();
    const std::string text = read_until(in.get(), std::chrono::steady_clock::now() + longest);
    kill(child, SIGKILL);  // it has ended, or takes too long
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return result_of(text);
}

void try_suspects(Queue& queue, const std::function<Result(const Task&)>& grade, const Result& given_up) {
    const std::size_t count = queue.suspects();
    if (count > 0) {
        say("raygrade ended while {} {} graded; trying {} alone\n", count, count == 1 ? "program was" : "programs were",
            count == 1 ? "it" : "each");
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<Task> task = queue.next();
        if (!task) return;
        std::optional<Result> result;
        for (int crashes = 0; !result && crashes < most_crashes; ++crashes)
            result = in_own_process([&] { return grade(*task); }, longest_grading);
        if (!result) say("program {}: crashed raygrade, and is not tried again\n", task->number);
        queue.finish(*task, result.value_or(given_up));
    }
}

}  // namespace harness::serve
