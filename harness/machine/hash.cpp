#include "harness/machine/hash.h"

#include <sodium.h>

#include "harness/machine/errors.h"

namespace harness {

void set_up_sodium() {
    if (sodium_init() < 0)
        throw HarnessError("libsodium cannot start: this machine gives no random numbers. Check /dev/urandom.");
}

std::array<unsigned char, 32> sha256(std::string_view bytes) {
    set_up_sodium();
    std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
    crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    return hash;
}

std::string hex_of(std::span<const unsigned char> bytes) {
    std::string hex(2 * bytes.size() + 1, '\0');
    sodium_bin2hex(hex.data(), hex.size(), bytes.data(), bytes.size());
    hex.pop_back();  // the terminating zero
    return hex;
}

}  // namespace harness
