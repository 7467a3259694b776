// The submitters in a Gradescope export: as Gradescope writes them, and in damaged or hostile files.
#include "harness/intake/lms/gradescope_metadata.h"

#include <gmock/gmock.h>

#include <string>

namespace harness {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

TEST(GradescopeMetadata, SaysWhenEachWasSubmitted) {
    const auto read = read_gradescope_metadata(
        "submission_1:\n  :created_at: 2026-10-09 21:26:33.000000000 Z\n  :submitters:\n  - :name: Jane Doe\n"
        "submission_2:\n  :submitters:\n  - :name: John Roe\n"
        "submission_3:\n  :created_at: {utc: 2026-10-09}\n  :submitters:\n  - :name: Mary Moe\n");
    EXPECT_TRUE(read.submitters.contains("submission_3")) << "whatever its time";
    EXPECT_THAT(read.created_at, ElementsAre(Pair("submission_1", "2026-10-09 21:26:33.000000000 Z")));
}

/// "name/sid/email" of each submitter.
std::vector<std::string> told(const std::vector<Submitter>& submitters) {
    std::vector<std::string> texts;
    for (const Submitter& one : submitters) texts.push_back(one.name + '/' + one.sid + '/' + one.email);
    return texts;
}

/// Why submission_1 has no submitters, although the valid submission_2 in the same file has.
std::string problem_with(const std::string& of_the_first) {
    const auto read = read_gradescope_metadata("submission_1:" + of_the_first +
                                               "\nsubmission_2:\n  :submitters:\n  - :name: Jane Doe\n");
    EXPECT_EQ(read.problem, std::nullopt);
    EXPECT_FALSE(read.submitters.contains("submission_1"));
    EXPECT_TRUE(read.submitters.contains("submission_2")) << of_the_first;
    const auto problem = read.problems.find("submission_1");
    return problem == read.problems.end() ? "none" : problem->second;
}

/// Why the whole file is unusable.
std::string problem_of(const std::string& yaml) {
    const auto read = read_gradescope_metadata(yaml);
    EXPECT_THAT(read.submitters, IsEmpty());
    return read.problem.value_or("none");
}

std::string times(std::size_t count, const std::string& text) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

constexpr const char* exported = R"(---
submission_901:
  :submitters:
  - :name: Jane Doe
    :sid: '0123'
    :email: jane@example.edu
  :created_at: 2018-10-09 15:20:41.207012000 Z
  :score: 30.0
  :status: processed
  :results:
    score: 30.0
    tests:
    - name: 'Question 1: {P_VCS}'
      output: "submitters:\n  - :name: Mallory\n"
    - [1, {name: Mallory}]
  :history:
  - :id: 17
    :submitters:
    - :name: Mallory
submission_902:
  :submitters:
  - :name: "Ży \"Ann\" Łukasz"
    :sid:
    :email: zy@example.edu
  - :name: ' John Roe '
    :sid: 77
)";

TEST(GradescopeMetadata, NamesTheSubmitters) {
    const auto read = read_gradescope_metadata(exported);
    EXPECT_EQ(read.problem, std::nullopt);
    EXPECT_THAT(read.problems, IsEmpty());
    ASSERT_EQ(read.submitters.size(), 2U);
    EXPECT_THAT(told(read.submitters.at("submission_901")), ElementsAre("Jane Doe/0123/jane@example.edu"));
    EXPECT_THAT(told(read.submitters.at("submission_902")),
                ElementsAre("Ży \"Ann\" Łukasz//zy@example.edu", "John Roe/77/"));
    EXPECT_EQ(names_of(read.submitters.at("submission_902")), "Ży \"Ann\" Łukasz, John Roe");
}

TEST(GradescopeMetadata, ReadsADifferentYamlStyle) {
    const auto read = read_gradescope_metadata(
        "{submission_1: {score: 1, submitters: [{name: Jane, odd: {name: x}, sid: &s '1'}, {name: Max, sid: *s}]}}");
    EXPECT_THAT(told(read.submitters.at("submission_1")), ElementsAre("Jane/1/", "Max/1/"));
}

TEST(GradescopeMetadata, SaysWhichSubmissionsHaveNoUsableName) {
    for (const char* entry :
         {"\n  :score: 3", "\n  :submitters: []", "\n  :submitters:\n  - :sid: '1'",
          "\n  :submitters:\n  - :name: Jane\n  - :name: ' '", " Jane Doe", "\n- Jane Doe", "\n  :submitters: Jane Doe",
          "\n  :submitters:\n    :name: Jane", "\n  :submitters:\n  - Jane", "\n  :submitters:\n  - [Jane]",
          "\n  :submitters:\n  - :name: Jane\n  - Max"})
        EXPECT_THAT(problem_with(entry), HasSubstr("does not name its students")) << entry;
    for (const char* name : {"[Jane]", "{first: Jane}"})
        EXPECT_THAT(problem_with(std::string("\n  :submitters:\n  - :name: ") + name), HasSubstr("not text"));
}

TEST(GradescopeMetadata, RejectsContradictingEntries) {
    const std::string jane = "\n  :submitters:\n  - :name: Jane";
    EXPECT_THAT(problem_with(jane + "\n  :submitters:\n  - :name: Max"), HasSubstr("names its students twice"));
    EXPECT_THAT(problem_with(jane + "\n    :name: Max"), HasSubstr("names its students twice"));
    EXPECT_THAT(problem_with(jane + "\nsubmission_1:" + jane), HasSubstr("mentions it twice"));
}

TEST(GradescopeMetadata, RejectsANameThatIsNotText) {
    const std::string begin = "\n  :submitters:\n  - :name: ";
    EXPECT_THAT(problem_with(begin + "Jane \xff\xfe"), HasSubstr("not text"));
    EXPECT_THAT(problem_with(begin + "\"Jane \\e[31m\""), HasSubstr("not text"));
    EXPECT_THAT(problem_with(begin + "\"Jane \\u202eeoD\""), HasSubstr("not text"));
    EXPECT_THAT(problem_with(begin + std::string(201, 'x')), HasSubstr("more than 200 bytes"));
    EXPECT_THAT(read_gradescope_metadata("submission_1:" + begin + std::string(200, 'x')).problems, IsEmpty());
    EXPECT_THAT(problem_with("\n  :submitters:" + times(51, "\n  - :name: Jane")), HasSubstr("more than 50"));
}

TEST(GradescopeMetadata, ExpandsNoAliasesOfLists) {
    std::string bomb = "a: &a [x, x]\n";
    for (char c = 'b'; c <= 'z'; ++c) {
        const char before = static_cast<char>(c - 1);
        bomb += std::string(1, c) + ": &" + c + " [" + times(9, std::string("*") + before + ", ") + "x]\n";
    }
    const auto read = read_gradescope_metadata(bomb + "submission_1:\n  :submitters: *z\n");
    EXPECT_THAT(read.submitters, IsEmpty());
    EXPECT_THAT(read.problems, testing::Contains(Pair("submission_1", HasSubstr("does not name its students"))));
    EXPECT_THAT(problem_of("submission_1: &x\n  :submitters: *y\n"), HasSubstr("not YAML from line 2 on"));
}

TEST(GradescopeMetadata, SaysWhyTheFileIsUnusable) {
    EXPECT_THAT(problem_of(""), HasSubstr("empty"));
    EXPECT_THAT(problem_of("- submission_1\n"), HasSubstr("contains no submissions"));
    EXPECT_THAT(problem_of("Jane Doe"), HasSubstr("contains no submissions"));
    EXPECT_THAT(problem_of("submission_1:\n  :submitters:\n\t- :name: x\n"), HasSubstr("not YAML from line 3 on"));
    EXPECT_THAT(problem_of(std::string("submission_1: \0\x01\xff%", 18)), testing::Not(HasSubstr("Jane")));
}

TEST(GradescopeMetadata, IsReadWithinBounds) {
    EXPECT_THAT(problem_of("a: " + times(600, "[") + times(600, "]") + "\n"), HasSubstr("not YAML from line 1"));
    EXPECT_THAT(problem_of("a:\n" + times(600, "- ") + "x\n"), HasSubstr("not YAML"));
    std::string submissions;
    for (int i = 0; i < 20'001; ++i) submissions += "submission_" + std::to_string(i) + ": x\n";
    EXPECT_THAT(problem_of(submissions), HasSubstr("more than 20,000"));
}

TEST(GradescopeMetadata, ReadsAFileWithManyResults) {
    std::string yaml;
    const std::string results = "  :results:\n    output: \"" + times(10'000, "abc ") + "\"\n";
    for (int i = 0; yaml.size() < std::size_t{8} << 20U; ++i)
        yaml += "submission_" + std::to_string(i) + ":\n  :submitters:\n  - :name: Jane\n" + results;
    const auto read = read_gradescope_metadata(yaml);
    EXPECT_EQ(read.problem, std::nullopt);
    EXPECT_GT(read.submitters.size(), 190U);
    EXPECT_THAT(read.problems, IsEmpty());
}

}  // namespace
}  // namespace harness
