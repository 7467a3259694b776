#include "harness/intake/intake.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

#include "harness/intake/archive.h"
#include "harness/intake/file_tree.h"
#include "harness/intake/hand_in.h"
#include "harness/intake/lms_download.h"
#include "harness/machine/errors.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

using std::filesystem::path;

/// The folder's own name, even for "." and for a path that ends in '/'.
std::string folder_id(const path& folder) {
    const path whole = std::filesystem::absolute(folder).lexically_normal();
    const path name = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    return name.empty() ? "root" : printable(name.native());
}

Submission from_file(const FileTree& tree, const path& file, std::string id, Links links) {
    Submission submission;
    submission.id = std::move(id);
    submission.file = file;
    tree.read(submission, links);
    return submission;
}

std::string why_no_source(const FileTree& tree, const path& folder, const Contents& contents) {
    const std::string where = in_quotes(folder);
    if (contents.error == std::errc::permission_denied) {
        return "Could not open the folder " + where + ". Make it readable: chmod u+rx.";
    }
    if (contents.error) return "Could not list the folder " + where + ": " + contents.error.message() + '.';
    for (const auto& inner : contents.folders) {
        const auto deeper = tree.list(inner);
        if (deeper.sources.empty()) continue;
        return where + " holds no C++ source itself; there is one in " + in_quotes(inner) + ". Move it up one folder.";
    }
    return where + " holds no C++ source (.cpp, .cc or .cxx). Ask for ray_cast.cpp.";
}

/// Reads one student's folder.
Submission from_folder(const FileTree& tree, const path& folder, const Contents& contents) {
    HandIn hand_in;
    hand_in.add(contents);
    std::string id = folder_id(folder);
    if (std::string why = tree.refusal(folder); !why.empty()) return with_problem(std::move(id), std::move(why));
    if (hand_in.is_without_source()) return with_problem(std::move(id), why_no_source(tree, folder, contents));
    return take(tree, hand_in, std::move(id), in_quotes(folder));
}

void leave_out(const std::vector<path>& files, Intake& intake) {
    for (const path& file : files) intake.left_out.push_back(printable(file.filename().native()));
}

Submission from_link(const path& link) {
    return with_problem(printable(link.filename().native()),
                        in_quotes(link) + " is a symbolic link. Put the folder itself there: links are not followed.");
}

Submission from_packed(const FileTree& tree, const path& archive) {
    HandIn hand_in;
    hand_in.archives = {archive};
    return take(tree, hand_in, printable(archive.stem().native()), in_quotes(archive));
}

Intake from_class(const FileTree& tree, const Contents& contents, bool also_folders) {
    Intake intake;
    for (const auto& source : contents.sources) {
        intake.submissions.push_back(from_file(tree, source, printable(source.stem().native()), Links::refuse));
    }
    for (const auto& archive : contents.archives) intake.submissions.push_back(from_packed(tree, archive));
    leave_out(contents.headers, intake);
    leave_out(contents.others, intake);
    if (!also_folders) return intake;
    for (const auto& folder : contents.folders)
        intake.submissions.push_back(from_folder(tree, folder, tree.list(folder)));
    for (const auto& link : contents.linked) intake.submissions.push_back(from_link(link));
    return intake;
}

bool holds_a_class(const FileTree& tree, const Contents& contents) {
    return std::any_of(contents.folders.begin(), contents.folders.end(), [&](const path& folder) {
        const Contents inner = tree.list(folder);
        return !inner.sources.empty() || !inner.archives.empty();
    });
}

Intake from_given_folder(const FileTree& tree, const path& folder) {
    const Contents contents = tree.list(folder);
    if (auto of_lms = from_lms_download(tree, contents)) {
        Intake intake{std::move(of_lms->submissions), {}};
        leave_out(of_lms->left_out, intake);
        return intake;
    }
    const bool has_sources = !contents.sources.empty();
    const bool is_class = holds_a_class(tree, contents) || (!has_sources && contents.archives.empty());
    if (contents.error || (is_class && !has_sources && contents.folders.empty())) {
        throw UsageError(why_no_source(tree, folder, contents));
    }
    const bool has_ray_cast = std::any_of(contents.sources.begin(), contents.sources.end(), is_called_ray_cast);
    if (!is_class && (has_ray_cast || !has_sources)) return Intake{{from_folder(tree, folder, contents)}, {}};
    return from_class(tree, contents, is_class);
}

/// Skips outer folders: packers often put everything below a folder with the archive's name.
path without_wrapping(const FileTree& tree, path folder) {
    constexpr int deepest = 8;
    for (int i = 0; i < deepest; ++i) {
        const Contents contents = tree.list(folder);
        const bool alone = contents.folders.size() == 1 && contents.sources.empty() && contents.archives.empty();
        if (!alone || is_of_lms(contents)) break;
        if (!holds_a_class(tree, tree.list(contents.folders.front())) &&
            tree.list(contents.folders.front()).sources.empty() && !is_of_lms(tree.list(contents.folders.front())))
            break;
        folder = contents.folders.front();
    }
    return folder;
}

/// Where a download lies below outer folders, that place; else `folder` itself, because a folder with one folder in it
/// may be a class of one student.
path download_below(const FileTree& tree, const path& folder) {
    const path inner = without_wrapping(tree, folder);
    return is_of_lms(tree.list(inner)) ? inner : folder;
}

/// Throws ArchiveError, also if it holds no submission.
Intake from_given_archive(const path& archive) {
    const auto tree = open_class(archive);
    try {
        return from_given_folder(*tree, without_wrapping(*tree, archive));
    } catch (const UsageError& error) {
        throw ArchiveError(error.what());
    }
}

struct Taken {
    path from;
    std::string id;
    Submission submission;
};

/// Joins the last `count` names of the path in which `one` was found, or all if there are fewer. Leaves out the name
/// that the id came from.
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

Intake intake_at(const path& given) {
    std::error_code error;
    const auto status = std::filesystem::status(given, error);
    if (!std::filesystem::exists(status)) {
        throw UsageError("There is no " + in_quotes(given) + (error ? ": " + error.message() : "") +
                         ". Check the path; a name with blanks needs quotes.");
    }
    Intake intake;
    const DiskTree disk;
    if (std::filesystem::is_directory(status)) {
        intake = from_given_folder(disk, download_below(disk, given));
    } else if (is_archive_name(given.native())) {
        intake = from_given_archive(given);
    } else if (!is_source_name(given)) {
        throw UsageError(in_quotes(given) +
                         " is neither a folder nor a C++ source (.cpp, .cc or .cxx) nor an archive (.zip, .tar, "
                         ".tar.gz or .tgz).");
    } else {
        const bool named_by_folder = is_called_ray_cast(given);
        const path folder = std::filesystem::absolute(given).parent_path();
        const std::string id = named_by_folder ? folder_id(folder) : printable(given.stem().native());
        intake.submissions.push_back(from_file(disk, given, id, Links::follow));
    }
    std::stable_sort(intake.submissions.begin(), intake.submissions.end(),
                     [](const Submission& a, const Submission& b) { return a.id < b.id; });
    std::vector<Taken> all;
    for (auto& one : intake.submissions) all.push_back({one.file.empty() ? given : one.file, one.id, one});
    intake.submissions = unique(std::move(all));
    return intake;
}

Intake take_in_whole(const path& given) {
    try {
        return intake_at(given);
    } catch (const ArchiveError& error) {
        throw UsageError(error.what());
    }
}

}  // namespace

std::vector<Submission> take_in(const path& given) {
    return take_in_whole(given).submissions;
}

Intake take_in_all(const std::vector<path>& paths) {
    if (paths.size() == 1) return take_in_whole(paths.front());
    const auto intake_or_problem = [](const path& given) {
        try {
            return intake_at(given);
        } catch (const ArchiveError& error) {  // it may be one student's
            return Intake{{with_problem(printable(given.stem().native()), error.what())}, {}};
        }
    };
    Intake whole;
    std::vector<Taken> all;
    for (const auto& given : paths) {
        Intake intake = intake_or_problem(given);
        whole.left_out.insert(whole.left_out.end(), intake.left_out.begin(), intake.left_out.end());
        for (auto& one : intake.submissions) {
            std::string id = one.id;
            all.push_back({given, std::move(id), std::move(one)});
        }
    }
    whole.submissions = unique(std::move(all));
    return whole;
}

}  // namespace harness
