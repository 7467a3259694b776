// Answers the requests of the review. All paths are below a secret that only the person who started it knows:
//
//   GET  /<secret>/                     the list
//   GET  /<secret>/student/3            the third student of the class; …/done/12 reports the decision just made
//   POST /<secret>/decide               a decision for one, or the page that shows for whom it would be
//   POST /<secret>/apply                the decision for those chosen on that page
//   POST /<secret>/undo                 undoes a decision
//   POST /<secret>/take-back            takes one correction of one student back
//   GET  /<secret>/style.css, script.js, icon.svg
#pragma once

#include <optional>
#include <string>

#include "harness/review/form_fields.h"
#include "harness/review/page.h"
#include "harness/review/session.h"
#include "harness/serve/request/exchange.h"
#include "harness/serve/request/service.h"

namespace harness::review {

/// Answers only requests that come from this machine's own address and that name the secret.
class Site : public serve::Service {
  public:
    /// `secret` is 32 hexadecimal digits (serve/queue/result_address.h). `session` must outlive it.
    Site(Session& session, const std::string& secret);

    std::optional<serve::Response> answer(const serve::Head& head) override;
    serve::Response take_in(const serve::Head& head, const std::string& body) override;
    serve::Response problem(const serve::Head& head, int status) const override;

  private:
    std::optional<std::string> path_below_secret(const std::string& path) const;
    serve::Response show(const std::string& path);
    serve::Response post(const std::string& path, const FormFields& form);
    serve::Response decide_for_one_or_ask(const FormFields& form);
    serve::Response apply(const FormFields& form);
    serve::Response undo_one(const FormFields& form);
    serve::Response take_back(const FormFields& form);
    serve::Response refused(const UsageError& error, const FormFields& form);
    serve::Response after_decision(std::int64_t number, const std::string& id, const Wish& wish);

    Session& session_;
    std::string root_;
    Pages pages_;
};

}  // namespace harness::review
