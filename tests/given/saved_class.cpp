#include "tests/given/saved_class.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "tests/given/report/graded_samples.h"

namespace saved_class {

using namespace harness;
using namespace report_samples;
using nlohmann::json;

Run a_run(const std::string& when) {
    return {0, {"ada", when}, "0.7.0", "a6-2021", "/a6-2021.toml", "title = \"x\"\n", Tier::landlock};
}

Gradebook::Comparison save(const std::filesystem::path& folder, std::vector<Graded> all,
                           const std::vector<KeptInput>& inputs) {
    Gradebook gradebook(folder);
    std::vector<Submission> submissions;
    for (const Graded& one : all) submissions.push_back(one.submission);
    gradebook.go_by_number(submissions);
    attach(gradebook.overrides(), all);
    auto comparison = gradebook.compare(all);
    gradebook.save(a_run(), all, comparison, inputs);
    return comparison;
}

std::vector<Graded> three() {
    return {graded("ada", output_with_a_mistake()), graded("ben", ""), not_graded("cy")};
}

std::filesystem::path file_in(const TemporaryFolder& folder) {
    return folder.path() / gradebook_name;
}

json rows(const TemporaryFolder& folder, const std::string& query) {
    const auto script = folder.write("rows.py",
                                     "import json, sqlite3, sys\n"
                                     "book = sqlite3.connect(sys.argv[1])\n"
                                     "assert book.execute('PRAGMA integrity_check').fetchone()[0] == 'ok'\n"
                                     "print(json.dumps([list(row) for row in book.execute(sys.argv[2])]))\n");
    const std::string command =
        "python3 '" + script.string() + "' '" + file_in(folder).string() + "' \"" + query + "\"";
    FILE* pipe = popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer{};
    while (const std::size_t got = fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), got);
    EXPECT_EQ(pclose(pipe), 0) << "python3 can't read it";
    return json::parse(text);
}

}  // namespace saved_class
