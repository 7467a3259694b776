// Parses the forms of the review's pages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace harness::review {

/// The fields of a form, in order.
class FormFields {
  public:
    explicit FormFields(std::vector<std::pair<std::string, std::string>> fields) : fields_(std::move(fields)) {}

    /// The first value of the field; empty if it is not there.
    std::string value(std::string_view name) const;
    std::vector<std::string> values(std::string_view name) const;
    bool has(std::string_view name) const { return !values(name).empty(); }
    const std::vector<std::pair<std::string, std::string>>& all() const { return fields_; }

  private:
    std::vector<std::pair<std::string, std::string>> fields_;
};

/// Reads application/x-www-form-urlencoded, as browsers write it (URL standard, section 5.1). Empty for another type, a
/// malformed body, or more fields than any form of the review has.
std::optional<FormFields> read_form(std::string_view content_type, std::string_view body);

}  // namespace harness::review
