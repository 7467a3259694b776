// A name for content: two contents with one fingerprint are never met, also not on purpose.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace harness {

/// Collects fields and gives their BLAKE2b hash. Fields are kept apart: "ab", "c" is not "a", "bc".
class Fingerprint {
  public:
    /// `purpose` sets the fingerprints of one use apart from those of another, and one version of it from the next.
    explicit Fingerprint(std::string_view purpose) { add(purpose); }
    Fingerprint& add(std::string_view field);
    Fingerprint& add(std::int64_t field);
    /// 64 lower-case hexadecimal digits.
    std::string hex() const;

  private:
    std::string fields_;
};

}  // namespace harness
