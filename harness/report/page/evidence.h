// What a page shows of a submission besides its marks: the compiler's messages, flags, findings, notes, standard error.
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

    /// Errors and warnings with the line of the source that each names, and all the compiler said; empty when it said
    /// nothing. `source` is the listing that the lines are links to, if the page has one.
    std::string compiler(const Graded& graded, const Listing& source) const;
    /// Everything else; empty when there is nothing. The lines that it names are links to these listings.
    std::string others(const Graded& graded, const Listing& printout, const Listing& source) const;
};

}  // namespace harness::report
