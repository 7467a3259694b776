#include <algorithm>
#include <set>
#include <vector>

#include "harness/intake/lms/gradescope_metadata.h"
#include "harness/text/printable.h"
#include "tests/fuzz/properties.h"

namespace {

using harness::GradescopeMetadata;
using harness::Submitter;

constexpr std::size_t longest_name = 200;
constexpr std::size_t most_submitters = 50;

/// Whether Gradescope may write it as a name.
bool is_name(std::string_view text) {
    return !text.empty() && text.size() <= longest_name && harness::printable(text) == text && text.front() != ' ' &&
           text.back() != ' ';
}

bool is_same(const Submitter& one, const Submitter& other) {
    return one.name == other.name && one.sid == other.sid && one.email == other.email;
}

bool is_same(const GradescopeMetadata& one, const GradescopeMetadata& other) {
    const auto same = [](const auto& a, const auto& b) {
        return a.first == b.first && std::equal(a.second.begin(), a.second.end(), b.second.begin(), b.second.end(),
                                                [](const Submitter& x, const Submitter& y) { return is_same(x, y); });
    };
    return one.problem == other.problem && one.problems == other.problems &&
           std::equal(one.submitters.begin(), one.submitters.end(), other.submitters.begin(), other.submitters.end(),
                      same);
}

std::string check_read(const GradescopeMetadata& read) {
    if (read.problem && (!read.submitters.empty() || !read.problems.empty())) return "names from an unusable file";
    if (read.problem && read.problem->empty()) return "a problem without a reason";
    for (const auto& [folder, why] : read.problems) {
        if (why.empty()) return "a problem without a reason";
        if (read.submitters.contains(folder)) return "names in spite of a problem";
    }
    for (const auto& [folder, submitters] : read.submitters) {
        if (submitters.empty() || submitters.size() > most_submitters) return "a submission of nobody, or of too many";
        for (const Submitter& one : submitters) {
            if (!is_name(one.name)) return "a submitter whose name is none: " + one.name;
            if (!one.sid.empty() && !is_name(one.sid)) return "a number of a student that is no text: " + one.sid;
            if (!one.email.empty() && !is_name(one.email)) return "an address that is no text: " + one.email;
        }
    }
    return {};
}

std::string in_double_quotes(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}

/// Writes a class whose students have these names, as Gradescope does, and reads it back.
std::string check_written(const std::vector<std::string>& names) {
    std::string yaml = "---\n";
    GradescopeMetadata given;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string folder = "submission_" + std::to_string(i);
        // The second student of a group is the one before.
        const std::string other = i == 0 ? "Jane Doe" : names[i - 1];
        given.submitters[folder] = {{names[i], "17", ""}, {other, "", names[i]}};
        yaml += folder + ":\n  :submitters:\n  - :name: " + in_double_quotes(names[i]) +
                "\n    :sid: '17'\n  - :name: " + in_double_quotes(other) +
                "\n    :email: " + in_double_quotes(names[i]) + "\n  :score: 1.0\n";
    }
    if (names.empty()) return {};
    const GradescopeMetadata read = harness::read_gradescope_metadata(yaml);
    return is_same(read, given) ? "" : "a class is read otherwise than it was written: " + yaml;
}

}  // namespace

std::string check_metadata(std::string_view yaml) {
    const GradescopeMetadata read = harness::read_gradescope_metadata(yaml);
    if (std::string broken = check_read(read); !broken.empty()) return broken;
    if (!is_same(read, harness::read_gradescope_metadata(yaml))) return "it is read differently the second time";
    std::vector<std::string> names;
    while (!yaml.empty() && names.size() < 20) {
        const std::string_view line = yaml.substr(0, yaml.find('\n'));
        yaml.remove_prefix(std::min(yaml.size(), line.size() + 1));
        if (is_name(line)) names.emplace_back(line);
    }
    return check_written(names);
}
