// The files for other systems, requested on the command line.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/given/packed.h"
#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class Exchange : public testing::Test {
  protected:
    Exchange() { write(source(), small_program); }

    fs::path source() const { return folder / "handed-in/ray_cast.cpp"; }
    Result check(const std::vector<std::string>& options, const Preparation& prepare = {}) const {
        std::vector<std::string> arguments = {"check", source().string(), "--assignment", "a6-2021"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return raygrade(arguments, prepare);
    }
    Result grade(const fs::path& class_, const std::vector<std::string>& options) const {
        std::vector<std::string> arguments = {"grade", class_.string(), "--assignment", "a6-2021",
                                              "--out", out().string(),  "--apply"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return raygrade(arguments);
    }
    fs::path out() const { return folder / "out"; }

    TemporaryFolder folder;
};

bool set_classroom50() {
    return setenv("CLASSROOM", "cs770", 1) == 0 && setenv("ASSIGNMENT", "ray-casting", 1) == 0 &&
           setenv("SUBMISSION_TAG", "submit/2026-06-01T14-32-05Z-a1b2c3d", 1) == 0 &&
           setenv("COMMIT_URL", "https://example.org/commit/a1", 1) == 0 &&
           setenv("RELEASE_URL", "https://example.org/releases/s", 1) == 0 && setenv("USERNAME", "alice", 1) == 0 &&
           unsetenv("OWNER") == 0 && unsetenv("REVIEW_URL") == 0 && unsetenv("ASSIGNMENT_TYPE") == 0;
}

bool unset_classroom50() {
    return set_classroom50() && unsetenv("CLASSROOM") == 0 && unsetenv("RELEASE_URL") == 0;
}

TEST_F(Exchange, AnUngradedSubmissionHasNoScoreAnywhere) {
    write(source(), std::string(std::size_t{2} << 20U, '/'));
    write(folder / "result.json", R"({"score": 100, "schema": "classroom50/result/v1", "owner": "forged by eve"})");
    const Result result = check({"--gradescope", (folder / "results.json").string(), "--classroom50",
                                 (folder / "result.json").string(), "--junit", (folder / "junit.xml").string()},
                                set_classroom50);
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    EXPECT_FALSE(read_json(folder / "results.json").contains("score"));
    EXPECT_FALSE(fs::exists(folder / "result.json"));
    EXPECT_THAT(read(folder / "junit.xml"), HasSubstr("<error message="));
}

TEST_F(Exchange, GradescopesStudentsAreToldWhyNothingWasGraded) {
    const fs::path results = folder / "results.json";
    write(folder / "empty/notes.txt", "sorry");
    const Result nothing = raygrade({"check", (folder / "empty").string(), "--gradescope", results.string()});
    EXPECT_EQ(nothing.status, some_not_graded);
    EXPECT_THAT(read_json(results).at("output").get<std::string>(),
                AllOf(HasSubstr("There is \"notes.txt\", but no C++ source"),
                      HasSubstr("Hand in one file named ray_cast.cpp.")));
    EXPECT_FALSE(read_json(results).contains("score"));

    const Result failed = check({"--gradescope", results.string(), "--sandbox", "bwrap"}, forget_path);
    EXPECT_EQ(failed.status, some_not_graded) << failed.both();
    EXPECT_THAT(failed.voice, HasSubstr("No sandbox works")) << "the instructor sees the reason";
    EXPECT_THAT(read_json(results).at("output").get<std::string>(), HasSubstr("The grader failed, not your program."));
    EXPECT_FALSE(read_json(results).contains("score"));
}

TEST_F(Exchange, NamesMissingVariablesOfClassroom50) {
    const fs::path file = folder / "result.json";
    const Result result = check({"--classroom50", file.string()}, unset_classroom50);
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("CLASSROOM, RELEASE_URL"));
    EXPECT_FALSE(fs::exists(file));
}

TEST_F(Exchange, DoesNotOverwriteOrRemoveAForeignFile) {
    const std::string pom = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<project><name>pom</name></project>\n";
    const std::string of_pytest = "<?xml version=\"1.0\"?>\n<testsuites><testsuite name=\"pytest\"/></testsuites>\n";
    const std::string package = "{\"name\": \"package\", \"schema\": \"npm\"}\n";
    for (const std::string option : {"--gradescope", "--classroom50", "--junit"}) {
        for (const std::string& foreign : {pom, of_pytest, package, std::string()}) {
            const fs::path file = folder / "theirs.xml";
            write(file, foreign);
            const Result over = check({option, file.string()}, set_classroom50);
            EXPECT_EQ(over.status, usage) << over.both();
            EXPECT_THAT(over.voice, HasSubstr("theirs.xml exists and is not a "));
            EXPECT_EQ(read(file), foreign) << option;
        }
        const Result over = check({option, source().string()}, set_classroom50);
        EXPECT_EQ(over.status, usage) << over.both();
        EXPECT_EQ(read(source()), small_program);
    }
    const fs::path file = folder / "pom.xml";
    write(file, pom);
    EXPECT_EQ(raygrade({"check", (folder / "nosuch.cpp").string(), "--junit", file.string()}).status, usage);
    EXPECT_EQ(read(file), pom);
    EXPECT_THAT(check({"--gradescope", "/nowhere/results.json"}).voice, HasSubstr("/nowhere/results.json"));
}

TEST_F(Exchange, DoesNotFollowALinkInAStudentsCheckout) {
    write(folder / "precious.json", "precious");
    fs::create_symlink(folder / "precious.json", folder / "results.json");
    const std::vector<std::string> options = {"--gradescope", (folder / "results.json").string()};
    const Result refused = check(options);
    EXPECT_EQ(refused.status, usage);
    EXPECT_THAT(refused.voice, HasSubstr("results.json exists and is not a results.json for Gradescope"));

    fs::remove(folder / "results.json");
    fs::create_symlink(folder / "precious.json", folder / "results.json.raygrade-new");
    EXPECT_EQ(check(options).status, 0);
    EXPECT_EQ(read(folder / "precious.json"), "precious");
    EXPECT_EQ(read_json(folder / "results.json").at("score"), 10);
}

TEST_F(Exchange, AnEarlierReportIsRemovedIfNoNewOneIsWritten) {
    const fs::path result = folder / "result.json", junit = folder / "junit.xml", foreign = folder / "foreign.json";
    const std::vector<std::string> options = {"--classroom50", result.string(), "--junit", junit.string()};
    EXPECT_EQ(check(options, set_classroom50).status, 0);
    EXPECT_EQ(check(options, set_classroom50).status, 0) << "its own earlier ones are replaced";
    EXPECT_EQ(read_json(result).at("owner"), "alice") << "without OWNER";
    EXPECT_EQ(read_json(result).at("review"), read_json(result).at("commit")) << "without REVIEW_URL";

    write(foreign, "theirs");
    std::vector<std::string> refused = options;
    refused.insert(refused.end(), {"--gradescope", foreign.string()});
    EXPECT_EQ(check(refused, set_classroom50).status, usage);
    EXPECT_TRUE(fs::exists(result) && fs::exists(junit)) << "a place that is refused leaves all as it is";

    fs::remove(source());
    EXPECT_EQ(check(options, set_classroom50).status, usage);
    EXPECT_FALSE(fs::exists(result) || fs::exists(junit)) << "they would be taken for those of this hand-in";
}

TEST_F(Exchange, AMoodleClassGoesBackToMoodle) {
    const fs::path download =
        pack(folder / "class.zip", {{"Jane Doe_11_assignsubmission_file/ray_cast.cpp", std::string(small_program)},
                                    {"Rick Roe_12_assignsubmission_file/notes.txt", "sorry"}});
    const std::string head = "Identifier,Full name,Grade,Maximum grade,Last modified (grade)\n";
    write(folder / "worksheet.csv", head +
                                        "Participant 11,Jane Doe,,100.00,-\n"
                                        "Participant 12,Rick Roe,,100.00,-\n"
                                        "Participant 13,Pat Poe,7.00,100.00,-\n");
    const Result result = grade(download, {"--moodle-worksheet", (folder / "worksheet.csv").string()});
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    EXPECT_EQ(read(out() / "grades-moodle.csv"), head +
                                                     "Participant 11,Jane Doe,10.00,100.00,-\n"
                                                     "Participant 12,Rick Roe,,100.00,-\n"
                                                     "Participant 13,Pat Poe,7.00,100.00,-\n");
    EXPECT_THAT(result.output, HasSubstr("grades-moodle.csv, 1 filled in\n"));
    EXPECT_THAT(result.output, HasSubstr("  not graded, left out: Rick Roe\n"));
    EXPECT_THAT(result.output, HasSubstr("  no submission, unchanged: Pat Poe\n"));
    EXPECT_THAT(result.output, HasSubstr("feedback.zip, 2 pages\n"));
    EXPECT_TRUE(fs::exists(out() / "feedback.zip"));

    // A run removes a file of an earlier run that it does not write itself.
    EXPECT_EQ(grade(source().parent_path(), {}).status, 0);
    EXPECT_EQ(read(out() / "grades-moodle.csv"), read(folder / "worksheet.csv")) << "the worksheet is kept";
    EXPECT_FALSE(fs::exists(out() / "feedback.zip"));
}

TEST_F(Exchange, ARosterGivesNamesAndTheirOrder) {
    for (const char* login : {"al", "jd", "mr"}) write(folder / "class" / login / "ray_cast.cpp", small_program);
    write(
        folder / "roster.csv",
        "Student,ID,SIS User ID,SIS Login ID,Section,Six (6)\n\"de Vries, Al\",1,s1,al,01,\n\"Doe, Jane\",2,s2,jd,01,\n"
        "\"Abe, Max\",3,s3,mr,01,\n");
    const Result named = grade(folder / "class", {"--canvas-roster", (folder / "roster.csv").string()});
    ASSERT_EQ(named.status, 0) << named.both();
    EXPECT_LT(named.output.find("\nAbe, Max"), named.output.find("\nde Vries, Al"));
    EXPECT_LT(named.output.find("\nde Vries, Al"), named.output.find("\nDoe, Jane"));
    EXPECT_THAT(read(out() / "report.html"), HasSubstr(">Abe, Max</a></th><td class=\"id\">mr</td>"));
    EXPECT_THAT(read(out() / "feedback/jd.html"), HasSubstr(">Doe, Jane, ray_cast.cpp</p>"));

    const Result given = raygrade({"override", "Doe, Jane", "5.V", "3", "--why", "so", "--results", out().string()});
    EXPECT_EQ(given.status, 0) << given.both();
    EXPECT_THAT(given.output, HasSubstr("jd 5.V: 3 of 10"));
    EXPECT_THAT(read(out() / "report.html"), HasSubstr(">Doe, Jane</a></th><td class=\"id\">jd</td>"));
}

TEST_F(Exchange, ARosterWithMostGroupMembersIsAccepted) {
    std::string yaml, worksheet = "Identifier,Full name,Grade,Maximum grade\n";
    std::vector<PackedEntry> entries;
    for (int group = 1; group <= 3; ++group) {
        entries.push_back({fmt::format("class/submission_{}/ray_cast.cpp", group), std::string(small_program)});
        yaml += fmt::format("submission_{}:\n  :submitters:\n", group);
        for (int member = 1; member <= 4; ++member)
            yaml += fmt::format("  - :name: Member {0}{1}\n    :sid: s{0}{1}\n", group, member);
        worksheet += fmt::format("Participant {0},Member {0}1,,100.00\n", group);
    }
    entries.push_back({"class/submission_metadata.yml", yaml});
    write(folder / "worksheet.csv", worksheet);
    const Result result =
        grade(pack(folder / "class.zip", entries), {"--moodle-worksheet", (folder / "worksheet.csv").string()});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr("3 filled in"));
}

TEST_F(Exchange, AnUnusableListIsReportedBeforeGrading) {
    const fs::path worksheet = folder / "worksheet.csv";
    const auto told = [&](const std::vector<std::string>& options) {
        const Result result = grade(source().parent_path(), options);
        EXPECT_EQ(result.status, usage) << result.both();
        EXPECT_FALSE(fs::exists(out()));
        return result.voice;
    };
    EXPECT_THAT(told({"--moodle-worksheet", "/nowhere/w.csv"}), HasSubstr("cannot read /nowhere/w.csv: No such"));
    EXPECT_THAT(told({"--moodle-worksheet", folder.path().string()}), HasSubstr("cannot read "));
    write(worksheet, "Name,Points\nJane,1\n");
    EXPECT_THAT(told({"--moodle-worksheet", worksheet.string()}),
                HasSubstr("worksheet.csv has no column \"Identifier\""));
    EXPECT_THAT(told({"--moodle-column", "grade=Note"}), HasSubstr("--moodle-worksheet"));
    EXPECT_THAT(told({"--canvas-column", "Assignment 6"}), HasSubstr("with --canvas-roster"));
}

}  // namespace
}  // namespace scenario
