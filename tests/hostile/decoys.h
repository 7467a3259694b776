// What hostile submissions are after: things that look like an instructor's, at places the attacks know.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/sandbox/file_descriptor.h"

namespace hostile {

constexpr const char* decoy_variable = "RAYGRADE_DECOY";
constexpr const char* decoy_value = "DECOYENV-91bb";

/// Below /tmp/raygrade-decoy an answer key, a grade book and another submission, which everyone may read and write: it
/// is the sandbox that is to protect them. They stay, as several tests use them at a time.
void place_decoy_files();

/// What has become of them, a sentence each; empty when they are as they were placed.
std::vector<std::string> changes_to_decoy_files();

/// Somebody who waits for calls on 127.0.0.1:47053 and, where no other test does, on the abstract Unix socket
/// "raygrade-decoy".
class DecoyListener {
  public:
    DecoyListener();
    bool was_called() const;

  private:
    harness::FileDescriptor tcp_, local_;
};

/// Shared memory of System V that everyone may read, as long as this lives.
class DecoySegment {
  public:
    DecoySegment();
    ~DecoySegment();
    DecoySegment(const DecoySegment&) = delete;
    DecoySegment& operator=(const DecoySegment&) = delete;

  private:
    int id_;
};

/// The first word of `text` that a sandboxed program can't know: of the decoys, or of the machine's /etc/passwd. Empty
/// when there is none. Upper and lower case are the same, as they are to the assembler, which quotes what it reads.
std::string stolen_word(std::string_view text);

}  // namespace hostile
