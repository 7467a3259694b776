#include "harness/intake/file_tree.h"

#include <fcntl.h>

#include <algorithm>
#include <map>
#include <set>

#include "harness/intake/archive.h"
#include "harness/intake/gradescope_metadata.h"
#include "harness/intake/intake.h"
#include "harness/intake/lms_name.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

using std::filesystem::path;

/// The limit for a student's archive within a class's archive: 16 MiB hold a thousand sources.
constexpr std::uint64_t largest_inner_archive = std::uint64_t{16} << 20U;

std::uint64_t wanted_of_a_class(std::string_view file) {
    if (is_source_name(file)) return largest_source_bytes;
    return is_archive_name(file) ? largest_inner_archive : 0;
}

/// Reads no archives within a student's archive.
std::uint64_t wanted_of_a_student(std::string_view file) {
    return is_source_name(file) ? largest_source_bytes : 0;
}

/// Finds the metadata file of a Gradescope export, which lies beside the folders submission_<number>. If there are
/// several, e.g. within a student's folder, returns the outermost. Null if there is none.
ArchiveFile* find_gradescope_metadata(std::vector<ArchiveFile>& files) {
    std::set<path> exports;
    for (const ArchiveFile& file : files) {
        for (path inner = path(file.path).parent_path(); !inner.empty(); inner = inner.parent_path()) {
            if (read_gradescope_name(inner.filename().native())) exports.insert(inner.parent_path());
        }
    }
    const auto depth = [](const ArchiveFile& file) { return std::count(file.path.begin(), file.path.end(), '/'); };
    ArchiveFile* found = nullptr;
    for (ArchiveFile& file : files) {
        const path place(file.path);
        if (place.filename() != gradescope_metadata_name || !exports.contains(place.parent_path())) continue;
        if (found == nullptr || depth(file) < depth(*found)) found = &file;
    }
    return found;
}

/// Decides by the name only, as the file may hold anything.
std::vector<path>& kind_of(const path& file, Contents& contents) {
    if (is_source_name(file)) return contents.sources;
    if (file.extension() == ".h" || file.extension() == ".hpp") return contents.headers;
    return is_archive_name(file.native()) ? contents.archives : contents.others;
}

void sort(Contents& contents) {
    for (auto* paths : {&contents.sources, &contents.folders, &contents.linked, &contents.headers, &contents.archives,
                        &contents.others}) {
        std::sort(paths->begin(), paths->end());
    }
}

/// Whether the folder holds results of raygrade, which may lie in the class's folder.
bool holds_results(const path& folder) {
    std::error_code ignored;
    return (std::filesystem::is_regular_file(folder / "grades.json", ignored) ||
            std::filesystem::is_regular_file(folder / "gradebook.sqlite", ignored)) &&
           std::filesystem::is_directory(folder / "feedback", ignored);
}

class ArchiveTree final : public FileTree {
  public:
    ArchiveTree(path archive, std::vector<ArchiveFile> files) : archive_(std::move(archive)) {
        for (ArchiveFile& file : files) {
            path place = archive_ / file.path;
            // If two entries have the same name, keep both.
            for (int i = 2; !files_.emplace(place, std::move(file)).second; ++i) {
                place = archive_ / (file.path + " (entry " + std::to_string(i) + ")" + place.extension().string());
            }
            for (path inner = place; inner != archive_; inner = inner.parent_path()) {
                children_[inner.parent_path()].insert(inner);
            }
        }
    }

    Contents list(const path& folder) const override {
        Contents contents;
        const auto found = children_.find(folder);
        if (found == children_.end()) return contents;
        for (const path& child : found->second) {
            if (children_.contains(child)) {
                contents.folders.push_back(child);
            } else {
                kind_of(child, contents).push_back(child);
            }
        }
        sort(contents);
        return contents;
    }

    void read(Submission& submission, Links /*links*/) const override {
        const ArchiveFile& file = files_.at(submission.file);
        set_source(submission, file.bytes, file.too_large);
    }

    BoundedFile read(const path& file, std::uintmax_t most) const override {
        const ArchiveFile& found = files_.at(file);
        return {found.bytes.substr(0, most), found.too_large || found.bytes.size() > most};
    }

    std::unique_ptr<FileTree> open(const path& archive) const override {
        const ArchiveFile& file = files_.at(archive);
        if (file.too_large) {
            throw ArchiveError(in_quotes(archive.filename()) + " is larger than " +
                               std::to_string(largest_inner_archive >> 20U) +
                               " MiB and was not read. Ask for the source alone.");
        }
        return std::make_unique<ArchiveTree>(
            archive, read_archive(file.bytes, archive.filename().native(), wanted_of_a_student));
    }

  private:
    path archive_;
    std::map<path, ArchiveFile> files_;
    std::map<path, std::set<path>> children_;  ///< by folder
};

}  // namespace

Contents DiskTree::list(const path& folder) const {
    Contents contents;
    std::filesystem::directory_iterator entry(folder, contents.error);
    for (; !contents.error && entry != std::filesystem::directory_iterator(); entry.increment(contents.error)) {
        const path name = entry->path().filename();
        if (name.native().starts_with('.')) continue;
        std::error_code ignored;
        const auto type = entry->symlink_status(ignored).type();
        if (type == std::filesystem::file_type::directory) {
            if (!holds_results(entry->path())) contents.folders.push_back(entry->path());
        } else if (type == std::filesystem::file_type::symlink && !is_source_name(name)) {
            contents.linked.push_back(entry->path());
        } else {
            kind_of(entry->path(), contents).push_back(entry->path());
        }
    }
    sort(contents);
    return contents;
}

void DiskTree::read(Submission& submission, Links links) const {
    read_source(submission, links);
}

BoundedFile DiskTree::read(const path& file, std::uintmax_t most) const {
    return read_bounded(file, most, Links::refuse);
}

std::unique_ptr<FileTree> DiskTree::open(const path& archive) const {
    std::vector<ArchiveFile> files = read_archive(archive, wanted_of_a_class);
    // Several files may have the metadata file's name, too many to keep. Which of them counts is known only after the
    // first reading.
    if (ArchiveFile* const metadata = find_gradescope_metadata(files)) {
        const auto wanted = [&](std::string_view file) {
            return file == metadata->path ? largest_gradescope_metadata : 0;
        };
        std::vector<ArchiveFile> again = read_archive(archive, wanted);
        const auto read = std::find_if(again.begin(), again.end(),
                                       [&](const ArchiveFile& file) { return file.path == metadata->path; });
        if (read != again.end()) *metadata = std::move(*read);
    }
    return std::make_unique<ArchiveTree>(archive, std::move(files));
}

}  // namespace harness
