// The catalog of hard cases as a table and as a picture: each arithmetic's answers, and which of them are wrong.
#pragma once

#include <string>

namespace harness::report {

struct HardCasesReport {
    std::string text;  ///< for a terminal of 120 columns
    std::string svg;   ///< each case with a small picture
    std::string page;  ///< HTML that loads nothing: the picture, and the text in a collapsed section
    bool passes;       ///< the certified arithmetic answers every case correctly
};
HardCasesReport hard_cases_report();

}  // namespace harness::report
