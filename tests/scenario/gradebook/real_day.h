// The instructor's real day: a class whose marks are changed by hand and by a changed rubric.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {

inline constexpr std::string_view right =
    "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); }\n";
inline constexpr std::string_view wrong =
    "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.500000, 0.000000, -1.000000)\"); }\n";

/// A class of ada, who is right, and ben, who is wrong.
class RealDay : public testing::Test {
  protected:
    RealDay() {
        // If root runs the tests, the programs' accounts need access to this folder.
        std::filesystem::permissions(folder.path(), static_cast<std::filesystem::perms>(0755));
        write(students() / "ada/ray_cast.cpp", right);
        write(students() / "ben/ray_cast.cpp", wrong);
    }

    std::filesystem::path students() const { return folder / "class"; }
    std::filesystem::path out() const { return folder / "out"; }
    std::filesystem::path gradebook() const { return out() / "gradebook.sqlite"; }
    Result run(const std::vector<std::string>& words) const { return raygrade(words, with_cache(folder / "cache")); }
    Result grade(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words = {"grade", students().string(), "--out", out().string()};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    Result override_mark(const std::vector<std::string>& more) const {
        std::vector<std::string> words = {"override", "--results", out().string()};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    /// The assignment of 2021 with these lines added to its last table, [rubric].
    std::string rubric(const std::string& lines) const {
        const std::filesystem::path file = folder / "a6-2021.toml";
        write(file, read(project_folder() / "reference/assignments/a6-2021.toml") + "\n" + lines);
        return file.string();
    }
    nlohmann::json graded(const std::string& id) const { return submission_in(read_json(out() / "grades.json"), id); }
    double points(const std::string& id) const { return graded(id).at("points").get<double>(); }
    /// Every file of the results, with its bytes.
    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(out())) {
            if (entry.is_regular_file()) all[entry.path().string()] = read(entry.path());
        }
        return all;
    }
    int count(const std::string& query) const {
        return SQLite::Database(gradebook().string(), SQLite::OPEN_READONLY).execAndGet(query).getInt();
    }

    TemporaryFolder folder;
};

}  // namespace scenario
