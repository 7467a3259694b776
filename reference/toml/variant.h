// An additional scene of an assignment.
#pragma once

#include <string>

#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"

namespace reference {

/// Another scene for the same program. It distinguishes computed answers from constants that the program prints.
struct Variant {
    std::string name;  ///< for people
    Scene<Decimal> scene;
};

}  // namespace reference
