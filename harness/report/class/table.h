// The table of students in the class report, and the links from students' names.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/report/page/page_template.h"

namespace harness::report {

/// "late", or nothing.
std::string late_text(const Graded& graded);

struct Students {
    const std::vector<Graded>& graded;
    std::vector<std::string> addresses;  ///< the target of each name's link: "#s3", or the student's own page

    /// Links to the students `who`, escaped: "<a href="#s3">…</a>, …".
    std::string links_to(const std::vector<std::size_t>& who) const;
};

/// The optional columns of the table; it has each only when useful.
struct ClassColumns {
    bool named = false;  ///< students have names, so their ids have a column of their own
    bool dated = false;  ///< submissions come from a system that knows which are late
};

class ClassTable {
  public:
    /// `students` must outlive it.
    explicit ClassTable(const Students& students);

    const ClassColumns& columns() const { return columns_; }
    std::string row(std::size_t index);

  private:
    const Students& students_;
    ClassColumns columns_;
    PageTemplate row_;
};

}  // namespace harness::report
