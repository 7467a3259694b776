// Identifies content by a hash. Two contents with the same fingerprint never occur, not even on purpose.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace harness {

/// Collects fields and computes their BLAKE2b hash. Fields are kept apart: "ab", "c" is not "a", "bc".
class Fingerprint {
  public:
    /// `purpose` keeps the fingerprints of different uses apart, and of different versions of the same use.
    explicit Fingerprint(std::string_view purpose) { add(purpose); }
    Fingerprint& add(std::string_view field);
    Fingerprint& add(std::int64_t field);
    /// 64 lower-case hexadecimal digits.
    std::string hex() const;

  private:
    std::string fields_;
};

}  // namespace harness
