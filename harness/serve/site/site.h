// What the self-check page answers to what is asked of it.
//
//   GET  /                      the form
//   POST /check                 a program: on to its result's address; for scripts that address as JSON
//   GET  /result/<address>      the waiting room, then the student's page
//   GET  /result/<address>/standing   the same as JSON: standing, position, points
//   GET  /style.css, /script.js, /icon.svg
//
// There is no list of results and no way from one to another.
#pragma once

#include <optional>
#include <string>

#include "harness/serve/desk.h"
#include "harness/serve/exchange.h"
#include "harness/serve/host_names.h"
#include "harness/serve/pages.h"
#include "harness/serve/rate_limit.h"

namespace harness::serve {

struct SiteSettings {
    About about;
    Reach reach;
    double turns_a_minute = 10;  ///< programs of one client, as many of them at once
};

/// For one thread. Functions throw HarnessError where the disk fails them.
class Site {
  public:
    Site(SiteSettings settings, Desk& desk);

    /// The answer, where it does not depend on a body; empty for a program that is welcome.
    std::optional<Response> answer(const Head& head);
    /// The answer to that program.
    Response take_in(const Head& head, const std::string& body);
    /// What can't be read as HTTP or is more than is read: 400, 413 or 431; 503 for too many at a time, 500 where
    /// answering failed.
    Response problem(const Head& head, int status) const;

  private:
    std::optional<Response> answer_check(const Head& head) const;
    Response answer_result(const Head& head, const std::string& result_address) const;
    Response answer_standing(const std::string& result_address) const;
    Response say(const Head& head, int status, const std::string& heading, const std::string& sentence) const;
    Response refuse(const Head& head, Refusal refusal) const;
    std::optional<Response> too_soon(const Head& head) const;

    SiteSettings settings_;
    Desk& desk_;
    RateLimit rate_;
};

}  // namespace harness::serve
