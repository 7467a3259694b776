// One query of `raygrade cast`, read from its line. The only file that knows the JSON parser is query.cpp.
#pragma once

#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

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

class QueryReader {
  public:
    QueryReader();
    ~QueryReader();
    QueryReader(const QueryReader&) = delete;
    QueryReader& operator=(const QueryReader&) = delete;

    /// Overwrites `query`, whose memory is reused from line to line. Throws MalformedQuery.
    void read(std::string_view line, Query& query);
    /// Reads a query to a scene: it has no objects of its own. Throws MalformedQuery.
    kernel::Ray<double> read_ray(std::string_view line);

  private:
    /// Returns how many keys were met, the origin and the direction among them.
    std::size_t read_fields(std::string_view line, Query& query);

    struct Parser;
    std::unique_ptr<Parser> parser_;
    Query ray_alone_;
};

}  // namespace reference::cast
