// The pages around the student's own: the form, the waiting room, and what is said when something can't be done.
#pragma once

#include <chrono>
#include <string>

#include "harness/serve/desk.h"

namespace harness::serve {

/// What the pages say of this server.
struct About {
    std::string title;  ///< of the assignment
    std::chrono::hours keep;
    double variant_points = 0;  ///< the rubric's points for other scenes, which are no part of what is shown
};

// All of them are whole pages. Links and addresses are relative, so that a proxy may put them below any path.

/// At the top.
std::string front_page(const About& about);

/// At the result's address, while there is no result.
std::string waiting_page(const About& about, const std::string& result_address, const Standing& standing);

/// "Your program is number 3 of 7 in the queue."; for a person who waits.
std::string sentence_of(const Standing& standing);

/// That the points for other scenes are no part of what is shown; empty where the rubric gives none.
std::string not_shown(const About& about);

/// `to_top` is the way to the front page: "." or "..".
std::string message_page(const About& about, const std::string& heading, const std::string& sentence,
                         const std::string& to_top);

/// A student's page with the way back to the form at its top, and what is not shown of its points.
std::string as_result(const About& about, std::string student_page);

/// The Content-Security-Policy of a page that loads nothing but this server's own style, script and icon.
std::string own_policy();
/// That of a student's page: no script and no form, and of styles in it just those that it has.
std::string student_policy(const std::string& student_page);

}  // namespace harness::serve
