// What a subcommand of raygrade is. Each writes results to stdout and messages to stderr, and returns the exit status.
#pragma once

#include <functional>

#include "harness/class_run/exit_status.h"

namespace CLI {
class App;
}

namespace harness {

/// A subcommand of the command line. After parsing, `run` does what the options ask for.
struct Subcommand {
    CLI::App* app = nullptr;
    std::function<int()> run;
};

}  // namespace harness
