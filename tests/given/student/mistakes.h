// The mistakes that students make, computed as their programs do, in float and with GLM. The code was written without
// looking at how the harness finds the mistakes, but for those of the cylinder.
#pragma once

#include <string_view>
#include <vector>

#include "tests/given/student/program.h"

namespace student {

struct NamedMistake {
    std::string_view name;  ///< the name that the harness must give the mistake
    Program::Mistake mistake;
};

/// At least one mistake for each entry of the harness's own table.
const std::vector<NamedMistake>& named_mistakes();

}  // namespace student
