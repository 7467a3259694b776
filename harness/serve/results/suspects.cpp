#include "harness/serve/results/suspects.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "harness/machine/child_process.h"
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

Result result_of(const std::string& text) {
    const json all = json::from_cbor(text);
    const auto& page = all.at("page").get_binary();
    Result result{std::string(page.begin(), page.end()), std::nullopt, all.at("max_points").get<double>()};
    if (all.contains("points")) result.points = all.at("points").get<double>();
    return result;
}

}  // namespace

std::optional<Result> in_own_process(const std::function<Result()>& work, std::chrono::seconds longest) {
    std::fflush(nullptr);  // what is not written yet would be written by both
    ChildProcess child("to grade a program in", longest, [&](int pipe) {
        const std::string text = text_of(work());
        const std::size_t size = text.size();
        write_all(pipe, &size, sizeof size);
        write_all(pipe, text.data(), size);
    });
    std::size_t size = 0;
    if (!child.read(&size, sizeof size)) return std::nullopt;
    std::string text(size, '\0');
    if (!child.read(text.data(), size)) return std::nullopt;
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
