// Fills Mustache templates, and makes the pages' Content-Security-Policy.
#pragma once

#include <kainjow/mustache.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace harness::report {

/// The values for a template. {{name}} is escaped for HTML, with control bytes and invalid UTF-8 made visible;
/// {{{name}}} is inserted unchanged, so only for raygrade's own markup. {{#name}} treats an empty string as present, so
/// leave out a name without a value.
using PageData = kainjow::mustache::data;

class PageTemplate {
  public:
    /// Throws std::logic_error if the template is invalid, which is a bug in raygrade.
    explicit PageTemplate(std::string_view text);

    std::string fill_in(const PageData& data);

  private:
    kainjow::mustache::mustache mustache_;
};

/// Sets `name` to `text` unless the text is empty.
void set_text(PageData& data, const char* name, const std::string& text);

/// A list with one entry per thing. `fill_in(entry, thing)` fills in each entry.
template <class Things, class FillIn>
PageData list_of(const Things& things, const FillIn& fill_in) {
    PageData list(PageData::type::list);
    for (const auto& thing : things) {
        PageData entry;
        fill_in(entry, thing);
        list.push_back(entry);
    }
    return list;
}

/// The beginning of every raygrade page, up to and including <html …>. raygrade recognizes its pages by it.
inline constexpr std::string_view page_beginning = "<!DOCTYPE html>\n<!-- a page of raygrade -->\n<html lang=\"en\">\n";

/// A source expression for a Content-Security-Policy, with a leading blank. It allows the script or style with this
/// content. Throws HarnessError.
std::string hash_source(std::string_view content);

/// A page's Content-Security-Policy, for the content of a <meta>: it allows the page's script (none if empty) and its
/// <style> elements by their hashes, and forbids loading anything.
std::string security_policy(const std::vector<std::string_view>& styles, std::string_view script = {});

}  // namespace harness::report
