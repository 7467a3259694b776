// `raygrade stress FILE`: a student's own method over the hard scenes, as feedback.
#pragma once

#include <filesystem>
#include <string>

#include "harness/workshop.h"

namespace CLI {
class App;
}

namespace harness {

struct StressOptions {
    std::filesystem::path source;
    std::string assignment = "default";
    int jobs = 1;  ///< scenes compiled and run at a time
    bool json = false;
    WorkshopOptions workshop;
};

/// What is its own among the options, and the help that says what it does; assignment and workshop are the caller's.
void add_stress_options(CLI::App& command, StressOptions& options);

/// all_graded when the scenes were tried, whatever came of them; some_not_graded when none could be.
int stress_command(const StressOptions& options);

}  // namespace harness
