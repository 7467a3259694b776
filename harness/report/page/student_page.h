// A student's own page: the same marking as feedback_markdown, for a browser.
#pragma once

#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/report/page/evidence.h"
#include "harness/report/page/page_template.h"
#include "harness/report/text/expected_text.h"
#include "reference/stages/item_values.h"

namespace harness::report {

/// Makes the students' pages of one assignment. Each page is self-contained: no script, no request, safe under a strict
/// Content-Security-Policy, well-formed as XML too. No expected values unless the rubric shows them
/// (Feedback::expected).
class StudentPages {
  public:
    /// `marking` must outlive it. The pages tell as much as the rubric lets be told now.
    explicit StudentPages(const Marking& marking);

    std::string page(const Graded& graded);

  private:
    std::string question(const Graded& graded, const QuestionScore& question, const Listing& printout);
    /// `said`: the question's note already tells why the item is not right.
    PageData item(const Graded& graded, const QuestionScore& question, const ItemScore& item, bool said,
                  const Listing& printout) const;

    const Marking& marking_;
    reference::Feedback feedback_;
    ExpectedTexts asked_;  ///< expected values; empty if the rubric does not show them
    std::string style_;
    std::string policy_;
    PageTemplate page_;
    PageTemplate question_;
    Evidence evidence_;
};

/// One page.
std::string student_page(const Graded& graded, const Marking& marking);

}  // namespace harness::report
