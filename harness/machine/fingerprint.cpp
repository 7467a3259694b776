#include "harness/machine/fingerprint.h"

#include <sodium.h>

#include <array>
#include <charconv>

#include "harness/machine/errors.h"

namespace harness {

Fingerprint& Fingerprint::add(std::string_view field) {
    std::array<char, 24> size{};
    char* end = std::to_chars(size.data(), size.data() + size.size(), field.size()).ptr;
    *end++ = ':';
    fields_.append(size.data(), end);
    fields_ += field;
    return *this;
}

Fingerprint& Fingerprint::add(std::int64_t field) {
    std::array<char, 24> digits{};
    const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), field).ptr;
    return add(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
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
