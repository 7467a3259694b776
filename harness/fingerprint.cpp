#include "harness/fingerprint.h"

#include <sodium.h>

#include <array>

#include "harness/failure.h"

namespace harness {

Fingerprint& Fingerprint::add(std::string_view field) {
    fields_ += std::to_string(field.size());
    fields_ += ':';
    fields_ += field;
    return *this;
}

Fingerprint& Fingerprint::add(std::int64_t field) {
    return add(std::to_string(field));
}

std::string Fingerprint::hex() const {
    if (sodium_init() < 0) throw HarnessError("libsodium could not be set up: no random numbers on this machine.");
    std::array<unsigned char, crypto_generichash_BYTES> hash{};
    crypto_generichash(hash.data(), hash.size(), reinterpret_cast<const unsigned char*>(fields_.data()), fields_.size(),
                       nullptr, 0);
    std::string hex(2 * hash.size() + 1, '\0');
    sodium_bin2hex(hex.data(), hex.size(), hash.data(), hash.size());
    hex.pop_back();
    return hex;
}

}  // namespace harness
