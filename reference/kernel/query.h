// One query of `raygrade cast`, read from its line. The only file that knows the JSON parser is query.cpp.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/kernel/first.h"

namespace reference {

struct CastQuery {
    kernel::Ray<double> ray;
    kernel::Objects objects;
};

/// The line is not a valid query; what() says why.
class MalformedQuery : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class CastQueryReader {
  public:
    CastQueryReader();
    ~CastQueryReader();
    CastQueryReader(const CastQueryReader&) = delete;
    CastQueryReader& operator=(const CastQueryReader&) = delete;

    /// Overwrites `query`, whose memory is reused from line to line. Throws MalformedQuery.
    void read(const std::string& line, CastQuery& query);

  private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

}  // namespace reference
