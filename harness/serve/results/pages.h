// The pages other than the result itself: the form, the waiting page and error messages.
#pragma once

#include <chrono>
#include <string>

#include "harness/serve/queue/queue.h"

namespace harness::serve {

/// Facts about this server for its pages.
struct About {
    std::string title;  ///< of the assignment
    std::chrono::hours keep;
    double variant_points = 0;  ///< the rubric's points for other scenes; results on the site do not include them
};

// All are complete pages. Links and addresses are relative, so a proxy may serve them below any path.

/// The page at the root of the site.
std::string front_page(const About& about);

/// The page at the result's address while there is no result.
std::string waiting_page(const About& about, const std::string& result_address, const Standing& standing);

/// A sentence for the waiting student: "Your program is number 3 of 7 in the queue. The last program took 4 s."
std::string sentence_of(const Standing& standing);

/// A sentence saying that points for other scenes are not shown; empty if the rubric gives none.
std::string not_shown(const About& about);

/// `to_top` is the relative path to the front page: "." or "..".
std::string message_page(const About& about, const std::string& heading, const std::string& sentence,
                         const std::string& to_top);

/// Adds a link back to the form and the sentence of not_shown to a student's page.
std::string as_result(const About& about, std::string student_page);

/// The Content-Security-Policy of a page that loads only this server's own style, script and icon.
std::string own_policy();
/// The Content-Security-Policy of a student's page: no script, no form, and only the styles that the page contains.
std::string student_policy(const std::string& student_page);

}  // namespace harness::serve
