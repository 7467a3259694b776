// How well a stranger's program is kept apart from this machine.
#pragma once

#include <string_view>

namespace harness {

/// From the strongest to none. Which of them a machine holds is found out by attacking it (canary.h).
enum class Tier {
    bwrap,     ///< namespaces of its own made by bubblewrap, seccomp, the supervisor as their first process
    landlock,  ///< Landlock and seccomp below the supervisor, for machines that refuse user namespaces
    unsafe,    ///< limits alone: the program may read, send and signal whatever its account may
};

/// The name in grades.json and on the command line of the supervisor.
constexpr std::string_view to_string(Tier tier) {
    switch (tier) {
        case Tier::bwrap: return "bwrap+shim";
        case Tier::landlock: return "landlock+shim";
        case Tier::unsafe: return "unsafe";
    }
    return "";
}

}  // namespace harness
