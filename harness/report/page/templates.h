// The texts of the pages, named like their files in templates/: *.mustache are templates (mustache(5)), every page uses
// page.css, and the class report also uses class.css and class.js.
#pragma once

#include <string_view>

namespace harness::report::templates {

extern const std::string_view page_css;
extern const std::string_view class_css;
extern const std::string_view class_js;

extern const std::string_view student_mustache;
extern const std::string_view question_mustache;
extern const std::string_view messages_mustache;
extern const std::string_view evidence_mustache;
extern const std::string_view class_answers_mustache;
extern const std::string_view class_head_mustache;
extern const std::string_view class_groups_mustache;
extern const std::string_view class_panel_mustache;
extern const std::string_view class_row_mustache;
extern const std::string_view class_student_mustache;
extern const std::string_view class_table_mustache;
extern const std::string_view class_item_mustache;

}  // namespace harness::report::templates
