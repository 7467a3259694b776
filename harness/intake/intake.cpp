#include "harness/intake/intake.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <system_error>

#include "harness/intake/archive.h"
#include "harness/intake/archive_contents.h"
#include "harness/intake/file_tree.h"
#include "harness/intake/hand_in.h"
#include "harness/intake/lms_download.h"
#include "harness/intake/unique_ids.h"
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

/// Reads one student's folder.
Submission from_folder(const FileTree& tree, const path& folder) {
    std::string id = folder_id(folder);
    if (std::string why = tree.refusal(folder); !why.empty()) return with_problem(std::move(id), std::move(why));
    HandIn hand_in;
    hand_in.add_all_in(tree, folder);
    return take(tree, hand_in, std::move(id));
}

void leave_out(const std::vector<path>& files, Intake& intake) {
    for (const path& file : files) intake.left_out.push_back(printable(file.filename().native()));
}

Submission from_link(const path& link) {
    return with_problem(
        printable(link.filename().native()),
        in_quotes(link.filename()) + " is a symbolic link, and links are not followed. Put the folder itself there.");
}

Submission from_packed(const FileTree& tree, const path& archive) {
    HandIn hand_in;
    hand_in.archives = {{archive, archive.filename(), {}}};
    return take(tree, hand_in, printable(archive.stem().native()));
}

/// A submission of a file that raygrade does not read: its problem names the file and what to hand in instead.
Submission from_unread(const FileTree& tree, const path& file) {
    HandIn hand_in;
    hand_in.others = {file.filename()};
    return take(tree, hand_in, printable(file.stem().native()));
}

/// Whether a submission may be in the folder or its subfolders. True for a folder that cannot be read.
bool may_hold_hand_ins(const FileTree& tree, const path& folder) {
    const Contents contents = tree.list(folder);
    if (contents.error || !tree.refusal(folder).empty()) return true;
    return !contents.sources.empty() || !contents.archives.empty() ||
           std::ranges::any_of(contents.folders, [&](const path& inner) { return may_hold_hand_ins(tree, inner); });
}

/// Whether more than one folder may hold hand-ins, as in a class.
bool hold_several(const FileTree& tree, const std::vector<path>& folders) {
    return std::ranges::count_if(folders, [&](const path& one) { return may_hold_hand_ins(tree, one); }) > 1;
}

Intake from_class(const FileTree& tree, const Contents& contents, bool also_folders) {
    Intake intake;
    for (const auto& source : contents.sources) {
        intake.submissions.push_back(from_file(tree, source, printable(source.stem().native()), Links::refuse));
    }
    for (const auto& archive : contents.archives) intake.submissions.push_back(from_packed(tree, archive));
    if (also_folders && contents.folders.size() > intake.submissions.size()) {
        for (Submission& beside : intake.submissions)
            beside.notes.push_back("It is next to the students' folders. If no student handed it in, move it away.");
    }
    leave_out(contents.headers, intake);
    for (const path& other : contents.others) {
        if (may_be_hand_in(other)) {
            intake.submissions.push_back(from_unread(tree, other));
        } else {
            leave_out({other}, intake);
        }
    }
    for (const auto& folder : contents.folders) {
        if (!also_folders && !may_hold_hand_ins(tree, folder)) continue;
        intake.submissions.push_back(from_folder(tree, folder));
        const Contents inner = tree.list(folder);
        if (!inner.error && tree.refusal(folder).empty() && inner.sources.empty() && inner.archives.empty() &&
            hold_several(tree, inner.folders)) {
            intake.submissions.back().notes.push_back(
                fmt::format("The subfolders of {0} contain sources. If {0} is a class, grade it separately.",
                            in_quotes(folder.filename())));
        }
    }
    if (also_folders) {
        for (const auto& link : contents.linked) intake.submissions.push_back(from_link(link));
    }
    return intake;
}

bool holds_a_class(const FileTree& tree, const Contents& contents) {
    return std::any_of(contents.folders.begin(), contents.folders.end(), [&](const path& folder) {
        const Contents inner = tree.list(folder);
        return !inner.sources.empty() || !inner.archives.empty();
    });
}

/// Skips outer folders: packers often put everything into one folder with the archive's name.
path without_wrapping(const FileTree& tree, path folder) {
    constexpr int deepest = 8;
    for (int i = 0; i < deepest; ++i) {
        const Contents contents = tree.list(folder);
        const bool alone = contents.folders.size() == 1 && contents.sources.empty() && contents.archives.empty();
        if (!alone || count_lms_names(contents) > 0) break;
        const Contents inner = tree.list(contents.folders.front());
        if (!hold_several(tree, inner.folders) && !holds_a_class(tree, inner) && inner.sources.empty() &&
            count_lms_names(inner) == 0)
            break;
        folder = contents.folders.front();
    }
    return folder;
}

/// The folder of a download inside outer folders; if there is none, `folder` itself, because a folder with one folder
/// in it may be a class of one student.
path download_below(const FileTree& tree, const path& folder) {
    const path inner = without_wrapping(tree, folder);
    return count_lms_names(tree.list(inner)) > 0 ? inner : folder;
}

/// Downloads in the folders of this one, e.g. one for each section, and the other files and folders. Empty if they do
/// not hold most of the possible submissions: a student's folder may contain one file with a name like a download's.
std::optional<LmsDownload> from_downloads_within(const FileTree& tree, const Contents& contents) {
    LmsDownload all;
    Contents beside = contents;
    beside.folders.clear();
    std::size_t hand_ins = 0;
    for (const path& folder : contents.folders) {
        const Contents inner = tree.list(download_below(tree, folder));
        const std::size_t names = count_lms_names(inner);
        auto download = names > 1 ? from_lms_download(tree, inner) : std::nullopt;
        if (!download) {
            beside.folders.push_back(folder);
            continue;
        }
        hand_ins += names;
        std::move(download->submissions.begin(), download->submissions.end(), std::back_inserter(all.submissions));
        all.left_out.insert(all.left_out.end(), download->left_out.begin(), download->left_out.end());
    }
    std::erase_if(beside.folders, [&](const path& folder) { return !may_hold_hand_ins(tree, folder); });
    if (hand_ins <= beside.sources.size() + beside.archives.size() + beside.folders.size()) return std::nullopt;
    add_strangers(beside, "is next to the folder of a download", all);
    return all;
}

Intake from_given_folder(const FileTree& tree, const path& folder) {
    const Contents contents = tree.list(folder);
    auto download = from_lms_download(tree, contents);
    if (!download) download = from_downloads_within(tree, contents);
    if (download) {
        Intake intake{std::move(download->submissions), {}};
        leave_out(download->left_out, intake);
        return intake;
    }
    const bool has_sources = !contents.sources.empty();
    const bool is_of_several =
        contents.archives.size() != 1 ||
        std::ranges::any_of(contents.folders, [&](const path& inner) { return may_hold_hand_ins(tree, inner); });
    const bool is_class = holds_a_class(tree, contents) || (!has_sources && is_of_several);
    if (contents.error || (is_class && !has_sources && contents.folders.empty() && contents.archives.empty())) {
        throw UsageError(in_quotes(folder) + ": " +
                         from_folder(tree, folder)
                             .problem.value_or("It contains no folders. Name a folder with a folder for each student"));
    }
    const bool has_ray_cast = std::any_of(contents.sources.begin(), contents.sources.end(), is_called_ray_cast);
    if (is_class || (has_sources && !has_ray_cast)) return from_class(tree, contents, is_class);
    return Intake{{from_folder(tree, folder)}, {}};
}

/// Throws ArchiveError, also if the archive has no submission.
Intake from_given_archive(const path& archive) {
    const auto tree = open_class(archive);
    try {
        return from_given_folder(*tree, without_wrapping(*tree, archive));
    } catch (const UsageError& error) {
        throw ArchiveError(error.what());
    }
}

/// Throws UsageError if there is no such path.
bool is_folder(const path& given) {
    std::error_code error;
    const auto status = std::filesystem::status(given, error);
    if (std::filesystem::exists(status)) return std::filesystem::is_directory(status);
    throw UsageError("Cannot find " + in_quotes(given) + (error ? ": " + error.message() : "") +
                     ". Check the path; put a name with spaces in quotes.");
}

Submission from_given_source(const path& given) {
    if (!is_source_name(given)) {
        throw UsageError(in_quotes(given) +
                         " is not a folder, a C++ source (.cpp, .cc or .cxx) or an archive (.zip, .tar, .tar.gz or "
                         ".tgz). Name one of these.");
    }
    const path folder = std::filesystem::absolute(given).parent_path();
    const std::string id = is_called_ray_cast(given) ? folder_id(folder) : printable(given.stem().native());
    return from_file(DiskTree(), given, id, Links::follow);
}

Intake intake_at(const path& given) {
    Intake intake;
    const DiskTree disk;
    if (is_folder(given)) {
        intake = from_given_folder(disk, download_below(disk, given));
    } else if (is_archive_name(given.native())) {
        intake = from_given_archive(given);
    } else {
        intake.submissions = {from_given_source(given)};
    }
    std::stable_sort(intake.submissions.begin(), intake.submissions.end(),
                     [](const Submission& a, const Submission& b) { return a.id < b.id; });
    std::vector<Taken> all;
    for (auto& submission : intake.submissions)
        all.push_back({submission.file.empty() ? given : submission.file, submission.id, submission});
    intake.submissions = with_unique_ids(std::move(all));
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

Submission take_in_one(const path& given) {
    if (is_folder(given)) return from_folder(DiskTree(), given);
    if (is_archive_name(given.native())) return from_packed(DiskTree(), given);
    return may_be_hand_in(given) ? from_unread(DiskTree(), given) : from_given_source(given);
}

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
        for (auto& submission : intake.submissions) {
            std::string id = submission.id;
            all.push_back({given, std::move(id), std::move(submission)});
        }
    }
    whole.submissions = with_unique_ids(std::move(all));
    return whole;
}

}  // namespace harness
