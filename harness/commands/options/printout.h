// What a program printed, from a file that a command is given.
#pragma once

#include <filesystem>
#include <string>

#include "harness/mark/score/score.h"
#include "reference/key/answer_key.h"

namespace harness {

/// Reads a printout of at most the default limit of a program's output. Throws UsageError.
std::string read_printout(const std::filesystem::path& file);

/// Marks it. Throws UsageError for a file that no program of this assignment printed, e.g. a source whose string
/// literals look like answers.
Score mark_printout(const std::filesystem::path& file, const std::string& output, const reference::AnswerKey& key,
                    const reference::Assignment& assignment);

}  // namespace harness
