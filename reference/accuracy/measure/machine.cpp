#include "reference/accuracy/measure/machine.h"

#include <fstream>

namespace reference::accuracy {

std::string compiler() {
#if defined(__clang__)
    return "clang++ " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

std::string arithmetic_flags() {
    return RAYGRADE_FLAGS;
}

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t name = line.find_first_not_of(" :", line.find(':'));
        return name == std::string::npos ? "" : line.substr(name);
    }
    return "";
}

}  // namespace reference::accuracy
