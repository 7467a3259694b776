// The static files of the site: style.css, script.js and icon.svg of this folder.
#pragma once

#include <string_view>

namespace harness::serve::assets {

extern const std::string_view style_css;
extern const std::string_view script_js;
extern const std::string_view icon_svg;

}  // namespace harness::serve::assets
