#include "harness/serve/queue/result_address.h"

#include <sodium.h>

#include <algorithm>
#include <array>

#include "harness/machine/fingerprint.h"
#include "harness/machine/hash.h"

namespace harness::serve {
namespace {

constexpr std::size_t random_bytes = 16;

}  // namespace

std::string new_result_address() {
    set_up_sodium();
    std::array<unsigned char, random_bytes> bytes;
    randombytes_buf(bytes.data(), bytes.size());
    return hex_of(bytes);
}

bool is_result_address(std::string_view text) {
    return text.size() == 2 * random_bytes && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string key_of(const std::string& result_address) {
    return Fingerprint("raygrade/result-address/1").add(result_address).hex();
}

}  // namespace harness::serve
