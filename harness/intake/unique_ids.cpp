#include "harness/intake/unique_ids.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "harness/intake/source_file.h"
#include "harness/text/encoding.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

/// Joins the last `count` names of the path of `one`, or all if there are fewer. Leaves out the name that the id came
/// from.
std::string last_names(const Taken& taken, std::size_t count) {
    std::vector<std::string> names;
    for (const auto& name : std::filesystem::absolute(taken.from).lexically_normal()) {
        if (!name.empty() && name != "/") names.push_back(printable(name.native()));
    }
    while (!names.empty() && (names.back() == taken.id || is_source_name(names.back()))) names.pop_back();
    std::string text;
    for (std::size_t i = names.size() - std::min(count, names.size()); i < names.size(); ++i) text += names[i] + '-';
    return text;
}

std::map<std::string, int> count_ids(const std::vector<Taken>& all) {
    std::map<std::string, int> counts;
    for (const auto& one : all) ++counts[one.submission.id];
    return counts;
}

/// Two sources of one folder that differ only in their ending, doe.cc and doe.cpp, get their whole names as ids: a file
/// that comes later must not take the id of an earlier one.
void use_whole_names(std::vector<Taken>& all) {
    std::map<std::filesystem::path, std::set<std::filesystem::path>> files;  // by their names without ".cpp"
    const auto without_extension = [](const Taken& taken) {
        return taken.submission.file.parent_path() / taken.submission.file.stem();
    };
    for (const auto& one : all) files[without_extension(one)].insert(one.submission.file);
    for (auto& one : all) {
        const std::filesystem::path& file = one.submission.file;
        if (files.at(without_extension(one)).size() > 1 && printable(file.stem().native()) == one.id)
            one.submission.id = one.id = printable(file.filename().native());
    }
}

void make_ids_unique(std::vector<Taken>& all) {
    use_whole_names(all);
    constexpr std::size_t enough_names = 4;
    for (std::size_t names = 1; names <= enough_names; ++names) {
        const auto counts = count_ids(all);
        for (auto& one : all) {
            if (counts.at(one.submission.id) > 1) one.submission.id = last_names(one, names) + one.id;
        }
    }
    const auto counts = count_ids(all);
    std::set<std::string> used;
    for (auto& one : all) {
        if (counts.at(one.submission.id) > 1) one.submission.id = one.id;
        const std::string id = one.submission.id;
        for (int i = 2; !used.insert(one.submission.id).second; ++i) one.submission.id = id + '-' + std::to_string(i);
    }
}

}  // namespace

std::vector<Submission> with_unique_ids(std::vector<Taken> all) {
    for (Taken& one : all) one.submission.id = one.id = composed_name(one.submission.id);
    make_ids_unique(all);
    std::vector<Submission> submissions;
    for (auto& one : all) submissions.push_back(std::move(one.submission));
    return submissions;
}

}  // namespace harness
