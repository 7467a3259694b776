#include "harness/report/page/page_template.h"

#include <fmt/format.h>
#include <sodium.h>

#include <stdexcept>

#include "harness/machine/hash.h"
#include "harness/text/markup.h"

namespace harness::report {

std::string hash_source(std::string_view content) {
    const auto hash = sha256(content);
    std::string base64(sodium_base64_ENCODED_LEN(hash.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
    sodium_bin2base64(base64.data(), base64.size(), hash.data(), hash.size(), sodium_base64_VARIANT_ORIGINAL);
    base64.pop_back();  // the terminating zero
    return fmt::format(" 'sha256-{}'", base64);
}

PageTemplate::PageTemplate(std::string_view text) : mustache_(std::string(text)) {
    if (!mustache_.is_valid()) throw std::logic_error("a page's template: " + mustache_.error_message());
    mustache_.set_custom_escape([](const std::string& value) { return escape_markup(value); });
}

std::string PageTemplate::fill_in(const PageData& data) {
    std::string page;
    mustache_.render(data, [&page](const std::string& part) { page += part; });
    return page;
}

void set_text(PageData& data, const char* name, const std::string& text) {
    if (!text.empty()) data[name] = text;
}

std::string security_policy(const std::vector<std::string_view>& styles, std::string_view script) {
    std::string policy = "default-src 'none'; style-src";
    for (const std::string_view style : styles) policy += hash_source(style);
    if (!script.empty()) policy += "; script-src" + hash_source(script);
    return policy + "; base-uri 'none'; form-action 'none'";
}

}  // namespace harness::report
