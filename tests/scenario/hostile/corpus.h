// The hostile submissions, and the outcome that each must have.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hostile {

struct Attack {
    std::string name;                   ///< the folder's name
    std::filesystem::path folder;       ///< submissions/hostile/<name>
    std::string tries;                  ///< <what> of the first line
    std::vector<std::string> outcomes;  ///< the fair outcomes, named as in grades.json; empty if the first line is not
                                        ///< "// Tries: <what>. Outcome: <outcome>[ or <outcome>]."
};

/// Sorted by name.
std::vector<Attack> read_corpus(const std::filesystem::path& folder);

}  // namespace hostile
