// What intake looks at: folders on disk and the insides of archives, alike.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "harness/bounded_file.h"
#include "harness/source_file.h"
#include "harness/submission.h"

namespace harness {

/// What a folder holds, by what intake does with it. Links are never followed. Names that begin with a dot and results
/// of raygrade's own are left out.
struct Contents {
    std::vector<std::filesystem::path> sources;  ///< by name alone: files, but also links, pipes and folders called so
    std::vector<std::filesystem::path> folders;
    std::vector<std::filesystem::path> linked;  ///< symbolic links that are not called like a source
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
    /// Fills in source and source_sha256 from `submission.file`, or problem.
    virtual void read(Submission& submission, Links links) const = 0;
    /// Any other file that intake has a use for, of at most `most` bytes.
    virtual BoundedFile read(const std::filesystem::path& file, std::uintmax_t most) const = 0;
    /// The tree of an archive in this one; its paths begin with `archive`. Throws ArchiveError.
    virtual std::unique_ptr<FileTree> open(const std::filesystem::path& archive) const = 0;
};

/// The machine's own files.
class DiskTree final : public FileTree {
  public:
    Contents list(const std::filesystem::path& folder) const override;
    void read(Submission& submission, Links links) const override;
    BoundedFile read(const std::filesystem::path& file, std::uintmax_t most) const override;
    std::unique_ptr<FileTree> open(const std::filesystem::path& archive) const override;
};

}  // namespace harness
