#include "harness/intake/lms/gradescope_metadata.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <utility>

#include "harness/text/printable.h"

namespace harness {
namespace {

constexpr std::size_t most_submissions = 20'000;  // ArchiveLimits::entries
constexpr std::size_t most_submitters = 50;
constexpr std::size_t longest_text = 200;  // bytes of a name

/// Thrown to skip one submission; the message follows the submission's name.
struct Unusable {
    std::string why;
};

std::string without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return "";
    return std::string(text.substr(first, text.find_last_not_of(blanks) + 1 - first));
}

/// A key without Ruby's colon; empty if it is not text.
std::string key_text(const YAML::Node& key) {
    const std::string text = key.IsScalar() ? key.Scalar() : "";
    return text.starts_with(':') ? text.substr(1) : text;
}

/// The value of a key in a mapping; null if there is none. Throws Unusable if there are several.
YAML::Node value_of(const YAML::Node& mapping, std::string_view key) {
    std::optional<YAML::Node> found;
    for (const auto& pair : mapping) {
        if (key_text(pair.first) != key) continue;
        if (found) throw Unusable{"names its students twice"};
        found.emplace(pair.second);
    }
    return found ? *found : YAML::Node();
}

std::string part_of(const YAML::Node& submitter, std::string_view key) {
    const YAML::Node value = value_of(submitter, key);
    if (value.IsNull()) return "";
    const std::string text = value.IsScalar() ? value.Scalar() : "\n";
    if (text.size() > longest_text) throw Unusable{"has a name of more than 200 bytes"};
    if (printable(text) != text) throw Unusable{"has a name that is not text"};
    return without_blanks(text);
}

std::vector<Submitter> submitters_of(const YAML::Node& submission) {
    const YAML::Node list = submission.IsMap() ? value_of(submission, "submitters") : YAML::Node();
    if (!list.IsSequence()) throw Unusable{"does not name its students"};
    if (list.size() > most_submitters) throw Unusable{"names more than 50 students for it"};
    std::vector<Submitter> submitters;
    for (const YAML::Node& node : list) {
        if (node.IsMap()) submitters.push_back({part_of(node, "name"), part_of(node, "sid"), part_of(node, "email")});
    }
    const bool are_all_named =
        std::ranges::none_of(submitters, [](const Submitter& submitter) { return submitter.name.empty(); });
    if (submitters.empty() || submitters.size() < list.size() || !are_all_named)
        throw Unusable{"does not name its students"};
    return submitters;
}

}  // namespace

GradescopeMetadata read_gradescope_metadata(std::string_view yaml) {
    YAML::Node submissions;
    try {
        submissions.reset(YAML::Load(std::string(yaml)));
    } catch (const YAML::Exception& error) {
        return {{}, {}, {}, fmt::format("is not YAML from line {} on", error.mark.line + 1)};
    }
    if (submissions.IsNull()) return {{}, {}, {}, "is empty"};
    if (!submissions.IsMap()) return {{}, {}, {}, "contains no submissions"};
    if (submissions.size() > most_submissions) return {{}, {}, {}, "has more than 20,000 submissions"};
    GradescopeMetadata metadata;
    for (const auto& pair : submissions) {
        const std::string folder = key_text(pair.first);
        if (metadata.submitters.erase(folder) > 0 || metadata.problems.contains(folder)) {
            metadata.problems.try_emplace(folder, "mentions it twice");
            continue;
        }
        try {
            std::vector<Submitter> submitters = submitters_of(pair.second);
            const YAML::Node when = value_of(pair.second, "created_at");
            metadata.submitters.emplace(folder, std::move(submitters));
            if (when.IsScalar()) metadata.created_at.emplace(folder, when.Scalar());
        } catch (const Unusable& unusable) {
            metadata.problems.emplace(folder, unusable.why);
        }
    }
    return metadata;
}

std::string names_of(const std::vector<Submitter>& submitters) {
    std::string names;
    for (const Submitter& submitter : submitters) names += (names.empty() ? "" : ", ") + submitter.name;
    return names;
}

}  // namespace harness
