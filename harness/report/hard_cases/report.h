// The catalog of hard cases as a table and as a picture: what each arithmetic answers, and which answers are wrong.
#pragma once

#include <string>

namespace harness::report {

struct HardCasesReport {
    std::string text;  ///< for a terminal of 120 columns
    std::string svg;   ///< each case with a small picture
    std::string page;  ///< HTML that loads nothing: the picture, and the text folded
    bool passes;       ///< the certified arithmetic answers every case rightly
};
HardCasesReport hard_cases_report();

}  // namespace harness::report
