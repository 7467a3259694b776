// What is taken in from a class, and whose it is.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "harness/intake/intake.h"

/// By id.
inline std::map<std::string, harness::Submission> take(const std::filesystem::path& path) {
    std::map<std::string, harness::Submission> taken;
    for (const harness::Submission& submission : harness::take_in(path)) taken[submission.id] = submission;
    return taken;
}

inline std::vector<std::string> ids(const std::vector<harness::Submission>& submissions) {
    std::vector<std::string> all;
    for (const auto& submission : submissions) all.push_back(submission.id);
    return all;
}

inline std::vector<std::string> ids(const std::map<std::string, harness::Submission>& submissions) {
    std::vector<std::string> all;
    for (const auto& [id, submission] : submissions) all.push_back(id);
    return all;
}
