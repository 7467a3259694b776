// One query of `raygrade cast`, read from its line of JSON.
#pragma once

#include <stdexcept>
#include <string_view>

#include "reference/kernel/first.h"

namespace reference::cast {

struct Query {
    kernel::Ray<double> ray;
    kernel::Objects objects;
};

/// The line is not a valid query; what() says why.
class MalformedQuery : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws MalformedQuery.
Query read_query(std::string_view line);

}  // namespace reference::cast
