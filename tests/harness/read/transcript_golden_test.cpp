// The golden transcripts: outputs of students, and an experienced marker's reading of them in parsed.txt. If a test
// fails, assume that the reader is wrong, not parsed.txt, until a person has checked.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "tests/given/bytes_of.h"
#include "tests/given/parsed.h"

namespace {

struct Case {
    std::string name;
    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const auto& entry : std::filesystem::directory_iterator(RAYGRADE_PROJECT "/tests/given/transcripts")) {
        cases.push_back({entry.path().filename()});
    }
    std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.name < b.name; });
    return cases;
}

class Golden : public testing::TestWithParam<Case> {};

TEST_P(Golden, MatchesTheMarkersReading) {
    const std::filesystem::path folder =
        std::filesystem::path(RAYGRADE_PROJECT "/tests/given/transcripts") / GetParam().name;
    EXPECT_EQ(parsed(bytes_of(folder / "output.txt")), bytes_of(folder / "parsed.txt"));
}

INSTANTIATE_TEST_SUITE_P(Transcript, Golden, testing::ValuesIn(all_cases()), [](const auto& instance) {
    std::string name = instance.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(Goldens, CoverAtLeastSixtyLayouts) {
    EXPECT_GE(all_cases().size(), 60U);
}

}  // namespace
