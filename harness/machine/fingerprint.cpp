#include "harness/machine/fingerprint.h"

#include <sodium.h>

#include <array>
#include <charconv>

#include "harness/machine/hash.h"

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
    set_up_sodium();
    std::array<unsigned char, crypto_generichash_BYTES> hash{};
    crypto_generichash(hash.data(), hash.size(), reinterpret_cast<const unsigned char*>(fields_.data()), fields_.size(),
                       nullptr, 0);
    return hex_of(hash);
}

}  // namespace harness
