// The command line: help, exit status, the reference run, a student's check, and equal results for every -j.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(CommandLine, RefusesAnUnknownOptionAsAUsageError) {
    const Result result = raygrade({"grade", "--colour", "."});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("--colour: is no option"));
    EXPECT_EQ(result.output, "");
    EXPECT_THAT(raygrade({"grade", ".", "--assigment", "a6-2021"}).voice,
                testing::AllOf(HasSubstr("--assigment: is no option; did you mean --assignment?"),
                               HasSubstr("raygrade grade --help")));
    EXPECT_THAT(raygrade({"assignment", "deal", "a6-2021", "class.csv", "--sead", "2"}).voice,
                testing::AllOf(HasSubstr("did you mean --seed?"), HasSubstr("raygrade assignment deal --help")));
    EXPECT_THAT(raygrade({"--versoin"}).voice, HasSubstr("--versoin: is no option; did you mean --version?"));
    const Result version = raygrade({"--version"});
    EXPECT_THAT(version.output, testing::ContainsRegex("^raygrade [0-9]+\\.[0-9]+\\.[0-9]+"));
    EXPECT_EQ(raygrade({"-V"}).output, version.output);
    EXPECT_THAT(raygrade({"check", "one.cpp", "two.cpp"}).voice, HasSubstr("two.cpp: is one word too many"));
}

TEST(CommandLine, NamesAnUnknownCommandAndSimilarCommands) {
    const Result result = raygrade({"grde", "submissions"});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, testing::AllOf(HasSubstr("grde: is no command"),
                                             HasSubstr("did you mean grade? `raygrade --help` says")));
    EXPECT_THAT(raygrade({"elp"}).voice, HasSubstr("raygrade --help"));
    const Result below = raygrade({"assignment", "chek", "a6-2021"});
    EXPECT_EQ(below.status, usage);
    EXPECT_THAT(below.voice, HasSubstr("chek: is no command; did you mean check? `raygrade assignment --help` says"));
}

TEST(CommandLine, HelpTellsOfACommandAsItsOwnHelpDoes) {
    EXPECT_EQ(raygrade({"help", "grade"}).output, raygrade({"grade", "--help"}).output);
    EXPECT_EQ(raygrade({"help", "assignment", "deal"}).output, raygrade({"assignment", "deal", "--help"}).output);
}

TEST(CommandLine, HelpListsItsTopics) {
    const Result result = raygrade({"help"});
    EXPECT_EQ(result.status, 0) << result.both();
    for (const char* topic : {"  grade ", "  assignment ", "  limits "}) EXPECT_THAT(result.output, HasSubstr(topic));
    for (const auto& page :
         fs::exists(project_folder() / "harness/manual")
             ? std::vector<fs::directory_entry>(fs::directory_iterator(project_folder() / "harness/manual"), {})
             : std::vector<fs::directory_entry>{}) {
        if (page.path().extension() != ".md") continue;
        const std::string name = page.path().stem().string();
        EXPECT_THAT(result.output, HasSubstr("  " + name + " "));
        EXPECT_EQ(raygrade({"help", name}).status, 0) << name;
    }
}

TEST(CommandLine, TheLimitsAreATopicAndInNoCommandsHelp) {
    EXPECT_THAT(raygrade({"help", "limits"}).output, HasSubstr("  run.cpu_seconds           2  "));
    for (const char* command : {"grade", "check", "serve", "stress"}) {
        const std::string help = raygrade({command, "--help"}).output;
        EXPECT_THAT(help, testing::AllOf(Not(HasSubstr("compile.stack_mib")), HasSubstr("raygrade help limits")))
            << command;
    }
}

TEST(CommandLine, HelpNamesTopicsLikeAnUnknownOne) {
    const Result result = raygrade({"help", "limts"});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("limts: is no topic; did you mean limits?"));
    const Result none = raygrade({"help", "zzzzzzzzzz"});
    EXPECT_EQ(none.status, usage);
    for (const char* topic : {"grade", "limits", "mistakes", "sandbox-and-limits", "self-check-page"})
        EXPECT_THAT(none.voice, HasSubstr(topic));
}

TEST(CommandLine, HelpRefusesOddWords) {
    for (const std::string odd : {"", "a", "?", ".", "..", "../README", "/etc/passwd", "%s%n", "{}", "`ls`", ".md",
                                  "\x1b[31mred", "\xff\xfe"}) {
        const Result result = raygrade({"help", odd});
        EXPECT_EQ(result.status, usage) << odd;
        EXPECT_THAT(result.voice, testing::AllOf(HasSubstr("is no topic"), Not(HasSubstr("\x1b")))) << odd;
    }
}

TEST(CommandLine, HelpListsTheNamedMistakesByItem) {
    const std::string all = raygrade({"help", "mistakes"}).output;
    EXPECT_THAT(all, testing::AllOf(HasSubstr("\n6.t (sphere.t)\n"), HasSubstr("\n  far root "),
                                    HasSubstr("\ncylinder."), HasSubstr("\n  radius not squared ")));
    EXPECT_LT(all.find("3.M_VCS_to_WCS"), all.find("6.t (sphere.t)"));
}

TEST(CommandLine, RefusesNoCommandAsAUsageError) {
    const Result result = raygrade({});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.output, HasSubstr("raygrade grade class/")) << "help";
}

TEST(CommandLine, RequiresJobsToBeAboveZero) {
    for (const char* jobs : {"0", "-1", "many"}) {
        const TemporaryFolder folder;
        const Result result =
            raygrade({"grade", sample("ada").string(), "--out", (folder / "out").string(), "-j", jobs});
        EXPECT_EQ(result.status, usage) << "-j " << jobs << "\n" << result.both();
    }
}

TEST(ReferenceRun, TellsAConventionOnceWithTheItemsThatItChanges) {
    const auto off_axis = project_folder() / "tests/given/labelled/offaxis/assignment.toml";
    const Result result = raygrade({"reference", "--assignment", off_axis.string()});
    EXPECT_EQ(result.status, 0) << result.both();
    std::size_t notes = 0;
    for (std::size_t at = result.voice.find("grid pixel convention"); at != std::string::npos;
         at = result.voice.find("grid pixel convention", at + 1))
        ++notes;
    EXPECT_EQ(notes, 1U) << result.voice;
    EXPECT_THAT(result.voice, HasSubstr("note: 1.P_VCS, 4.P_WCS, "));
    EXPECT_THAT(result.voice, HasSubstr(" have another right answer: the rubric accepts the grid pixel convention\n"));
}

TEST(ReferenceRun, AlsoPrintsJson) {
    for (const char* assignment : {"a6-2021", "a6-edge"}) {
        for (const char* precision : {"float", "double"}) {
            const Result result =
                raygrade({"reference", "--assignment", assignment, "--precision", precision, "--format", "json"});
            ASSERT_EQ(result.status, 0) << result.both();
            const json key = json::parse(result.output);
            EXPECT_EQ(key.at("schema"), "raygrade/key/1");
            EXPECT_EQ(key.at("assignment"), assignment);
            EXPECT_EQ(key.at("precision"), precision);
            EXPECT_EQ(key.at("questions").size(), 10U);
        }
    }
}

TEST(Check, RefusesAMissingFile) {
    const Result result = raygrade({"check", "/nowhere/ray_cast.cpp"});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("/nowhere/ray_cast.cpp"));
}

/// grades.json without measured times and memory.
json without_measurements(json grades) {
    for (json& submission : grades.at("submissions")) {
        submission["build"].erase("seconds");
        for (const char* measured : {"cpu_seconds", "wall_seconds", "peak_memory_bytes"}) {
            submission["run"].erase(measured);
        }
    }
    return grades;
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        if (!entry.is_regular_file() || name == "gradebook.sqlite") continue;  // it contains times
        files[name] =
            name == "grades.json" ? without_measurements(read_json(entry.path())).dump(1) : read(entry.path());
    }
    return files;
}

TEST(Grade, GivesTheSameResultsWhateverTheNumberOfJobs) {
    const TemporaryFolder folder;
    const std::vector<std::string> students = {"wei", "mateo", "ada", "o'brien", "priya", "zoë", "nadia", "jin"};
    std::map<std::string, std::string> alone;
    for (const std::string jobs : {"1", "4"}) {
        std::vector<std::string> arguments = {"grade", "--assignment",          "a6-2021", "-j", jobs,
                                              "--out", (folder / jobs).string()};
        for (const std::string& who : students) arguments.push_back(sample(who).string());
        const Result result = raygrade_from_scratch(arguments);
        ASSERT_EQ(result.status, 0) << result.both();
        if (jobs == "1") alone = files_in(folder / jobs);
    }
    EXPECT_EQ(alone, files_in(folder / "4"));

    const json grades = json::parse(alone.at("grades.json"));
    std::vector<std::string> order;
    for (const json& submission : grades.at("submissions")) order.push_back(submission.at("id"));
    EXPECT_EQ(order, students) << "reports come in the order given";
}

/// For a run whose output nobody takes: a pipe without a reader.
bool talk_to_nobody() {
    int ends[2];
    return pipe(ends) == 0 && close(ends[0]) == 0 && dup2(ends[1], STDOUT_FILENO) >= 0;
}

/// For a run whose output goes to a full disk.
bool talk_to_a_full_disk() {
    const int full = open("/dev/full", O_WRONLY);
    return full >= 0 && dup2(full, STDOUT_FILENO) >= 0;
}

TEST(Grade, WritesItsResultsIfNobodyReadsWhatItShows) {
    const TemporaryFolder folder;
    write(folder / "class/ada/ray_cast.cpp", small_program);
    const auto grade_into = [&](const char* name, const Preparation& prepare) {
        return raygrade({"grade", (folder / "class").string(), "--out", (folder / name).string()}, prepare);
    };
    const Result unread = grade_into("unread", talk_to_nobody);
    EXPECT_EQ(unread.status, 128 + SIGPIPE) << unread.voice;
    EXPECT_THAT(unread.voice, Not(HasSubstr("fault")));
    const Result full = grade_into("full", talk_to_a_full_disk);
    EXPECT_EQ(full.status, some_not_graded);
    EXPECT_THAT(full.voice, HasSubstr("stdout can't be written to"));
    for (const char* name : {"unread", "full"}) {
        EXPECT_TRUE(fs::exists(folder / name / "grades.json")) << name;
        EXPECT_TRUE(fs::exists(folder / name / "gradebook.sqlite")) << name;
        EXPECT_TRUE(fs::exists(folder / name / "feedback/ada.html")) << name;
    }
}

TEST(Grade, SaysThatAFileIsAtItsLimit) {
    const TemporaryFolder folder;
    write(folder / "class/ada/ray_cast.cpp", small_program);
    const Result result = raygrade({"grade", (folder / "class").string(), "--out", (folder / "out").string()}, [] {
        const rlimit small{20 << 10U, 20 << 10U};
        return setrlimit(RLIMIT_FSIZE, &small) == 0;
    });
    EXPECT_EQ(result.status, some_not_graded);
    EXPECT_THAT(result.voice, HasSubstr("raygrade: "));
}

TEST(Check, FailsUnderTheShareAndNotAtIt) {
    const TemporaryFolder folder;
    write(folder / "ray_cast.cpp", small_program);  // 10 of 100
    const auto status = [&](const char* share) {
        return raygrade({"check", (folder / "ray_cast.cpp").string(), "--fail-under", share}).status;
    };
    EXPECT_EQ(status("10"), 0);
    EXPECT_EQ(status("10.01"), some_not_graded);
    EXPECT_EQ(status("nan"), usage);
    EXPECT_EQ(status("101"), usage);
}

TEST(CommandLine, TakesNoNegativeSeed) {
    EXPECT_EQ(raygrade({"accuracy", "-n", "-1"}).status, usage);
    EXPECT_EQ(raygrade({"assignment", "propose", "a6-2021", "--seed", "-1"}).status, usage);
}

TEST(Grade, QuietlySaysOnlyWhereTheResultsAre) {
    const TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const Result result = raygrade({"grade", sample("ada").string(), "--quiet", "--out", out});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, testing::StartsWith("\nresults: " + out));
    EXPECT_THAT(result.voice, testing::MatchesRegex("(note: programs run in [^\n]*\n)?"))
        << "at most that the strongest sandbox does not hold here";
    write(folder / "class/bob/notes.cpp.txt", "");
    const Result ungraded = raygrade({"grade", (folder / "class").string(), "--quiet", "--out", out + "2"});
    EXPECT_THAT(ungraded.output, testing::StartsWith("\n1 of 1 to review")) << "this needs a person";
}

TEST(Check, PrintsJsonForPrograms) {
    const Result result = raygrade({"check", (sample("dmitri") / "ray_cast.cpp").string(), "--json"});
    EXPECT_EQ(result.status, 0) << result.both();
    const json checked = json::parse(result.output);
    EXPECT_EQ(checked.at("schema"), "raygrade/check/1");
    EXPECT_EQ(checked.at("questions").at(1).at("verdict"), "wrong");
}

}  // namespace
}  // namespace scenario
