// A class in a gradebook, for tests.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/gradebook.h"
#include "tests/temporary_folder.h"

namespace saved_class {

harness::Run a_run(const std::string& when = "2026-11-22T09:30:00Z");

/// Compares and saves, as a command does.
harness::Gradebook::Comparison save(const std::filesystem::path& folder, std::vector<harness::Graded> all,
                                    const std::vector<harness::KeptInput>& inputs = {});

/// One with a mistake, one who answered nothing, one not graded.
std::vector<harness::Graded> three();

std::filesystem::path file_in(const TemporaryFolder& folder);

/// The rows of a query as python3 reads them, which knows nothing of ours.
nlohmann::json rows(const TemporaryFolder& folder, const std::string& query);

}  // namespace saved_class
