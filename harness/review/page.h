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

/// A message at the top of a page.
struct Notice {
    std::string sentence;
    bool is_problem = false;
    std::optional<std::int64_t> decision;  ///< the decision that can be undone; empty for none
};

class Pages {
  public:
    /// All paths of the review begin with `root`: "/<secret>". `session` must outlive it.
    Pages(const Session& session, std::string root);

    /// The submissions to review, and all students.
    std::string list(const std::optional<Notice>& notice);
    /// One student: output, source, items, picture, and decision forms. `tried` is a refused wish; the forms keep its
    /// text.
    std::string student(std::size_t index, const std::optional<Notice>& notice, const std::optional<Wish>& tried = {});
    /// Shows which submissions a decision would apply to, before it is made.
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
    /// All decisions, including undone ones, newest first.
    report::PageData past() const;
    report::PageData students() const;
    void add_concerns(report::PageData& data, std::size_t index, const std::optional<Wish>& tried) const;
    void add_decision_forms(report::PageData& data, std::size_t index, const std::optional<Wish>& tried) const;

    const Session& session_;
    std::string root_;
};

/// The Content-Security-Policy of all pages: only this server's own style, script and icon, and forms sent to this
/// server.
std::string page_policy();

/// "6.t"
std::string item_name(const ItemScore& item);

/// "62.5", or "no mark".
std::string mark_of(const Graded& graded);

/// A student's name in the review: "Doe, Jane (doejane)".
std::string name_of(const Submission& submission);

}  // namespace harness::review
