// One time that a class was graded, and the lists that its reports were made with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "harness/execution/tier.h"
#include "harness/gradebook/author.h"

namespace harness {

/// One time that a class was graded and the results written.
struct Run {
    std::int64_t number = 0;  ///< from 1; given by the gradebook
    Author author;
    std::string raygrade;  ///< its version
    std::string assignment;
    std::filesystem::path assignment_file;
    std::string toml;  ///< the assignment's text
    Tier tier = Tier::bwrap;
};

/// A file besides the submissions that reports are made from, such as a gradebook exported from Canvas.
struct KeptInput {
    std::string name;    ///< "canvas-roster"
    std::string choice;  ///< the part of it that is used, such as a column
    std::string content;
};

}  // namespace harness
