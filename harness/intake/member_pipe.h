// The pipe from the process that reads an archive to raygrade. What comes out of it is as hostile as the archive:
// whoever packed it may have got hold of that process.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/intake/archive_contents.h"
#include "harness/intake/confined_child.h"
#include "harness/intake/lms/lms_owner.h"

namespace harness {

/// Whether what a student has in the archive costs that student alone.
enum class Shares { none, of_students };

/// The end in the child.
class MemberSender {
  public:
    explicit MemberSender(int pipe) : pipe_(pipe) {}
    void send(const ArchiveFile& file);
    /// Says why nothing of this student counts, also what was sent.
    void refuse(const EntryOwner& student, std::string_view why);
    /// Says why the archive is not read.
    void refuse(std::string_view why);
    void finish();

  private:
    int pipe_;
};

/// Reads everything that the child sends. Throws ArchiveError with what the child says against the archive, or if the
/// child reached a limit or sends more than `limits` or what no sender sends; HarnessError if the machine lacks memory.
std::vector<ArchiveFile> receive_members(ConfinedChild& child, const std::string& shown, const Wanted& wanted,
                                         const ArchiveLimits& limits);

}  // namespace harness
