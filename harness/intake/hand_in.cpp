#include "harness/intake/hand_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "harness/intake/archive_contents.h"
#include "harness/machine/errors.h"
#include "harness/text/lower_case.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

using std::filesystem::path;
using File = HandIn::File;

constexpr const char* hand_in_one = " Hand in one file named ray_cast.cpp.";

std::vector<std::string> names_of(const std::vector<File>& files) {
    std::vector<std::string> names;
    for (const File& file : files) names.push_back(file.name);
    return names;
}

/// Compares Canvas's numbers, which may have any length.
bool is_smaller(const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
}

bool is_older(const File& a, const File& b) {
    const long of_a = read_base_name(a.name).turn;
    const long of_b = read_base_name(b.name).turn;
    return of_a != of_b ? of_a < of_b : is_smaller(a.attachment, b.attachment);
}

/// Returns the newest file of each name and notes the older ones.
std::vector<File> newest(const std::vector<File>& files, std::vector<std::string>& notes) {
    std::map<std::string, std::vector<File>> by_name;
    for (const File& file : files) by_name[read_base_name(file.name).name].push_back(file);
    std::vector<File> result;
    for (auto& [name, turns] : by_name) {
        std::stable_sort(turns.begin(), turns.end(), is_older);
        result.push_back(turns.back());
        turns.pop_back();
        if (turns.empty()) continue;
        notes.push_back("Handed in more than once: " + in_quotes(result.back().name) + " counts, not " +
                        list_of(names_of(turns)) + '.');
    }
    return result;
}

/// The files that remain after checking names and places; a single one if it is clear which file is graded.
std::vector<File> candidates(std::vector<File> files, std::vector<std::string>& notes,
                             std::vector<std::string>& others) {
    const auto keep = [&](const auto& wanted) {
        const auto rest = std::stable_partition(files.begin(), files.end(), wanted);
        if (rest == files.begin()) return;
        for (auto file = rest; file != files.end(); ++file) others.push_back(file->name);
        files.erase(rest, files.end());
    };
    const auto depth = [](const File& file) { return std::count(file.name.begin(), file.name.end(), '/'); };
    keep([](const File& file) { return is_called_ray_cast(file.name); });
    const auto least = depth(*std::ranges::min_element(files, {}, depth));
    keep([&](const File& file) { return depth(file) == least; });
    return newest(files, notes);
}

/// Whether the folder's name and content show that the student wrote none of its sources.
bool is_of_a_tool(const path& folder, const Contents& contents) {
    const std::string name = lower_case(folder.filename().native());
    const auto has = [](const std::vector<path>& files, const char* wanted) {
        return std::ranges::any_of(files, [&](const path& file) { return file.filename() == wanted; });
    };
    return name == "cmakefiles" || name == "_deps" || (name == "glm" && has(contents.headers, "glm.hpp")) ||
           (name.starts_with("glm") && has(contents.folders, "test"));
}

void add_files(const FileTree& tree, const path& folder, const path& root, bool is_of_tool, HandIn& hand_in) {
    const Contents contents = tree.list(folder);
    if (contents.error == std::errc::permission_denied) {
        hand_in.unreadable =
            "Cannot open the folder " + in_quotes(folder.filename()) + ". Make it readable: chmod u+rx.";
    } else if (contents.error) {
        hand_in.unreadable =
            "Cannot list the folder " + in_quotes(folder.filename()) + ": " + contents.error.message() + '.';
    }
    is_of_tool = is_of_tool || (folder != root && is_of_a_tool(folder, contents));
    const auto name = [&](const path& file) { return file.native().substr((root / "").native().size()); };
    for (const path& file : contents.sources) {
        if (!is_of_tool || is_called_ray_cast(file)) hand_in.sources.push_back({file, name(file), {}});
    }
    if (!is_of_tool) {
        for (const path& file : contents.archives) hand_in.archives.push_back({file, name(file), {}});
        std::ranges::transform(contents.headers, std::back_inserter(hand_in.headers), name);
        for (const auto* files : {&contents.others, &contents.linked})
            std::ranges::transform(*files, std::back_inserter(hand_in.others), name);
    }
    for (const path& inner : contents.folders) add_files(tree, inner, root, is_of_tool, hand_in);
}

/// Whether the name of a source has the ending of another kind of file: "ray_cast.cpp.txt", "main.c++".
bool is_misnamed(const std::string& name) {
    const std::string small = lower_case(name), ending = path(small).extension();
    constexpr std::array other_endings = {".c", ".c++", ".cp"};
    return std::ranges::find(other_endings, ending) != other_endings.end() ||
           ((ending.empty() || ending == ".txt") &&
            (path(small).stem() == "ray_cast" || small.find(".cpp") != std::string::npos));
}

std::string why_without_source(const HandIn& hand_in) {
    if (!hand_in.unreadable.empty()) return hand_in.unreadable;
    std::vector<std::string> names = hand_in.others;
    names.insert(names.end(), hand_in.headers.begin(), hand_in.headers.end());
    if (names.empty()) return "There is no file." + std::string(hand_in_one);
    std::string why = "There is " + list_of(names) +
                      ", but no C++ source (.cpp, .cc or .cxx) and no archive that raygrade opens (.zip, .tar, .tar.gz "
                      "or .tgz, not inside another archive).";
    for (const std::string& name : names) {
        if (is_misnamed(name)) return why + " Rename " + in_quotes(name) + " to ray_cast.cpp.";
    }
    return why + hand_in_one;
}

/// Takes the submission from a student's archive.
Submission take_packed(const FileTree& tree, const path& archive, std::string id) {
    try {
        const auto inside = tree.open(archive);
        HandIn packed;
        packed.add_all_in(*inside, archive);
        for (const File& inner : packed.archives) packed.others.push_back(inner.name);
        packed.archives.clear();
        return take(*inside, packed, std::move(id));
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

void HandIn::add_all_in(const FileTree& tree, const path& folder) {
    add_files(tree, folder, folder, /*is_of_tool=*/false, *this);
}

bool may_be_hand_in(const path& file) {
    constexpr std::array packed = {".rar", ".7z", ".zipx", ".gz", ".bz2", ".tbz2", ".xz", ".txz", ".zst"};
    const std::string ending = lower_case(file.extension().native());
    return std::ranges::find(packed, ending) != packed.end() || is_misnamed(file.filename());
}

bool is_called_ray_cast(const path& file) {
    return lower_case(path(read_base_name(file.filename().native()).name).stem().native()) == "ray_cast";
}

Submission take(const FileTree& tree, const HandIn& hand_in, std::string id) {
    if (hand_in.is_without_source()) return with_problem(std::move(id), why_without_source(hand_in));
    const bool is_packed = hand_in.sources.empty();
    std::vector<std::string> notes, others;
    const std::vector<File> chosen = candidates(is_packed ? hand_in.archives : hand_in.sources, notes, others);
    Submission submission;
    if (chosen.size() > 1) {
        submission =
            with_problem(std::move(id), "It is not clear which of these files to grade: " + list_of(names_of(chosen)) +
                                            '.' + hand_in_one);
    } else if (is_packed) {
        submission = take_packed(tree, chosen.front().file, std::move(id));
    } else {
        submission.id = std::move(id);
        submission.file = chosen.front().file;
        tree.read(submission, Links::refuse);
        for (const File& archive : hand_in.archives) others.push_back(archive.name);
    }
    const std::string name = in_quotes(chosen.front().name);
    if (chosen.size() == 1 && !others.empty())
        notes.push_back("Only " + name + " is graded, not " + list_of(others) + '.');
    if (chosen.size() == 1 && !is_packed && !hand_in.headers.empty())
        notes.push_back("Only " + name + " is compiled, without " + list_of(hand_in.headers) + '.');
    submission.notes.insert(submission.notes.begin(), notes.begin(), notes.end());
    return submission;
}

}  // namespace harness
