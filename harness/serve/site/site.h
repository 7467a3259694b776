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
#include "harness/serve/request/exchange.h"
#include "harness/serve/request/host_names.h"
#include "harness/serve/request/service.h"
#include "harness/serve/results/pages.h"

namespace harness::serve {

struct SiteSettings {
    About about;
    Reach reach;
};

/// Use it from one thread only. Functions throw HarnessError if the disk fails.
class Site : public Service {
  public:
    Site(SiteSettings settings, Queue& queue) : settings_(std::move(settings)), queue_(queue) {}

    std::optional<Response> answer(const Head& head) override;
    Response take_in(const Head& head, const std::string& body) override;
    Response problem(const Head& head, int status) const override;

  private:
    std::optional<Response> answer_check(const Head& head) const;
    Response answer_result(const Head& head, const std::string& result_address) const;
    Response answer_standing(const std::string& result_address) const;
    Response say(const Head& head, int status, const std::string& heading, const std::string& sentence) const;
    Response refuse(const Head& head, Refusal refusal) const;

    SiteSettings settings_;
    Queue& queue_;
};

}  // namespace harness::serve
