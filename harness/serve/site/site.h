// Answers the requests to the self-check site.
//
//   GET  /                      the form
//   POST /check                 takes a program and redirects to its result; scripts get the address as JSON
//   GET  /result/<address>      the waiting page, then the student's page
//   GET  /result/<address>/standing   the same as JSON: standing, position, points
//   GET  /style.css, /script.js, /icon.svg
//
// There is no list of results and no link from one result to another.
#pragma once

#include <optional>
#include <string>

#include "harness/serve/queue/queue.h"
#include "harness/serve/results/pages.h"
#include "harness/serve/site/exchange.h"
#include "harness/serve/site/host_names.h"
#include "harness/serve/site/rate_limit.h"

namespace harness::serve {

struct SiteSettings {
    About about;
    Reach reach;
    double turns_a_minute = 10;  ///< programs of one client per minute; all may come at once
};

/// Use it from one thread only. Functions throw HarnessError if the disk fails.
class Site {
  public:
    Site(SiteSettings settings, Queue& queue);

    /// The answer, if it does not depend on the body; empty if take_in should get the body.
    std::optional<Response> answer(const Head& head);
    /// The answer to a program for which `answer` returned nothing.
    Response take_in(const Head& head, const std::string& body);
    /// The answer to a request that failed: 400 if it is not valid HTTP, 413 or 431 if it is too large, 503 if there is
    /// too much at a time, 500 if answering failed.
    Response problem(const Head& head, int status) const;

  private:
    std::optional<Response> answer_check(const Head& head) const;
    Response answer_result(const Head& head, const std::string& result_address) const;
    Response answer_standing(const std::string& result_address) const;
    Response say(const Head& head, int status, const std::string& heading, const std::string& sentence) const;
    Response refuse(const Head& head, Refusal refusal) const;
    std::optional<Response> too_soon(const Head& head) const;

    SiteSettings settings_;
    Queue& queue_;
    RateLimit rate_;
};

}  // namespace harness::serve
