// The pages of the review, as HTML. All text of students is escaped.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/report/page/page_template.h"
#include "harness/report/picture/picture.h"
#include "harness/review/agenda.h"
#include "harness/review/decide.h"
#include "harness/review/session.h"

namespace harness::review {

/// What is said at the top of a page.
struct Notice {
    std::string sentence;
    bool is_problem = false;
    std::optional<std::int64_t> decision;  ///< which can be undone; empty for none
};

class Pages {
  public:
    /// `root` is the path before all of the review's own: "/<secret>". `session` must outlive it.
    Pages(const Session& session, std::string root);

    /// The submissions to review, and all students.
    std::string list(const std::optional<Notice>& notice);
    /// One student: output, source, items, picture, and what can be decided. `tried` is a wish that was refused, so
    /// that what was typed is still there.
    std::string student(std::size_t index, const std::optional<Notice>& notice, const std::optional<Wish>& tried = {});
    /// Shows for whom a decision would be made, before it is.
    std::string group(std::size_t index, const Wish& wish, const Group& group);
    std::string message(const std::string& heading, const std::string& sentence) const;

    /// The path of a student's page.
    std::string path_of(std::size_t index) const;

  private:
    std::string framed(const std::string& title, const std::string& body) const;
    std::string notice_html(const std::optional<Notice>& notice, const std::string& back) const;
    /// The submissions to review, by kind of concern.
    report::PageData chapters(const Agenda& agenda) const;
    report::PageData case_data(const Case& one, const std::string& kind) const;
    /// The decisions, the newest first, also those that were undone.
    report::PageData past() const;
    report::PageData students() const;
    void add_concerns(report::PageData& data, std::size_t index, const std::optional<Wish>& tried) const;
    void add_decision_forms(report::PageData& data, std::size_t index, const std::optional<Wish>& tried) const;

    const Session& session_;
    std::string root_;
};

/// The Content-Security-Policy of all pages: this server's own style, script and icon, and forms that go back to it.
std::string page_policy();

/// "6.t"
std::string item_name(const ItemScore& item);

/// "62.5", or "no mark".
std::string mark_of(const Graded& graded);

/// The name by which the review calls a student: "Doe, Jane (doejane)".
std::string name_of(const Submission& submission);

}  // namespace harness::review
