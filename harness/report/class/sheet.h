// One student's sheet in the class report: the printed values next to the right ones.
#pragma once

#include <string>

#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/report/page/evidence.h"
#include "harness/report/page/page_template.h"
#include "harness/report/text/expected_text.h"
#include "reference/stages/item_values.h"

namespace harness::report {

class ClassSheets {
  public:
    /// `marking` must outlive it.
    explicit ClassSheets(const Marking& marking);

    std::string sheet(const Graded& graded, std::size_t index);

  private:
    std::string rows_of(const Graded& graded, const QuestionScore& question, const ExpectedTexts& asked,
                        const Listing& printout);
    /// How much of a text this sheet may show, given the limit for all sheets together.
    ListingBounds bounds_left() const;
    std::string picture_of(const Graded& graded, std::size_t index);

    const Marking& marking_;
    ExpectedTexts asked_;
    std::size_t picture_bytes_ = 0;  ///< of all sheets so far
    std::size_t listing_bytes_ = 0;  ///< of all sheets so far
    PageTemplate sheet_;
    PageTemplate item_;
};

}  // namespace harness::report
