// The interface of a site on the server: the self-check site or the review of a class.
#pragma once

#include <optional>
#include <string>

#include "harness/serve/request/exchange.h"

namespace harness::serve {

/// The server calls a service from one thread only.
class Service {
  public:
    Service() = default;
    virtual ~Service() = default;
    Service(const Service&) = delete;
    Service& operator=(const Service&) = delete;

    /// The answer, if it does not depend on the body; empty if take_in should get the body.
    virtual std::optional<Response> answer(const Head& head) = 0;
    /// The answer to a request with its body, for which `answer` returned nothing.
    virtual Response take_in(const Head& head, const std::string& body) = 0;
    /// The answer to a request that failed: 400 if it is not valid HTTP, 413 or 431 if it is too large, 500 if
    /// answering failed.
    virtual Response problem(const Head& head, int status) const = 0;
};

}  // namespace harness::serve
