// A class in a gradebook, for tests.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/gradebook/gradebook.h"
#include "harness/gradebook/run.h"
#include "tests/given/temporary_folder.h"

namespace saved_class {

harness::Run a_run(const std::string& when = "2026-11-22T09:30:00Z");

/// Compares the class with the gradebook and saves it, as a command does.
harness::Gradebook::Comparison save(const std::filesystem::path& folder, std::vector<harness::Graded> all,
                                    const std::vector<harness::KeptInput>& inputs = {});

/// Three submissions: one with a mistake, one without any answer, one not graded.
std::vector<harness::Graded> three();

std::filesystem::path file_in(const TemporaryFolder& folder);

/// The rows of a query, read independently by python3.
nlohmann::json rows(const TemporaryFolder& folder, const std::string& query);

}  // namespace saved_class
