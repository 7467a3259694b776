// One student in the class report: a row of its table, and a sheet with what was printed against what was asked.
#pragma once

#include <string>

#include "harness/grade/graded.h"
#include "harness/grade/marking.h"
#include "harness/report/page/evidence.h"
#include "harness/report/page/page_template.h"
#include "harness/report/picture/picture.h"
#include "harness/report/text/expected_text.h"
#include "reference/stages/item_values.h"

namespace harness::report {

/// "compile error".
std::string outcome_words(Outcome outcome);

/// Links to the sheets of the students `who`, escaped: "<a href="#s3">…</a>, …".
std::string links_to(const std::vector<std::size_t>& who, const std::vector<Graded>& graded);

/// The columns that the table of students has only if they say something.
struct ClassColumns {
    bool named = false;  ///< students have names, so their ids have a column of their own
    bool dated = false;  ///< submissions come from a system that knows which are late
};
ClassColumns columns_of(const std::vector<Graded>& graded);

class ClassSheets {
  public:
    /// `marking` must outlive it.
    ClassSheets(const Marking& marking, const ClassColumns& columns);

    /// What the sheets' pictures share; must stand before them.
    std::string shared_part() const { return pictures_.shared_part(); }
    std::string row(const Graded& graded, std::size_t index);
    std::string sheet(const Graded& graded, std::size_t index);

  private:
    std::string rows_of(const Graded& graded, const QuestionScore& question, const ExpectedTexts& asked,
                        const Listing& printout);
    /// How much of a text this sheet may still show, of all that the sheets show together.
    ListingBounds bounds_left() const;
    std::string picture_of(const Graded& graded, std::size_t index);

    const Marking& marking_;
    ClassColumns columns_;
    ExpectedTexts asked_;
    std::size_t picture_bytes_ = 0;  ///< of all sheets so far
    std::size_t listing_bytes_ = 0;  ///< of all sheets so far
    PageTemplate row_;
    PageTemplate sheet_;
    PageTemplate item_;
    Evidence evidence_;
    ExplainingPictures pictures_;
};

}  // namespace harness::report
