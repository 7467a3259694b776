// How well a student's program is isolated from this machine.
#pragma once

#include <string>
#include <string_view>

namespace harness {

/// From the strongest to none. raygrade attacks each tier to find out whether it works on this machine (canary.h).
enum class Tier {
    bwrap,     ///< own namespaces made by bubblewrap, with the supervisor as first process; seccomp
    landlock,  ///< Landlock and seccomp under the supervisor, for machines that refuse user namespaces
    unsafe,    ///< only limits: the program may read, send and signal anything its account may
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

/// The warning for every report of marks that were made without a sandbox; empty if there was a sandbox.
std::string sandbox_warning(Tier tier);

}  // namespace harness
