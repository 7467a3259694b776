// A page as a reader that knows nothing of our writers reads it: Python's.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace report_samples {

/// What tests/report/read_page.py says of a page; fails the test when it can't be read.
nlohmann::json read_page(const std::string& page);

/// The same of a Markdown page, as cmark makes HTML of it, with whatever elements are in it.
nlohmann::json read_markdown(const std::string& page);

/// Whether xmllint takes it for well-formed XML; its complaints otherwise.
std::string xml_problems(const std::string& page);

}  // namespace report_samples
