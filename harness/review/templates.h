// The texts of the review's pages, named like their files in templates/: *.mustache are templates (mustache(5));
// review.css comes after the style of all pages; review.js has the keyboard shortcuts.
#pragma once

#include <string_view>

namespace harness::review::templates {

extern const std::string_view review_css;
extern const std::string_view review_js;
extern const std::string_view icon_svg;  ///< the same as the self-check site's

extern const std::string_view frame_mustache;
extern const std::string_view group_mustache;
extern const std::string_view list_mustache;
extern const std::string_view notice_mustache;
extern const std::string_view student_mustache;

}  // namespace harness::review::templates
