// A number exactly as an instructor wrote it. "0.1" is exactly one tenth; it becomes the nearest float, the nearest
// double or an exact fraction only when a stage asks for one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace reference {

class Decimal {
  public:
    /// Zero.
    Decimal() = default;

    /// Reads [sign] digits [. digits] [e [sign] digits], at most 400 characters, with TOML's underscores between
    /// digits. Empty when the text is anything else: inf and nan are not decimals.
    static std::optional<Decimal> parse(std::string_view text);

    /// As written, without underscores and without a leading '+'.
    const std::string& text() const { return text_; }

    /// The nearest value of the type, ties to even; infinite when the number is beyond the type's range.
    float to_float() const;
    double to_double() const;

    /// -1, 0 or 1, exactly.
    int sign() const;

  private:
    std::string text_ = "0";
};

template <class S>
S scalar_from(const Decimal& number);
template <>
inline float scalar_from<float>(const Decimal& number) {
    return number.to_float();
}
template <>
inline double scalar_from<double>(const Decimal& number) {
    return number.to_double();
}

}  // namespace reference
