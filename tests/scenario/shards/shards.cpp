#include "tests/scenario/shards/shards.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <string>

namespace scenario {
namespace {

namespace fs = std::filesystem;

/// Puts the same word for every time of the clock.
std::string without_moments(const std::string& text) {
    static const std::regex moment("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z");
    return std::regex_replace(text, moment, "(moment)");
}

/// Every row of every table, a line each.
std::string rows_of(const fs::path& gradebook) {
    SQLite::Database database(gradebook.string());
    std::string text;
    SQLite::Statement tables(database, "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
    while (tables.executeStep()) {
        const std::string table = tables.getColumn(0).getString();
        SQLite::Statement rows(database, "SELECT * FROM " + table);
        while (rows.executeStep()) {
            text += table + ":";
            for (int i = 0; i < rows.getColumnCount(); ++i) text += " | " + rows.getColumn(i).getString();
            text += '\n';
        }
    }
    return without_moments(text);
}

}  // namespace

std::map<std::string, std::string> files_of(const fs::path& results) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(results)) {
        if (!entry.is_regular_file()) continue;
        const fs::path& file = entry.path();
        const bool is_gradebook = file.filename() == "gradebook.sqlite";
        files[file.lexically_relative(results).string()] = is_gradebook ? rows_of(file) : without_moments(read(file));
    }
    return files;
}

void expect_same(const fs::path& one, const fs::path& other) {
    const auto expected = files_of(one), found = files_of(other);
    for (const auto& [name, content] : expected) {
        ASSERT_TRUE(found.contains(name)) << name;
        EXPECT_TRUE(found.at(name) == content) << name << " differs";
    }
    EXPECT_EQ(found.size(), expected.size());
}

}  // namespace scenario
