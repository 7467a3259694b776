// Reads a page with independent readers: Python's HTML parser, cmark and xmllint.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace report_samples {

/// What tests/given/report/read_page.py reports on a page. Fails the test if the page can't be read.
nlohmann::json read_page(const std::string& page);

/// The same for the HTML that cmark makes of a Markdown page. HTML elements in the Markdown are kept.
nlohmann::json read_markdown(const std::string& page);

/// xmllint's complaints; "" if the page is well-formed XML.
std::string xml_problems(const std::string& page);

}  // namespace report_samples
