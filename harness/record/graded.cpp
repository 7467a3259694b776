#include "harness/record/graded.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace harness {
std::string_view to_string(Outcome outcome) {
    switch (outcome) {
        case Outcome::graded: return "graded";
        case Outcome::compile_error: return "compile_error";
        case Outcome::crashed: return "crashed";
        case Outcome::timed_out: return "timed_out";
        case Outcome::output_limit: return "output_limit";
        case Outcome::memory_limit: return "memory_limit";
        case Outcome::no_output: return "no_output";
        case Outcome::not_graded: return "not_graded";
    }
    return "";
}

std::string_view to_string(Decision::Kind kind) {
    switch (kind) {
        case Decision::Kind::accepted: return "accepted";
        case Decision::Kind::comment: return "comment";
        case Decision::Kind::points: return "override";
        case Decision::Kind::reading: return "reread";
    }
    return "";
}

std::string signal_name(int signal) {
    const char* name = sigabbrev_np(signal);
    return name == nullptr ? fmt::format("signal {}", signal) : fmt::format("SIG{}", name);
}

std::string_view limit_name(Ended ended) {
    switch (ended) {
        case Ended::not_started:
        case Ended::exited:
        case Ended::signalled:
        case Ended::refused: return "";
        case Ended::cpu_limit: return "run.cpu_seconds";
        case Ended::wall_limit: return "run.wall_seconds";
        case Ended::memory_limit: return "run.memory_mib";
        case Ended::process_limit: return "run.processes";
        case Ended::output_limit: return "run.output_kib";
    }
    return "";
}

std::string note_of(const Reread& reread) {
    if (reread.lines.empty()) return fmt::format("Not printed, as {} says: {}", reread.by, reread.why);
    const std::string_view lines =
        reread.lines.find('-') == std::string::npos || reread.lines.find(':') != std::string::npos ? "line" : "lines";
    return fmt::format("Read from {} {}, as {} says: {}", lines, reread.lines, reread.by, reread.why);
}

std::string compilers_of(const std::vector<Graded>& graded) {
    std::set<std::string> compilers;
    for (const Graded& result : graded) {
        if (!result.execution.compiler.empty()) compilers.insert(result.execution.compiler);
    }
    return fmt::format("{}", fmt::join(compilers, ", "));
}

bool counts(const Graded& graded, const Reread& reread) {
    const std::string note = note_of(reread);
    return std::any_of(graded.score.questions.begin(), graded.score.questions.end(),
                       [&](const QuestionScore& question) {
                           return question.number == reread.question &&
                                  std::any_of(question.items.begin(), question.items.end(), [&](const ItemScore& item) {
                                      return item.spec.name == reread.item && item.reread == note;
                                  });
                       });
}

}  // namespace harness
