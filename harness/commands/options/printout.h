// Reads a program's output from a file on the command line.
#pragma once

#include <filesystem>
#include <string>

#include "harness/mark/score/score.h"
#include "reference/key/answer_key.h"

namespace harness {

/// Reads a printout, at most as long as the default limit for a program's output. Throws UsageError.
std::string read_printout(const std::filesystem::path& file);

/// Marks a printout. Throws UsageError for a file that is not an output of this assignment, e.g. a source whose string
/// literals look like answers.
Score mark_printout(const std::filesystem::path& file, const std::string& output, const reference::AnswerKey& key,
                    const reference::Assignment& assignment);

}  // namespace harness
