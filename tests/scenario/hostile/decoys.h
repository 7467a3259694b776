// Decoys for hostile submissions: things that look like an instructor's, at places that the attacks know.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/machine/file_descriptor.h"

namespace hostile {

constexpr const char* decoy_variable = "RAYGRADE_DECOY";
constexpr const char* decoy_value = "DECOYENV-91bb";

/// Places an answer key, a grade book and a submission below /tmp/raygrade-decoy. Everyone may read and write them, so
/// only the sandbox protects them. They are never removed, because several tests use them at the same time.
void place_decoy_files();

/// One sentence per change of the decoy files; empty if they are unchanged.
std::vector<std::string> changes_to_decoy_files();

/// Listens on 127.0.0.1:47053 and, unless another test does so already, on the abstract Unix socket "raygrade-decoy".
class DecoyListener {
  public:
    DecoyListener();
    bool was_called() const;

  private:
    harness::FileDescriptor tcp_, local_;
};

/// A System V shared memory segment that everyone may read. It exists as long as this object.
class DecoySegment {
  public:
    DecoySegment();
    ~DecoySegment();
    DecoySegment(const DecoySegment&) = delete;
    DecoySegment& operator=(const DecoySegment&) = delete;

  private:
    int id_;
};

/// The first word of `text` that a sandboxed program can't know, because it stands in a decoy or in the machine's
/// /etc/passwd; "" if there is none. Ignores case, because the assembler quotes what it reads in either case.
std::string stolen_word(std::string_view text);

}  // namespace hostile
