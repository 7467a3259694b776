// A student's own way of writing a printout: a grammar of layouts, drawn independently for each student and the same
// throughout one printout.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "tests/given/student/program.h"

namespace student {

struct Writing {
    std::string output;
    std::map<std::string, std::string> features;  ///< what was drawn: feature -> choice
};

/// Prints a program's answers in the way of student `seed`.
Writing write(const Program& program, std::uint64_t seed);

}  // namespace student
