#include "harness/gradebook/changed_feedback.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "harness/gradebook/record.h"

namespace harness {
namespace {

using nlohmann::json;

/// A part of a record that exists only with an option.
struct Optional {
    const char* field;
    const char* part;
    const char* option;
};
constexpr Optional optional_parts[] = {{"other_scenes", "other scenes", "--variants"},
                                       {"stress", "hard scenes", "--stress"},
                                       {"sanitizer", "sanitizers' findings", "--sanitize"}};

constexpr std::pair<const char*, const char*> measured[] = {
    {"build", "ms"}, {"run", "cpu_ms"}, {"run", "wall_ms"}, {"run", "peak_memory_bytes"}};

PartChange& change_of(FeedbackChanges& changes, const std::string& part, const std::string& option) {
    const auto found = std::find_if(changes.parts.begin(), changes.parts.end(),
                                    [&](const PartChange& part_change) { return part_change.part == part; });
    if (found != changes.parts.end()) return *found;
    return changes.parts.emplace_back(PartChange{part, option});
}

/// Removes a field and returns its value; null if there is none.
json taken(json& record, const char* field) {
    const auto found = record.find(field);
    if (found == record.end()) return {};
    json value = std::move(*found);
    record.erase(found);
    return value;
}

/// The option that adds the flag; empty if no option does.
std::string option_of_flag(const std::string& kind) {
    if (kind == "nondeterministic") return "--repeat";
    return kind == "hard_coded" || kind == "variants_not_tried" ? "--variants" : "";
}

/// The flags by kind. A submission has at most one flag of each kind.
json flags_by_kind(const json& flags) {
    json by_kind = json::object();
    for (const json& flag : flags) by_kind[flag.at(0).get<std::string>()] = flag.at(1);
    return by_kind;
}

bool has_optional_parts(const Graded& graded) {
    return graded.findings.variants || graded.findings.hard_scenes || !graded.execution.sanitizer.empty() ||
           !graded.findings.flags.empty();
}

}  // namespace

void add_feedback(FeedbackChanges& changes, const Graded& before, const Graded& after, Marks marks) {
    if (marks == Marks::moved && !has_optional_parts(before) && !has_optional_parts(after)) return;
    json then = json::from_cbor(to_record(before));
    json now = json::from_cbor(to_record(after));
    if (before.submission.file.filename() == after.submission.file.filename())
        now["submission"]["file"] = then["submission"]["file"];    // students do not see the folders or the archive
    if (before.execution.compiler.empty()) now.erase("compiler");  // an older version did not record it
    bool differs = false;
    const auto compare = [&](const json& entry, const json& two, const std::string& part) {
        if (entry == two) return;
        differs = true;
        if (marks == Marks::same) ++change_of(changes, part, "").other;
    };
    const auto compare_optional = [&](const json& one, const json& two, const std::string& part,
                                      const std::string& option) {
        if (one.is_null() == two.is_null()) return compare(one, two, part);
        differs = true;
        PartChange& change = change_of(changes, part, option);
        ++(one.is_null() ? change.fresh : change.gone);
    };
    for (const Optional& optional : optional_parts)
        compare_optional(taken(then, optional.field), taken(now, optional.field), optional.part, optional.option);
    json flags_then = flags_by_kind(taken(then, "flags")), flags_now = flags_by_kind(taken(now, "flags"));
    json kinds = flags_then;
    kinds.update(flags_now);
    for (const auto& [kind, evidence] : kinds.items())
        compare_optional(taken(flags_then, kind.c_str()), taken(flags_now, kind.c_str()), "flag " + kind,
                         option_of_flag(kind));
    if (marks == Marks::moved) return;
    for (const auto& [group, field] : measured) {
        taken(then[group], field);
        taken(now[group], field);
    }
    compare(then, now, "other feedback");
    ++(differs ? changes.differing : changes.remeasured);
}

}  // namespace harness
