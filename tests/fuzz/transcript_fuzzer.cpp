// libFuzzer target: reads and matches any bytes without a fault. Built with -DRAYGRADE_FUZZ=ON and clang++:
//   fuzz_transcript -max_len=4096 a-folder-to-grow tests/fuzz/transcript_corpus
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tests/fuzz/transcript_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (!check_transcript({reinterpret_cast<const char*>(data), size}).empty()) __builtin_trap();
    return 0;
}
