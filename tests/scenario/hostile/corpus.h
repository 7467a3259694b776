// The hostile submissions, and what each must come to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hostile {

struct Attack {
    std::string name;                   ///< of its folder
    std::filesystem::path folder;       ///< submissions/hostile/<name>
    std::string tries;                  ///< what its first line says
    std::vector<std::string> outcomes;  ///< each of them fair, named as in grades.json; empty when the line is not as
                                        ///< "// Tries: <what>. Outcome: <outcome>[ or <outcome>]."
};

/// By name.
std::vector<Attack> read_corpus(const std::filesystem::path& folder);

}  // namespace hostile
