// What a time was measured with.
#pragma once

#include <string>

namespace reference::accuracy {

/// With its version: "g++ 12.2.0".
std::string compiler();

/// Of the compiler, as far as arithmetic depends on them: those of the build and those of the project.
std::string arithmetic_flags();

/// Empty where the kernel of the machine gives no name.
std::string processor();

}  // namespace reference::accuracy
