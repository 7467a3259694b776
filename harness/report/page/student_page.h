// A student's own page: the same marking as feedback_markdown, for a browser.
#pragma once

#include <map>
#include <string>

#include "harness/grade.h"
#include "harness/report/evidence.h"
#include "harness/report/explaining_picture.h"
#include "harness/report/page_template.h"
#include "reference/item_values.h"

namespace harness::report {

/// The pages of one assignment. Each is whole and self-contained: no script, no request, safe under a strict
/// Content-Security-Policy, well-formed as XML too. Never an expected value unless the rubric says so
/// (Rubric::show_expected).
class StudentPages {
  public:
    /// `marking` must outlive it.
    explicit StudentPages(const Marking& marking);

    std::string page(const Graded& graded);

  private:
    std::string question(const Graded& graded, const QuestionScore& question);
    /// `said`: the question's own note tells why it is not right.
    PageData item(const Graded& graded, const QuestionScore& question, const ItemScore& item, bool said) const;

    const Marking& marking_;
    std::map<reference::ItemId, std::string> asked_;  ///< empty where the rubric does not show it
    std::string style_;
    std::string policy_;
    PageTemplate page_;
    PageTemplate question_;
    Evidence evidence_;
    ExplainingPictures pictures_;
};

/// One page.
std::string student_page(const Graded& graded, const Marking& marking);

}  // namespace harness::report
