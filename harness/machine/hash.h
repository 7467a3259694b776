// Sets up libsodium, and returns its hashes as text.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace harness {

/// Sets up libsodium; must come before any other call of it. Throws HarnessError.
void set_up_sodium();

/// Throws HarnessError if libsodium can't be set up.
std::array<unsigned char, 32> sha256(std::string_view bytes);

/// Two lower-case hexadecimal digits for each byte.
std::string hex_of(std::span<const unsigned char> bytes);

}  // namespace harness
