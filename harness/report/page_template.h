// Pages from Mustache templates, and the policy that keeps them to themselves.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace harness::report {

/// What a template is filled in with. {{name}} is escaped for HTML, control bytes and invalid UTF-8 made visible;
/// {{{name}}} is put in as it is, for markup of ours alone. A {{#name}} that is an empty string counts as there: leave
/// such a name out.
using PageData = kainjow::mustache::data;

class PageTemplate {
  public:
    /// Throws std::logic_error: a template that is no template is our own mistake.
    explicit PageTemplate(std::string_view text);

    std::string fill_in(const PageData& data);

  private:
    kainjow::mustache::mustache mustache_;
};

/// Sets `name` to `text` where there is one.
void set_text(PageData& data, const char* name, const std::string& text);

/// The beginning of every page of raygrade's, by which it knows them again: up to and with <html …>.
inline constexpr std::string_view page_beginning = "<!DOCTYPE html>\n<!-- a page of raygrade -->\n<html lang=\"en\">\n";

/// The Content-Security-Policy of a page that may do nothing but show itself: its one script (none when empty) and its
/// <style> elements are let through by their hashes, nothing is loaded from anywhere. For the content of a <meta>.
std::string security_policy(const std::vector<std::string_view>& styles, std::string_view script = {});

}  // namespace harness::report
