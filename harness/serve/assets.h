// The files of the page that are the same for everyone: style.css, script.js and icon.svg of this folder.
#pragma once

#include <string_view>

namespace harness::serve {

extern const std::string_view style;
extern const std::string_view script;
extern const std::string_view icon;

}  // namespace harness::serve
