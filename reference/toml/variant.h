// A scene beside the assignment's own.
#pragma once

#include <string>

#include "reference/numbers/decimal.h"
#include "reference/stages/scene.h"

namespace reference {

/// A further scene for the same program. It tells computed answers from constants that the program prints.
struct Variant {
    std::string name;  ///< for people
    Scene<Decimal> scene;
};

}  // namespace reference
