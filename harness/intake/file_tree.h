// Gives intake the same view of folders on disk and of the contents of archives.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "harness/intake/source_file.h"
#include "harness/intake/submission.h"
#include "harness/machine/bounded_file.h"

namespace harness {

/// The entries of a folder, grouped by how intake handles them. Links are never followed. Names that begin with a dot
/// and folders with raygrade's own results are left out.
struct Contents {
    std::vector<std::filesystem::path> sources;  ///< by name alone: files, and links, pipes and folders so named
    std::vector<std::filesystem::path> folders;
    std::vector<std::filesystem::path> linked;  ///< symbolic links without a source's name
    std::vector<std::filesystem::path> headers;
    std::vector<std::filesystem::path> archives;
    std::vector<std::filesystem::path> others;  ///< any other file
    std::error_code error;                      ///< why it could not be listed
};

class FileTree {
  public:
    virtual ~FileTree() = default;
    /// Each kind sorted by path.
    virtual Contents list(const std::filesystem::path& folder) const = 0;
    /// Reads `submission.file` into source and source_sha256, or sets problem.
    virtual void read(Submission& submission, Links links) const = 0;
    /// Reads at most `most` bytes of any other file.
    virtual BoundedFile read(const std::filesystem::path& file, std::uintmax_t most) const = 0;
    /// Why nothing of this student's folder or file was read; empty if it was read.
    virtual std::string refusal(const std::filesystem::path& place) const = 0;
    /// Opens a student's archive within this tree. The paths of the result begin with `archive`. Throws ArchiveError,
    /// and HarnessError as read_archive does.
    virtual std::unique_ptr<FileTree> open(const std::filesystem::path& archive) const = 0;
};

/// The machine's own files.
class DiskTree final : public FileTree {
  public:
    Contents list(const std::filesystem::path& folder) const override;
    void read(Submission& submission, Links links) const override;
    BoundedFile read(const std::filesystem::path& file, std::uintmax_t most) const override;
    std::string refusal(const std::filesystem::path& /*place*/) const override { return {}; }
    std::unique_ptr<FileTree> open(const std::filesystem::path& archive) const override;
};

/// Opens an archive on disk that contains a class. Throws like FileTree::open.
std::unique_ptr<FileTree> open_class(const std::filesystem::path& archive);

}  // namespace harness
