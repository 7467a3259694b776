// The golden transcripts: what students print, and what an experienced marker reads there. parsed.txt is that marker's
// reading, so where a test fails it is the reader that is wrong, until a person has found otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "tests/bytes_of.h"
#include "tests/parsed.h"

namespace {

struct Case {
    std::string name;
    friend std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }
};

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    for (const auto& entry : std::filesystem::directory_iterator(RAYGRADE_TRANSCRIPTS)) {
        cases.push_back({entry.path().filename()});
    }
    std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.name < b.name; });
    return cases;
}

class Golden : public testing::TestWithParam<Case> {};

TEST_P(Golden, IsReadAsAMarkerReadsIt) {
    const std::filesystem::path folder = std::filesystem::path(RAYGRADE_TRANSCRIPTS) / GetParam().name;
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
