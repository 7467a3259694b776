// The compiler and the processor that a time was measured with.
#pragma once

#include <string>

namespace reference::accuracy {

/// With its version: "g++ 12.2.0".
std::string compiler();

/// The compiler flags that arithmetic depends on: the build's and the project's.
std::string arithmetic_flags();

/// Empty if the operating system gives no name.
std::string processor();

}  // namespace reference::accuracy
