// The font of all text in pictures.
#pragma once

namespace harness::report {

inline constexpr const char* font_family = "Helvetica, Arial, 'Liberation Sans', sans-serif";

}  // namespace harness::report
