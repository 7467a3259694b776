// The pipe from the process that reads an archive to raygrade. Its data is as hostile as the archive: the archive's
// author may control that process.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/intake/archive_contents.h"
#include "harness/intake/confined_child.h"
#include "harness/intake/lms/lms_owner.h"

namespace harness {

/// Whether a bad entry costs only its student.
enum class Shares { none, of_students };

/// The child's end.
class MemberSender {
  public:
    explicit MemberSender(int pipe) : pipe_(pipe) {}
    void send(const ArchiveFile& file);
    /// Refuses this student's files with a reason, including those already sent.
    void refuse(const EntryOwner& student, std::string_view why);
    /// Reports why the archive is not read.
    void refuse(std::string_view why);
    void finish();

  private:
    int pipe_;
};

/// Reads everything the child sends. Throws ArchiveError with the child's reason against the archive, or if the child
/// reached a limit, or sends more than `limits` or data no sender sends; HarnessError if the machine lacks memory.
std::vector<ArchiveFile> receive_members(ConfinedChild& child, const std::string& shown, const Wanted& wanted,
                                         const ArchiveLimits& limits);

}  // namespace harness
