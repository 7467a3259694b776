// The parts of a submission's page besides its marks: compiler messages, flags, findings, notes, standard error.
#pragma once

#include <string>
#include <string_view>

#include "harness/mark/score/doubts_text.h"
#include "harness/record/graded.h"
#include "harness/report/page/listing.h"
#include "harness/report/page/page_template.h"

namespace harness::report {

struct Evidence {
    std::string_view heading;    ///< the element for headings, such as "h2"
    std::size_t most_bytes = 0;  ///< of each text from the submission
    Audience audience = Audience::student;

    /// Errors and warnings, each with its source line, and all of the compiler's messages; empty if there are none.
    /// Lines are links into the listing `source`, if the page has one.
    std::string compiler(const Graded& graded, const Listing& source) const;
    /// Everything else; empty if there is nothing. Line numbers are links into these listings.
    std::string others(const Graded& graded, const Listing& printout, const Listing& source) const;
};

}  // namespace harness::report
