#include "harness/execution/process_result.h"

namespace harness {

std::string_view word_for(Ended ended) {
    switch (ended) {
        case Ended::not_started: return "not_started";
        case Ended::exited: return "exited";
        case Ended::signalled: return "signalled";
        case Ended::refused: return "refused";
        case Ended::cpu_limit: return "cpu_limit";
        case Ended::wall_limit: return "wall_limit";
        case Ended::memory_limit: return "memory_limit";
        case Ended::process_limit: return "process_limit";
        case Ended::output_limit: return "output_limit";
    }
    return "";
}

std::optional<Ended> ended_from(std::string_view word) {
    for (const Ended ended : {Ended::not_started, Ended::exited, Ended::signalled, Ended::refused, Ended::cpu_limit,
                              Ended::wall_limit, Ended::memory_limit, Ended::process_limit, Ended::output_limit}) {
        if (word_for(ended) == word) return ended;
    }
    return {};
}

}  // namespace harness
