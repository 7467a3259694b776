#include "tests/scenario/served/answers.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>
#include <set>

namespace scenario {
namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

bool has_control_bytes(std::string_view text) {
    return std::any_of(text.begin(), text.end(),
                       [](unsigned char c) { return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f; });
}

bool is_utf8(const std::string& text) {
    try {
        return !nlohmann::json(text).dump().empty();
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

/// Takes the next answer from the front of `rest`. False if it is not whole.
bool take(std::string_view& rest, bool to_head, Answer& answer) {
    const auto end = rest.find("\r\n\r\n");
    if (end == std::string_view::npos) return false;
    std::string_view head = rest.substr(0, end + 2);
    rest.remove_prefix(end + 4);
    if (!head.starts_with("HTTP/1.1 ") && !head.starts_with("HTTP/1.0 ")) return false;
    head.remove_prefix(9);
    const char* const digits_end = std::from_chars(head.data(), head.data() + head.size(), answer.status).ptr;
    if (digits_end != head.data() + 3) return false;
    for (head.remove_prefix(head.find("\r\n") + 2); !head.empty(); head.remove_prefix(head.find("\r\n") + 2)) {
        const std::string_view line = head.substr(0, head.find("\r\n"));
        const auto colon = line.find(": ");
        if (colon == std::string_view::npos || has_control_bytes(line)) return false;
        const std::string name = lower(std::string(line.substr(0, colon)));
        if (!answer.fields.try_emplace(name, line.substr(colon + 2)).second) return false;
    }
    if (answer.status == 100 || to_head) return true;
    const auto length = answer.fields.find("content-length");
    const std::size_t size = length == answer.fields.end() ? rest.size() : std::stoul(length->second);
    if (rest.size() < size) return false;
    answer.body = rest.substr(0, size);
    rest.remove_prefix(size);
    return true;
}

}  // namespace

Answers answers_in(std::string_view received, bool to_head) {
    Answers answers;
    while (!received.empty()) {
        Answer answer;
        if (!take(received, to_head, answer)) {
            answers.problem = "no whole answer: " + std::string(received.substr(0, 200));
            break;
        }
        answers.all.push_back(std::move(answer));
    }
    return answers;
}

std::string told(std::string_view received, const std::vector<std::string>& secrets) {
    const auto found = std::find_if(secrets.begin(), secrets.end(), [&](const std::string& secret) {
        return received.find(secret) != std::string_view::npos;
    });
    return found == secrets.end() ? "" : *found;
}

std::string wrong_with(const Answer& answer) {
    static const std::set<std::string> known = {"allow",
                                                "cache-control",
                                                "connection",
                                                "content-length",
                                                "content-type",
                                                "content-security-policy",
                                                "location",
                                                "retry-after",
                                                "referrer-policy",
                                                "x-content-type-options",
                                                "cross-origin-opener-policy",
                                                "cross-origin-resource-policy"};
    if (answer.status == 100) return "";
    for (const auto& [name, value] : answer.fields) {
        if (!known.contains(name)) return "a field that the server does not set: " + name + ": " + value;
    }
    const auto field = [&](const char* name) {
        const auto found = answer.fields.find(name);
        return found == answer.fields.end() ? "" : found->second;
    };
    if (field("x-content-type-options") != "nosniff" || field("cache-control") != "no-store")
        return "a field is missing";
    if (field("content-security-policy").find("default-src 'none'") == std::string::npos) return "no policy";
    if (field("content-type") == "application/json" || answer.body.empty()) return "";
    // The site's own script has a source, and no page has an image.
    for (const char* raw : {"<script>", "<script&", "<script%", "<img", "<<<<"}) {
        if (answer.body.find(raw) != std::string::npos) return std::string("not escaped: ") + raw;
    }
    if (has_control_bytes(answer.body)) return "control bytes";
    return is_utf8(answer.body) ? "" : "no UTF-8";
}

std::string wrong_with(const std::string& received, const harness::serve::HostileRequest& attack,
                       const std::vector<std::string>& secrets) {
    if (const std::string secret = told(received, secrets); !secret.empty()) return "tells " + secret;
    const Answers answers = answers_in(received, attack.is_to_head);
    if (!answers.problem.empty() && !(attack.is_damaged && attack.is_to_head)) return answers.problem;
    if (!attack.is_damaged) {
        if (answers.all.empty() && !attack.statuses.contains(0)) return "no answer";
        if (answers.all.size() > attack.most_answers) return std::to_string(answers.all.size()) + " answers";
    }
    for (const Answer& answer : answers.all) {
        const bool is_right = attack.is_damaged ? answer.status < 500 : attack.statuses.contains(answer.status);
        if (!is_right) return "answered " + std::to_string(answer.status);
        if (std::string wrong = wrong_with(answer); !wrong.empty()) return wrong;
    }
    return "";
}

}  // namespace scenario
