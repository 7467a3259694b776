#include "harness/report/student_page.h"

#include <fmt/format.h>

#include "harness/report/markup.h"
#include "harness/report/report.h"

namespace harness::report {

std::string student_page(const Graded& graded, const Marking& marking) {
    return fmt::format(
        "<!doctype html><html lang=\"en\"><meta "
        "charset=\"utf-8\"><title>{0}</title><h1>{0}</h1><pre>{1}</pre></html>\n",
        escape_markup(marking.assignment.title), escape_markup(check_text(graded)));
}

}  // namespace harness::report
