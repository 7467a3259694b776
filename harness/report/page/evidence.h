// What a page shows of a submission besides its marks: the compiler's messages, flags, findings, notes, standard error.
#pragma once

#include <string>
#include <string_view>

#include "harness/grade.h"
#include "harness/report/page_template.h"

namespace harness::report {

class Evidence {
  public:
    /// `heading` is the element of its headings, "h2"; of each text from the submission no more than `most_bytes` are
    /// shown.
    Evidence(std::string_view heading, std::size_t most_bytes);

    /// Errors and warnings by line, and the messages word for word; empty when there are none.
    std::string compiler(const Graded& graded);
    /// Everything else; empty when there is nothing.
    std::string others(const Graded& graded);

  private:
    std::string heading_;
    std::size_t most_bytes_;
    PageTemplate messages_;
    PageTemplate others_;
};

}  // namespace harness::report
