// The command line: help, exit status, the reference run, a student's check, and equal results for every -j.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
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

TEST(CommandLine, NamesItsVersion) {
    const Result version = raygrade({"--version"});
    EXPECT_THAT(version.output, testing::ContainsRegex("^raygrade [0-9]+\\.[0-9]+\\.[0-9]+"));
    EXPECT_EQ(raygrade({"-V"}).output, version.output);
}

TEST(CommandLine, SaysWhatIsWrongAndWhatToDoNext) {
    const TemporaryFolder folder;
    const std::string notes = (folder / "notes.txt").string(), locked = (folder / "locked.txt").string();
    const std::string results = (folder / "results").string(), source = (folder / "ray_cast.cpp").string();
    const std::string huge = (folder / "huge.txt").string(), below = (folder / "no/such/a.svg").string();
    for (const std::string& file : {notes, locked, results + "/gradebook.sqlite", source}) write(file, "x");
    write(huge, std::string((1U << 20U) + 1, '\n'));
    const std::string assignment = read(project_folder() / "reference/assignments/a6-2021.toml");
    const auto assignment_with = [&](const char* name, const std::string& lines) {
        write(folder / name, assignment + "\n" + lines);
        return (folder / name).string();
    };
    const std::string extra = assignment_with("extra.toml", "variant_points = 20\n"),
                      limit = assignment_with("limit.toml", "[limits.run]\ncpu_second = 2\n"),
                      mistake = assignment_with("mistake.toml", "[rubric.mistakes]\n\"center forgoten\" = 1\n");
    fs::permissions(locked, fs::perms::none);
    const struct {
        std::vector<std::string> words;
        const char* problem;
    } mistakes[] = {
        {{"grde", "submissions"}, "unknown command \"grde\"; did you mean grade? See `raygrade --help`."},
        {{"elp"}, "raygrade --help"},
        {{"--versoin"}, "unknown option --versoin; did you mean --version?"},
        {{"help", "limts"}, "unknown topic \"limts\"; did you mean limits?"},
        {{"help", "zzzzzzzzzz"}, "sandbox-and-limits"},
        {{"grade"}, "grade needs a class to grade, e.g. raygrade grade class/ "},
        {{"grade", "nowhere"}, "Cannot find \"nowhere\": No such file or directory. Check the path"},
        {{"grade", notes}, "notes.txt\" is not a folder, a C++ source"},
        {{"grade", ".", "-x"}, "unknown option -x. See `raygrade grade --help`"},
        {{"grade", ".", "--assigment", "a6-2021"}, "unknown option --assigment; did you mean --assignment?"},
        {{"grade", source, "-a", extra}, "--variants 4"},
        {{"grade", ".", "-j", "abc"}, "abc is not a number from 1 to 1024 (--jobs). See"},
        {{"grade", ".", "-j", "0"}, "0 is not a number from 1 to 1024 (--jobs). See"},
        {{"grade", ".", "-j", "2.5"}, "2.5 is not a whole number (--jobs). See"},
        {{"grade", ".", "--out"}, "--out needs a value: --out DIR. See"},
        {{"grade", ".", "--out", "a", "--out", "b"}, "--out is given 2 times; give it once"},
        {{"grade", ".", "--sandbox", "none"}, "none is not one of {auto,bwrap,landlock} (--sandbox). See"},
        {{"grade", ".", "--shard", "1/2"}, "--shard also needs --out. See"},
        {{"grade", ".", "--apply=maybe"}, "--apply takes no value. See"},
        {{"grade", ".", "--late-days", locked}, "locked.txt: Permission denied; use the file as it was exported"},
        {{"check", source, "--limit", "run.cpu_seconds"}, "--limit run.cpu_seconds needs a value, e.g. --limit run."},
        {{"grade", ".", "-a", "a6-2012"}, "there is no assignment \"a6-2012\"; name a .toml file, or one of a6-2021"},
        {{"merge"}, "merge needs all parts of a class, e.g. raygrade merge parts/*.part"},
        {{"merge", results}, "results is a results folder; merge takes the .part files that grade --shard wrote"},
        {{"merge", locked}, "locked.txt cannot be read: Permission denied; name the files that grade --shard"},
        {{"merge", "nowhere"}, "nowhere does not exist; check the name"},
        {{"cluster"}, "cluster needs one of these commands: slurm, e.g. raygrade cluster slurm class/"},
        {{"cluster", "slurm"}, "slurm needs a class to grade, e.g. raygrade cluster slurm class/"},
        {{"autograder", "classroom50"}, "classroom50 needs the public container image"},
        {{"review", notes}, "notes.txt is not a results folder; name the folder that `raygrade grade --out` wrote"},
        {{"override", "s05", "5"}, "override needs a submission, an item and points, e.g. raygrade override s05"},
        {{"reread", "s05", "5", "1"}, "reread needs a reason, e.g. raygrade reread s05"},
        {{"check"}, "check needs a program to check, e.g. raygrade check ray_cast.cpp"},
        {{"check", "one.cpp", "two.cpp"}, "unexpected argument \"two.cpp\". See `raygrade check --help`"},
        {{"check", "/nowhere/ray_cast.cpp"}, "Cannot find \"/nowhere/ray_cast.cpp\": No such file or directory. Check"},
        {{"check", source, "-a", extra}, "--variants 4"},
        {{"check", source, "--fail-under", "half"}, "half is not a number from 0 to 100 (--fail-under). See"},
        {{"serve", "-p", "70000"}, "70000 is not a number from 0 to 65535 (--port). See"},
        {{"serve", "--unsafe", "--host", "0.0.0.0"}, "Leave out --unsafe"},
        {{"serve", "--unsafe", "--behind-proxy", "--name", "a.example.edu"}, "Leave out --unsafe"},
        {{"stress", source, "--out", results}, "leave out the program or --out"},
        {{"assignment"}, "assignment needs one of these commands: list, check"},
        {{"assignment", "check"}, "check needs an assignment, e.g. raygrade assignment check"},
        {{"assignment", "chek"}, "\"chek\"; did you mean check? See `raygrade assignment --help`."},
        {{"assignment", "check", limit}, "limits.run.cpu_second is not a limit; did you mean"},
        {{"assignment", "check", mistake}, "did you mean center forgotten"},
        {{"assignment", "deal", "a6-2021", notes, "--sead", "2"}, "did you mean --seed? See `raygrade assignment deal"},
        {{"assignment", "deal", "a6-2021"}, "deal needs a roster, e.g. raygrade assignment deal a6-2021 class.csv"},
        {{"read"}, "read needs a program's output, e.g. raygrade read output.txt"},
        {{"read", locked}, "locked.txt: Permission denied; give a file with a program's output"},
        {{"read", source}, "ray_cast.cpp is a program; give a file with the program's output"},
        {{"reference", "-a", limit}, "limits.run.cpu_second is not a limit; did you mean"},
        {{"reference", "-a", mistake}, "did you mean center forgotten"},
        {{"explain", "no.txt", "-o", "-"}, "no.txt"},
        {{"explain", huge, "-o", "-"}, "1 MiB"},
        {{"explain", notes, "-o", "-"}, "notes.txt has no answer to any question"},
        {{"explain", "-o", below}, "no/such/a.svg cannot be written: No such file or directory"},
        {{"render", "-o", source}, "is not a PNG picture"},
        {{"render", "--size", "3"}, "--size 3 is not a size; write e.g. 640x480"},
        {{"render", "--scene", "no.toml"}, "there is no file no.toml; name a scene's .toml file"},
        {{"accuracy", "--rays", "-1"}, "-1 is not a number of at least 0 (--rays). See"},
        {{"doctor", "now"}, "unexpected argument \"now\". See `raygrade doctor --help`"},
    };
    for (const auto& [words, problem] : mistakes) {
        const Result result = raygrade(words, obey_permissions);
        EXPECT_EQ(result.status, usage) << problem;
        EXPECT_THAT(result.voice, HasSubstr(problem));
        EXPECT_EQ(result.output, "") << problem;
    }
}

const std::vector<std::string> commands = {
    "grade",     "merge", "cluster", "autograder", "review", "override", "reread", "check",  "serve", "assignment",
    "reference", "read",  "explain", "accuracy",   "stress", "render",   "cast",   "doctor", "help"};

TEST(CommandLine, HelpFitsOnAScreenAndListsEachCommandOnce) {
    const std::string help = raygrade({"--help"}).output;
    EXPECT_LE(std::count(help.begin(), help.end(), '\n'), 40);
    EXPECT_THAT(help, Not(testing::ContainsRegex("[^\n]{81}")));
    for (const std::string& command : commands) {
        const std::string line = "\n  " + command + " ";
        EXPECT_NE(help.find(line), std::string::npos) << command;
        EXPECT_EQ(help.find(line), help.rfind(line)) << command;
    }
}

TEST(CommandLine, EachHelpFitsInto80Columns) {
    std::vector<std::vector<std::string>> topics = {{}, {"limits"}, {"mistakes"}};
    for (const std::string& command : commands) topics.push_back({command});
    for (const char* command : {"list", "check", "propose", "deal", "handout"})
        topics.push_back({"assignment", command});
    for (const char* system : {"gradescope", "classroom50"}) topics.push_back({"autograder", system});
    for (std::vector<std::string> words : topics) {
        words.insert(words.begin(), "help");
        EXPECT_THAT(raygrade(words).output, Not(testing::ContainsRegex("[^\n]{81}")));
    }
}

TEST(CommandLine, HelpShowsTheUsualOptionsAndHelpAllTheOthersToo) {
    const std::string usual = raygrade({"grade", "--help"}).output, all = raygrade({"grade", "--help-all"}).output;
    for (const char* option : {"--assignment NAME|FILE", "--apply", "--jobs N", "--limit NAME=VALUE"}) {
        EXPECT_THAT(usual, HasSubstr(option));
        EXPECT_THAT(all, HasSubstr(option));
    }
    for (const char* option :
         {"--shard K/N", "--sandbox {auto,bwrap,landlock}", "--no-experiments", "--moodle-column"}) {
        EXPECT_THAT(usual, Not(HasSubstr(option)));
        EXPECT_THAT(all, HasSubstr(option));
    }
}

TEST(CommandLine, HelpOnACommandIsTheCommandsOwnHelp) {
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
        EXPECT_THAT(result.output, HasSubstr("\n  " + name));
        EXPECT_EQ(raygrade({"help", name}).status, 0) << name;
    }
}

TEST(CommandLine, TheLimitsAreATopicAndNotInTheHelpOfACommand) {
    EXPECT_THAT(raygrade({"help", "limits"}).output, HasSubstr("  run.cpu_seconds           2  "));
    for (const char* command : {"grade", "check", "serve", "stress"}) {
        const std::string help = raygrade({command, "--help"}).output;
        EXPECT_THAT(help, testing::AllOf(Not(HasSubstr("compile.stack_mib")), HasSubstr("raygrade help limits")))
            << command;
    }
}

TEST(CommandLine, HelpRefusesOddWords) {
    for (const std::string odd : {"", "a", "?", ".", "..", "../README", "/etc/passwd", "%s%n", "{}", "`ls`", ".md",
                                  "\x1b[31mred", "\xff\xfe"}) {
        const Result result = raygrade({"help", odd});
        EXPECT_EQ(result.status, usage) << odd;
        EXPECT_THAT(result.voice, testing::AllOf(HasSubstr("unknown topic"), Not(HasSubstr("\x1b")))) << odd;
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

TEST(ReferenceRun, NamesAConventionOnceWithTheItemsThatItChanges) {
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

TEST(Grade, GivesTheSameResultsWithAnyNumberOfJobs) {
    const TemporaryFolder folder;
    const std::vector<std::string> students = {"wei", "mateo", "o'brien"};
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
    EXPECT_THAT(unread.voice, Not(HasSubstr("bug")));
    const Result full = grade_into("full", talk_to_a_full_disk);
    EXPECT_EQ(full.status, some_not_graded);
    EXPECT_THAT(full.voice, HasSubstr("cannot write to stdout"));
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

TEST(Check, FailsBelowTheShareButNotAtIt) {
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

TEST(Grade, QuietSaysOnlyWhereTheResultsAre) {
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

}  // namespace
}  // namespace scenario
