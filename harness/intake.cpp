#include "harness/intake.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include "harness/failure.h"
#include "harness/names.h"
#include "harness/source_file.h"

namespace harness {
namespace {

using std::filesystem::path;

/// What a folder holds, by what intake does with it. Links are never followed.
struct Contents {
    std::vector<path> sources;  ///< by name alone: files, but also links, pipes and folders called so
    std::vector<path> folders;
    std::vector<path> linked;  ///< symbolic links that are not called like a source
    std::vector<path> headers;
    std::error_code error;  ///< why it could not be listed
};

/// Results of raygrade's own, which lie in the class's folder when it was graded from there.
bool holds_results(const path& folder) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(folder / "grades.json", ignored) &&
           std::filesystem::is_directory(folder / "feedback", ignored);
}

Contents list(const path& folder) {
    Contents contents;
    std::filesystem::directory_iterator entry(folder, contents.error);
    for (; !contents.error && entry != std::filesystem::directory_iterator(); entry.increment(contents.error)) {
        const path name = entry->path().filename();
        if (name.native().starts_with('.')) continue;
        std::error_code ignored;
        const auto type = entry->symlink_status(ignored).type();
        const bool is_header = name.extension() == ".h" || name.extension() == ".hpp";
        if (type == std::filesystem::file_type::directory) {
            if (!holds_results(entry->path())) contents.folders.push_back(entry->path());
        } else if (is_source_name(name)) {
            contents.sources.push_back(entry->path());
        } else if (type == std::filesystem::file_type::symlink) {
            contents.linked.push_back(entry->path());
        } else if (is_header) {
            contents.headers.push_back(entry->path());
        }
    }
    for (auto* paths : {&contents.sources, &contents.folders, &contents.linked, &contents.headers}) {
        std::sort(paths->begin(), paths->end());
    }
    return contents;
}

bool is_called_ray_cast(const path& file) {
    return file.stem() == "ray_cast";
}

std::string names_of(const std::vector<path>& files) {
    std::string text;
    for (const auto& file : files) text += (text.empty() ? "" : ", ") + in_quotes(file.filename());
    return text;
}

/// The folder's own name, also for "." and for a path that ends in '/'.
std::string folder_id(const path& folder) {
    const path whole = std::filesystem::absolute(folder).lexically_normal();
    const path name = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    return name.empty() ? "root" : printable(name.native());
}

Submission with_problem(std::string id, std::string problem) {
    Submission submission;
    submission.id = std::move(id);
    submission.problem = std::move(problem);
    return submission;
}

Submission from_file(const path& file, std::string id, Links links) {
    Submission submission;
    submission.id = std::move(id);
    submission.file = file;
    read_source(submission, links);
    return submission;
}

std::string why_no_source(const path& folder, const Contents& contents) {
    const std::string where = in_quotes(folder);
    if (contents.error == std::errc::permission_denied) {
        return "Could not open the folder " + where + ". Make it readable: chmod u+rx.";
    }
    if (contents.error) return "Could not list the folder " + where + ": " + contents.error.message() + '.';
    for (const auto& inner : contents.folders) {
        const auto deeper = list(inner);
        if (deeper.sources.empty()) continue;
        return where + " holds no C++ source itself; there is one in " + in_quotes(inner) + ". Move it up one folder.";
    }
    return where + " holds no C++ source (.cpp, .cc or .cxx). Ask for ray_cast.cpp.";
}

/// One student's folder.
Submission from_folder(const path& folder, const Contents& contents) {
    std::string id = folder_id(folder);
    if (contents.sources.empty()) return with_problem(std::move(id), why_no_source(folder, contents));
    auto chosen = contents.sources.begin();
    std::vector<path> others;
    if (contents.sources.size() > 1) {
        chosen = std::find_if(contents.sources.begin(), contents.sources.end(), is_called_ray_cast);
        if (chosen == contents.sources.end()) {
            return with_problem(std::move(id), in_quotes(folder) +
                                                   " holds several sources: " + names_of(contents.sources) +
                                                   ". Keep the one to be graded, or call it ray_cast.cpp.");
        }
        std::copy_if(contents.sources.begin(), contents.sources.end(), std::back_inserter(others),
                     [&](const path& source) { return source != *chosen; });
    }
    Submission submission = from_file(*chosen, std::move(id), Links::refuse);
    const std::string name = in_quotes(chosen->filename());
    if (!others.empty()) submission.notes.push_back("Only " + name + " is graded; not " + names_of(others) + '.');
    if (!contents.headers.empty()) {
        submission.notes.push_back("Only " + name + " is compiled, without " + names_of(contents.headers) + '.');
    }
    return submission;
}

Submission from_link(const path& link) {
    return with_problem(printable(link.filename().native()),
                        in_quotes(link) + " is a symbolic link. Put the folder itself there: links are not followed.");
}

bool holds_sources(const path& folder) {
    return !list(folder).sources.empty();
}

std::vector<Submission> from_class(const Contents& contents, bool also_folders) {
    std::vector<Submission> submissions;
    for (const auto& source : contents.sources) {
        submissions.push_back(from_file(source, printable(source.stem().native()), Links::refuse));
    }
    if (!also_folders) return submissions;
    for (const auto& folder : contents.folders) submissions.push_back(from_folder(folder, list(folder)));
    for (const auto& link : contents.linked) submissions.push_back(from_link(link));
    return submissions;
}

std::vector<Submission> from_given_folder(const path& folder) {
    const Contents contents = list(folder);
    const bool has_sources = !contents.sources.empty();
    if (contents.error || (!has_sources && contents.folders.empty())) {
        throw HarnessError(why_no_source(folder, contents));
    }
    const bool is_class = !has_sources || std::any_of(contents.folders.begin(), contents.folders.end(), holds_sources);
    const bool has_ray_cast = std::any_of(contents.sources.begin(), contents.sources.end(), is_called_ray_cast);
    if (!is_class && has_ray_cast) return {from_folder(folder, contents)};
    return from_class(contents, is_class);
}

struct Taken {
    path from;
    std::string id;
    Submission submission;
};

/// The last `count` names of the path that `one` was found in, joined; fewer if it has fewer. What gave the id its name
/// is not said twice.
std::string last_names(const Taken& one, std::size_t count) {
    std::vector<std::string> names;
    for (const auto& name : std::filesystem::absolute(one.from).lexically_normal()) {
        if (!name.empty() && name != "/") names.push_back(printable(name.native()));
    }
    while (!names.empty() && (names.back() == one.id || is_source_name(names.back()))) names.pop_back();
    std::string text;
    for (std::size_t i = names.size() - std::min(count, names.size()); i < names.size(); ++i) text += names[i] + '-';
    return text;
}

std::map<std::string, int> count_ids(const std::vector<Taken>& all) {
    std::map<std::string, int> counts;
    for (const auto& one : all) ++counts[one.submission.id];
    return counts;
}

void make_ids_unique(std::vector<Taken>& all) {
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

std::vector<Submission> unique(std::vector<Taken> all) {
    make_ids_unique(all);
    std::vector<Submission> submissions;
    for (auto& one : all) submissions.push_back(std::move(one.submission));
    return submissions;
}

}  // namespace

std::vector<Submission> take_in(const path& given) {
    std::error_code error;
    const auto status = std::filesystem::status(given, error);
    if (!std::filesystem::exists(status)) {
        throw HarnessError("There is no " + in_quotes(given) + (error ? ": " + error.message() : "") +
                           ". Check the path; a name with blanks needs quotes.");
    }
    std::vector<Submission> submissions;
    if (std::filesystem::is_directory(status)) {
        submissions = from_given_folder(given);
    } else if (!is_source_name(given)) {
        throw HarnessError(in_quotes(given) + " is neither a folder nor a C++ source (.cpp, .cc or .cxx).");
    } else {
        const bool named_by_folder = is_called_ray_cast(given);
        const path folder = std::filesystem::absolute(given).parent_path();
        const std::string id = named_by_folder ? folder_id(folder) : printable(given.stem().native());
        submissions.push_back(from_file(given, id, Links::follow));
    }
    std::stable_sort(submissions.begin(), submissions.end(),
                     [](const Submission& a, const Submission& b) { return a.id < b.id; });
    std::vector<Taken> all;
    for (auto& one : submissions) all.push_back({one.file.empty() ? given : one.file, one.id, one});
    return unique(std::move(all));
}

std::vector<Submission> take_in_all(const std::vector<path>& paths) {
    std::vector<Taken> all;
    for (const auto& given : paths) {
        for (auto& one : take_in(given)) {
            std::string id = one.id;
            all.push_back({given, std::move(id), std::move(one)});
        }
    }
    return unique(std::move(all));
}

}  // namespace harness
