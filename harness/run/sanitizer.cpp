#include "harness/run/sanitizer.h"

#include <algorithm>

namespace harness {
namespace {

constexpr std::size_t most = 20;
constexpr std::size_t longest = 300;
constexpr std::string_view undefined = ": runtime error: ";
constexpr std::string_view address = "ERROR: AddressSanitizer: ";
constexpr std::string_view source = "ray_cast.cpp:";

void add(std::vector<std::string>& findings, std::string finding) {
    if (findings.size() >= most || std::find(findings.begin(), findings.end(), finding) != findings.end()) return;
    findings.push_back(std::move(finding));
}

/// Replaces each address by "0x…".
std::string without_addresses(std::string_view line) {
    std::string text;
    for (std::size_t i = 0; i < line.size() && text.size() < longest;) {
        if (line.substr(i, 2) == "0x") {
            text += "0x…";
            i = std::min(line.find_first_not_of("0123456789abcdef", i + 2), line.size());
        } else {
            text += line[i++];
        }
    }
    return text;
}

/// The line number after "ray_cast.cpp:"; empty if there is none.
std::string_view line_number(std::string_view frame) {
    const std::size_t found = frame.find(source);
    if (found == std::string_view::npos) return {};
    frame.remove_prefix(found + source.size());
    return frame.substr(0, std::min<std::size_t>(frame.find_first_not_of("0123456789"), 9));
}

}  // namespace

std::vector<std::string> sanitizer_flags() {
    // Statically linked, AddressSanitizer accepts the line buffer before it; without /proc, no option can allow this.
    return {"-fsanitize=address,undefined", "-static-libasan", "-fno-omit-frame-pointer", "-g"};
}

std::vector<std::string> sanitizer_environment() {
    // Leaks do not matter in a ray caster, and detecting them needs ptrace, which the sandbox forbids.
    return {"ASAN_OPTIONS=detect_leaks=0:color=never", "UBSAN_OPTIONS=print_stacktrace=0:color=never"};
}

Limits sanitizer_limits(Limits limits) {
    constexpr int slower = 5;
    limits.cpu *= slower;
    limits.wall *= slower;
    limits.memory_bytes += std::uint64_t{1} << 30;
    return limits;
}

std::vector<std::string> sanitizer_findings(std::string_view errors) {
    std::vector<std::string> findings;
    std::string kind;  // of the AddressSanitizer finding whose line was not read yet
    while (!errors.empty()) {
        const std::size_t end = std::min(errors.find('\n'), errors.size());
        const std::string_view line = errors.substr(0, end);
        errors.remove_prefix(std::min(end + 1, errors.size()));
        if (line.find(undefined) != std::string_view::npos) add(findings, without_addresses(line));
        if (const std::size_t found = line.find(address); found != std::string_view::npos) {
            const std::string_view what = line.substr(found + address.size());
            kind = without_addresses(what.substr(0, what.find(' ')));
        } else if (!kind.empty()) {
            const std::string_view number = line_number(line);
            // The summary follows the stack, so a finding that is still open here has no line in the student's source.
            const bool last = line.find("SUMMARY: ") != std::string_view::npos;
            if (number.empty() && !last) continue;
            add(findings, number.empty() ? kind : "line " + std::string(number) + ": " + kind);
            kind.clear();
        }
    }
    if (!kind.empty()) add(findings, kind);
    return findings;
}

}  // namespace harness
