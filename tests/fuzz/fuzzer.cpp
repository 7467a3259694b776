// A libFuzzer target: looks for bytes that break the properties FUZZED of properties.h. tests/README.md says how to run
// it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "tests/fuzz/properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string broken = FUZZED({reinterpret_cast<const char*>(data), size});
    if (broken.empty()) return 0;
    std::fprintf(stderr, "Broken: %s\n", broken.c_str());
    std::abort();
}
