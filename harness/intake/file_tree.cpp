#include "harness/intake/file_tree.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string_view>

#include "harness/intake/archive.h"
#include "harness/intake/archive_contents.h"
#include "harness/intake/lms/gradescope_metadata.h"
#include "harness/intake/lms/lms_name.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

using std::filesystem::path;

/// The limit for a student's archive within a class's archive: 16 MiB hold a thousand sources.
constexpr std::uint64_t largest_inner_archive = std::uint64_t{16} << 20U;

void for_each_name(std::string_view file, const std::function<void(std::string_view name)>& work) {
    for (std::size_t begin = 0; begin < file.size();) {
        const std::size_t end = std::min(file.find('/', begin), file.size());
        if (end > begin) work(file.substr(begin, end - begin));
        begin = end + 1;
    }
}

/// Whether the file is the metadata of a Gradescope export. It is next to the students' folders; a file with this name
/// inside one of them is the student's.
bool is_metadata_of_export(std::string_view file) {
    std::string_view last;
    bool is_a_students = false;
    for_each_name(file, [&](std::string_view name) {
        last = name;
        is_a_students = is_a_students || read_gradescope_name(name);
    });
    return last == gradescope_metadata_name && !is_a_students;
}

std::uint64_t wanted_of_a_class(std::string_view file) {
    if (is_source_name(file)) return largest_source_bytes;
    if (is_metadata_of_export(file)) return largest_gradescope_metadata;
    return is_archive_name(file) ? largest_inner_archive : 0;
}

/// Reads no archives within a student's archive.
std::uint64_t wanted_of_a_student(std::string_view file) {
    return is_source_name(file) ? largest_source_bytes : 0;
}

/// Uses only the name, because the file may contain anything.
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

/// Whether raygrade made this folder for results, which may be inside the class's folder: it has the results of a
/// finished run, or only the empty folder that each run makes first. A folder with a source in it is a student's.
bool is_for_results(const path& folder) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder / "feedback", error)) return false;
    constexpr std::size_t enough = 200;
    const bool has_results =
        std::filesystem::is_regular_file(folder / "gradebook.sqlite", error) ||
        read_bounded(folder / "grades.json", enough, Links::refuse).bytes.find("\"raygrade/grades/") !=
            std::string::npos;
    if (!has_results && !std::filesystem::is_empty(folder / "feedback", error)) return false;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const path name = entry.path().filename();
        if (is_source_name(name) || (!has_results && name != "feedback")) return false;
    }
    return !error;
}

/// A folder or file of an archive. Paths share the nodes of their common beginning, so that deep paths take no more
/// memory than the archive's list of them.
struct Node {
    std::optional<ArchiveFile> file;
    std::string refusal;  ///< see ArchiveFile
    std::map<std::string, std::unique_ptr<Node>, std::less<>> inner;
};

class ArchiveTree final : public FileTree {
  public:
    ArchiveTree(path archive, std::vector<ArchiveFile> files) : archive_(std::move(archive)) {
        for (ArchiveFile& file : files) {
            Node* const node = &add(file.path);
            if (!file.refusal.empty()) {
                node->refusal = file.refusal;
                if (!file.is_folder) node->file = std::move(file);
                continue;
            }
            node->file = std::move(file);  // the later of two entries with the same name wins, as in unpacking
        }
    }

    Contents list(const path& folder) const override {
        Contents contents;
        const Node* const found = find(folder);
        if (found == nullptr) return contents;
        for (const auto& [name, child] : found->inner) {
            if (child->inner.empty() && child->file) {
                kind_of(folder / name, contents).push_back(folder / name);
            } else {
                contents.folders.push_back(folder / name);
            }
        }
        sort(contents);
        return contents;
    }

    void read(Submission& submission, Links /*links*/) const override {
        const ArchiveFile& file = file_at(submission.file);
        if (!file.refusal.empty()) {
            submission.problem = file.refusal;
            return;
        }
        set_source(submission, file.bytes, file.too_large);
    }

    BoundedFile read(const path& file, std::uintmax_t most) const override {
        const ArchiveFile& found = file_at(file);
        return {found.bytes.substr(0, most), found.too_large || found.bytes.size() > most};
    }

    std::string refusal(const path& place) const override {
        const Node* const found = find(place);
        return found == nullptr ? "" : found->refusal;
    }

    std::unique_ptr<FileTree> open(const path& archive) const override {
        const ArchiveFile& file = file_at(archive);
        if (!file.refusal.empty()) throw ArchiveError(file.refusal);
        if (file.too_large) {
            throw ArchiveError(in_quotes(archive.filename()) + " is larger than " +
                               std::to_string(largest_inner_archive >> 20U) +
                               " MiB and was not read. Hand in only the source.");
        }
        return std::make_unique<ArchiveTree>(
            archive, read_archive(file.bytes, archive.filename().native(), wanted_of_a_student, limits_of_a_student));
    }

  private:
    Node& add(std::string_view file) {
        Node* node = &root_;
        for_each_name(file, [&](std::string_view name) {
            auto& inner = node->inner.try_emplace(std::string(name)).first->second;
            if (!inner) inner = std::make_unique<Node>();
            node = inner.get();
        });
        return *node;
    }

    /// `place` begins with `archive_`. Null if there is no such folder or file.
    const Node* find(const path& place) const {
        const Node* node = &root_;
        for_each_name(std::string_view(place.native()).substr(archive_.native().size()), [&](std::string_view name) {
            if (node == nullptr) return;
            const auto found = node->inner.find(name);
            node = found == node->inner.end() ? nullptr : found->second.get();
        });
        return node;
    }

    const ArchiveFile& file_at(const path& place) const { return find(place)->file.value(); }

    path archive_;
    Node root_;
};

}  // namespace

Contents DiskTree::list(const path& folder) const {
    Contents contents;
    std::filesystem::directory_iterator entry(folder, contents.error);
    for (; !contents.error && entry != std::filesystem::directory_iterator(); entry.increment(contents.error)) {
        const path name = entry->path().filename();
        if (name.native().starts_with('.') || name == "__MACOSX") continue;
        std::error_code ignored;
        const auto type = entry->symlink_status(ignored).type();
        if (type == std::filesystem::file_type::directory) {
            if (!is_for_results(entry->path())) contents.folders.push_back(entry->path());
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
    return std::make_unique<ArchiveTree>(
        archive, read_archive(archive, Links::refuse, wanted_of_a_student, limits_of_a_student));
}

std::unique_ptr<FileTree> open_class(const path& archive) {
    return std::make_unique<ArchiveTree>(archive, read_class_archive(archive, wanted_of_a_class));
}

}  // namespace harness
