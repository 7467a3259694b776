// The mistakes that students make, as their programs make them: in float and with GLM, written without a look at how
// the harness finds them.
#pragma once

#include <string_view>
#include <vector>

#include "tests/student/program.h"

namespace student {

struct NamedMistake {
    std::string_view name;  ///< what the harness is to call it
    Program::Mistake mistake;
};

/// At least one for each entry of the harness's own table.
const std::vector<NamedMistake>& named_mistakes();

}  // namespace student
