#include "harness/intake/hand_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "harness/intake/archive_contents.h"
#include "harness/machine/errors.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

using std::filesystem::path;
using Source = HandIn::Source;

std::string list_of_files(const std::vector<path>& files) {
    std::vector<std::string> names;
    for (const path& file : files) names.push_back(file.filename());
    return list_of(names);
}

/// Compares Canvas's numbers, which may have any length.
bool is_smaller(const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
}

bool is_older(const Source& a, const Source& b) {
    const long of_a = read_base_name(a.name).turn;
    const long of_b = read_base_name(b.name).turn;
    return of_a != of_b ? of_a < of_b : is_smaller(a.attachment, b.attachment);
}

/// Returns the newest source of each name and notes the older ones.
std::vector<Source> newest(const std::vector<Source>& sources, std::vector<std::string>& notes) {
    std::map<std::string, std::vector<Source>> by_name;
    for (const Source& source : sources) by_name[read_base_name(source.name).name].push_back(source);
    std::vector<Source> result;
    for (auto& [name, turns] : by_name) {
        std::stable_sort(turns.begin(), turns.end(), is_older);
        result.push_back(turns.back());
        turns.pop_back();
        if (turns.empty()) continue;
        std::vector<std::string> older;
        for (const Source& turn : turns) older.push_back(turn.name);
        notes.push_back("Handed in again: " + in_quotes(result.back().name) + " counts, not " + list_of(older) + '.');
    }
    return result;
}

void add_all_below(const FileTree& tree, const path& folder, HandIn& hand_in, int depth) {
    const Contents contents = tree.list(folder);
    hand_in.add(contents);
    if (depth == 0) return;
    for (const path& inner : contents.folders) add_all_below(tree, inner, hand_in, depth - 1);
}

/// Takes the submission from a student's archive. The sources may lie anywhere in it.
Submission take_packed(const FileTree& tree, const HandIn& hand_in, std::string id, const std::string& where) {
    if (hand_in.archives.size() > 1) {
        return with_problem(std::move(id), where + " holds several archives and no C++ source: " +
                                               list_of_files(hand_in.archives) + ". Keep the one to be graded.");
    }
    const path& archive = hand_in.archives.front();
    try {
        const auto inside = tree.open(archive);
        HandIn packed;
        constexpr int deepest = 8;
        add_all_below(*inside, archive, packed, deepest);
        packed.archives.clear();
        if (packed.sources.empty()) {
            return with_problem(std::move(id), in_quotes(archive) + " holds no C++ source (.cpp, .cc or .cxx).");
        }
        return take(*inside, packed, std::move(id), in_quotes(archive));
    } catch (const ArchiveError& error) {
        return with_problem(std::move(id), error.what());
    } catch (const HarnessError& error) {
        return with_problem(std::move(id), error.what());
    }
}

}  // namespace

std::string list_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += (i == 0 ? "" : ", ") + in_quotes(names[i]);
    return names.size() <= most ? text : text + fmt::format(" and {} more", names.size() - most);
}

Submission with_problem(std::string id, std::string problem) {
    Submission submission;
    submission.id = std::move(id);
    submission.problem = std::move(problem);
    return submission;
}

void HandIn::add(const Contents& contents) {
    for (const path& file : contents.sources) sources.push_back({file, file.filename(), {}});
    archives.insert(archives.end(), contents.archives.begin(), contents.archives.end());
    headers.insert(headers.end(), contents.headers.begin(), contents.headers.end());
    others.insert(others.end(), contents.others.begin(), contents.others.end());
}

bool is_called_ray_cast(const path& file) {
    return path(read_base_name(file.filename().native()).name).stem() == "ray_cast";
}

Submission take(const FileTree& tree, const HandIn& hand_in, std::string id, const std::string& where) {
    if (hand_in.sources.empty()) return take_packed(tree, hand_in, std::move(id), where);
    std::vector<std::string> notes;
    const std::vector<Source> sources = newest(hand_in.sources, notes);
    auto chosen = sources.begin();
    std::vector<std::string> others;
    if (sources.size() > 1) {
        chosen =
            std::find_if(sources.begin(), sources.end(), [](const Source& s) { return is_called_ray_cast(s.name); });
        for (auto source = sources.begin(); source != sources.end(); ++source) {
            if (source != chosen) others.push_back(source->name);
        }
        if (chosen == sources.end()) {
            Submission unclear =
                with_problem(std::move(id), where + " holds several sources: " + list_of(others) +
                                                ". Keep the one to be graded, or call it ray_cast.cpp.");
            unclear.notes = std::move(notes);
            return unclear;
        }
    }
    Submission submission;
    submission.id = std::move(id);
    submission.file = chosen->file;
    tree.read(submission, Links::refuse);
    const std::string name = in_quotes(chosen->name);
    if (!others.empty()) notes.push_back("Only " + name + " is graded; not " + list_of(others) + '.');
    if (!hand_in.headers.empty()) {
        notes.push_back("Only " + name + " is compiled, without " + list_of_files(hand_in.headers) + '.');
    }
    submission.notes = std::move(notes);
    return submission;
}

}  // namespace harness
