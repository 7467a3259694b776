// A class that several machines grade in shards, and the results that are merged from their parts.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <map>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "tests/given/cases.h"
#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

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

/// Every file of a results folder by its name.
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

/// Into how many shards a class is split: `usual`, and in the target nightly other numbers too.
std::vector<int> counts(int usual) {
    return is_nightly() ? std::vector{1, 2, 5} : std::vector{usual};
}

class Shards : public testing::Test {
  protected:
    Shards() {
        // If root runs the tests, the programs' accounts need access to this folder.
        fs::permissions(folder.path(), static_cast<fs::perms>(0755));
    }

    Result run(const std::vector<std::string>& words) const {
        return raygrade(words, [this] { return setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1) == 0; });
    }
    std::string place(const std::string& name) const { return (folder / name).string(); }
    std::string part(int number, int count) const {
        return place("parts/" + std::to_string(number) + "-of-" + std::to_string(count) + ".part");
    }

    /// The words of a command on the class, and more.
    std::vector<std::string> on_class(const std::string& verb, const std::vector<std::string>& more) const {
        std::vector<std::string> words{verb, hand_ins.string()};
        words.insert(words.end(), more.begin(), more.end());
        words.insert(words.end(), options.begin(), options.end());
        return words;
    }
    Result grade(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"--out", place("one")};
        words.insert(words.end(), more.begin(), more.end());
        return run(on_class("grade", words));
    }
    Result grade_shard(int number, int count) const {
        return run(on_class("grade", {"--shard", std::to_string(number) + "/" + std::to_string(count), "--out",
                                      part(number, count), "--merge-into", place("merged")}));
    }
    void grade_shards(int count) const {
        for (int number = 1; number <= count; ++number) {
            const Result result = grade_shard(number, count);
            ASSERT_LE(result.status, some_not_graded) << result.both();
        }
    }
    Result merge(int count, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"merge", "--out", place("merged")};
        for (int number = count; number >= 1; --number) words.push_back(part(number, count));
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    /// Grades on one machine and in shards, and compares.
    void expect_alike(int count) const {
        fs::remove_all(folder / "merged");
        grade_shards(count);
        const Result merged = merge(count);
        EXPECT_LE(merged.status, some_not_graded) << merged.both();
        expect_same(folder / "one", folder / "merged");
    }
    void hand_in(const std::string& who, std::string_view source) const {
        write(folder / "class" / who / "ray_cast.cpp", source);
    }
    /// Three hand-ins with different sources.
    void hand_in_three() const {
        hand_in("ada", small_program);
        hand_in("ben", std::string(small_program) + "// ben\n");
        hand_in("cy", std::string(small_program) + "// cy\n");
    }

    /// A class as Moodle has it, with one student late and one without a source.
    void hand_in_by_moodle() {
        hand_ins = folder / "moodle";
        write(hand_ins / "Jane Doe_11_assignsubmission_file/ray_cast.cpp", small_program);
        write(hand_ins / "Al Abe_12_assignsubmission_file/ray_cast.cpp", std::string(small_program) + "//\n");
        write(hand_ins / "Rick Roe_13_assignsubmission_file/notes.txt", "sorry");
        write(
            folder / "worksheet.csv",
            "Identifier,Full name,Grade,Maximum grade,Last modified (grade)\n"
            "Participant 11,Jane Doe,,100.00,-\nParticipant 12,Al Abe,,100.00,-\nParticipant 13,Rick Roe,,100.00,-\n");
        write(folder / "late.csv", "id,days_late\nJane Doe,1\n");
        write(folder / "late.toml",
              read(project_folder() / "reference/assignments/a6-2021.toml") + "\nlate = [[1, 0.5]]\n");
        options = {"--assignment",         place("late.toml"), "--moodle-worksheet",
                   place("worksheet.csv"), "--late-days",      place("late.csv")};
    }
    /// Writes the scripts of a cluster of two shards.
    Result write_scripts() const {
        std::vector<std::string> words =
            on_class("slurm", {"--out", place("merged"), "--scripts", place("scripts"), "--shards", "2"});
        words.insert(words.begin(), "cluster");
        return run(words);
    }
    /// The exit status of a command in the folder of the scripts; "shard 1" is one of them.
    int script(
        const std::string& command, const std::function<bool()>& prepare = [] { return true; }) const {
        const pid_t child = fork();
        if (child == 0) {
            const std::string whole = "cd " + place("scripts") + " && exec >/dev/null 2>&1 && bash " + command;
            if (setenv("XDG_CACHE_HOME", place("cache").c_str(), 1) == 0 && prepare())
                execlp("bash", "bash", "-c", whole.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    TemporaryFolder folder;
    fs::path hand_ins = folder / "class";
    std::vector<std::string> options{};  ///< of every grading
};

/// Every sample submission, but those that stand for a class of another year or attack.
TEST_F(Shards, OfTheSampleClassMakeTheResultsOfOneMachine) {
    for (const auto& entry : fs::directory_iterator(project_folder() / "submissions")) {
        const std::string name = entry.path().filename().string();
        if (name != "hostile" && name != "2024") hand_in(name, read(entry.path() / "ray_cast.cpp"));
    }
    hand_in("nothing", "");
    fs::create_directory(hand_ins / "empty");
    options = {"--assignment", "a6-2021"};
    ASSERT_LE(grade().status, some_not_graded);
    for (const int count : counts(5)) expect_alike(count);
}

TEST_F(Shards, OfLabelledClassesMakeTheResultsOfOneMachine) {
    std::vector<std::string> names{"miss"};
    if (is_nightly()) names.insert(names.end(), {"edge", "offaxis"});
    for (const std::string& name : names) {
        hand_ins = project_folder() / "tests/given/labelled" / name;
        options = {"--assignment", (hand_ins / "assignment.toml").string()};
        fs::remove_all(folder / "one");
        ASSERT_LE(grade().status, some_not_graded);
        for (const int count : counts(2)) expect_alike(count);
    }
}

TEST_F(Shards, OfAClassOnOtherAndHardScenesMakeTheResultsOfOneMachine) {
    const fs::path edge = project_folder() / "tests/given/labelled/edge";
    for (const char* who : {"e01", "e02", "e03"}) hand_in(who, read(edge / who / "ray_cast.cpp"));
    options = {"--assignment", (edge / "assignment.toml").string(), "--variants", "2", "--stress", "--repeat", "2"};
    ASSERT_EQ(grade().status, 0);
    expect_alike(2);
}

TEST_F(Shards, CarryTheListsOfStudents) {
    hand_in_by_moodle();
    ASSERT_EQ(grade().status, some_not_graded);
    expect_alike(2);
    EXPECT_THAT(read(folder / "merged/grades-moodle.csv"), HasSubstr("Participant 11,Jane Doe,5.00"));
}

TEST_F(Shards, OfAClusterCarryTheListsOfStudents) {
    hand_in_by_moodle();
    ASSERT_EQ(grade().status, some_not_graded);
    ASSERT_EQ(write_scripts().status, 0);
    ASSERT_EQ(script("shard 1"), 0);
    ASSERT_EQ(script("shard 2"), 0);
    EXPECT_EQ(script("merge"), some_not_graded);
    expect_same(folder / "one", folder / "merged");

    write(folder / "late.csv", "id,days_late\nJane Doe,0\n");
    EXPECT_THAT(write_scripts().voice, HasSubstr("holds parts of a different class, assignment or options"));
    write(folder / "worksheet.csv",
          "Identifier,Full name,Grade,Maximum grade,Last modified (grade)\nParticipant 99,Vi Voe,,100.00,-\n");
    EXPECT_THAT(write_scripts().voice, HasSubstr("Give the roster of this class with --moodle-worksheet"));
}

TEST_F(Shards, KnowTheSceneThatWasDealtToEachStudent) {
    write(folder / "class.csv", "id,name\nada,Ada\nben,Ben\n");
    ASSERT_EQ(run({"assignment", "deal", "a6-2021", place("class.csv"), "--out", place("dealt")}).status, 0);
    hand_in_three();
    options = {"--assignment", place("dealt/a6-2021.toml")};
    ASSERT_EQ(grade().status, some_not_graded) << "no scene was dealt to cy";
    expect_alike(2);
}

TEST_F(Shards, KeepWhatAPersonDecidedThroughARegrade) {
    hand_in_three();
    hand_in("dee",
            "#include <cstdio>\nint main() { puts(\"Question 5:\\nDEBUG: vec3(0.000000, 0.000000, -1.000000)\"); }\n");
    ASSERT_EQ(grade().status, 0);
    expect_alike(2);
    for (const char* results : {"one", "merged"}) {
        EXPECT_EQ(run({"override", "ada", "5.V", "3", "--why", "so", "--results", place(results)}).status, 0);
        EXPECT_EQ(run({"reread", "dee", "5.V", "2", "--why", "it is V", "--results", place(results)}).status, 0);
    }
    hand_in("ben", "int main() { return 1; }\n");
    const auto before = files_of(folder / "merged");
    grade_shards(2);
    const Result shown = merge(2);
    EXPECT_THAT(shown.output, AllOf(HasSubstr("ben"), HasSubstr("Nothing was written to the results")));
    EXPECT_EQ(files_of(folder / "merged"), before);
    EXPECT_EQ(merge(2, {"--apply"}).status, 0);
    ASSERT_EQ(grade({"--apply"}).status, 0);
    expect_same(folder / "one", folder / "merged");
    EXPECT_THAT(read(folder / "merged/grades.json"), AllOf(HasSubstr("\"why\":\"so\""), HasSubstr("it is V")));

    EXPECT_THAT(merge(2, {"--apply"}).output, HasSubstr("Nothing has changed"));
    expect_same(folder / "one", folder / "merged");
}

/// The parts were made before the reread, so they do not know it.
TEST_F(Shards, AreMarkedAgainWithARereadThatIsYounger) {
    hand_in_three();
    hand_in("dee",
            "#include <cstdio>\nint main() { puts(\"Question 5:\\nDEBUG: vec3(0.000000, 0.000000, -1.000000)\"); }\n");
    grade_shards(2);
    ASSERT_EQ(merge(2).status, 0);
    ASSERT_EQ(run({"reread", "dee", "5.V", "2", "--why", "it is V", "--results", place("merged")}).status, 0);
    const auto before = files_of(folder / "merged");
    EXPECT_THAT(merge(2, {"--apply"}).output, HasSubstr("Nothing has changed"));
    EXPECT_EQ(files_of(folder / "merged"), before);
    ASSERT_EQ(run({"reread", "dee", "5.V", "--remove", "--why", "no", "--results", place("merged")}).status, 0);
    const auto taken_back = files_of(folder / "merged");
    EXPECT_THAT(merge(2, {"--apply"}).output, HasSubstr("Nothing has changed"));
    EXPECT_EQ(files_of(folder / "merged"), taken_back);
}

TEST_F(Shards, AreRefusedByNameUnlessEachIsThereOnce) {
    hand_in_three();
    grade_shards(3);
    const auto merge_files = [&](std::vector<std::string> files) {
        files.insert(files.begin(), {"merge", "--out", place("merged")});
        Result result = run(files);
        EXPECT_EQ(result.status, usage) << result.both();
        EXPECT_FALSE(fs::exists(folder / "merged")) << "nothing is begun";
        return result.voice;
    };
    EXPECT_THAT(merge_files({part(2, 3)}), HasSubstr("missing: parts 1 and 3 of 3"));
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3)}), HasSubstr("missing: part 3 of 3"));
    fs::copy(part(1, 3), folder / "copy.part");
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3), part(3, 3), place("copy.part")}),
                HasSubstr("copy.part: is part 1 of 3, and so is " + part(1, 3)));
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3), place("no.part")}), HasSubstr("no.part: is not there"));
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3), place("class/ada/ray_cast.cpp")}),
                HasSubstr("ray_cast.cpp: is no part of a class"));
    const std::string whole = read(part(3, 3));
    write(part(3, 3), whole.substr(0, whole.size() - 1));
    EXPECT_THAT(merge_files({part(1, 3), part(2, 3), part(3, 3)}),
                HasSubstr("3-of-3.part: is cut off; grade it again with --shard 3/3"));
}

TEST_F(Shards, OfDifferentGradingsAreRefusedByName) {
    hand_in_three();
    grade_shards(2);
    const std::string original = read(part(2, 2));
    const auto refusal = [&](const std::vector<std::string>& with) {
        options = with;
        EXPECT_LE(grade_shard(2, 2).status, some_not_graded);
        options = {};
        const Result result = merge(2);
        EXPECT_EQ(result.status, usage) << result.both();
        write(part(2, 2), original);
        return result.voice;
    };
    EXPECT_THAT(refusal({"--assignment", "a6-2024"}), HasSubstr("was graded with another assignment than"));
    EXPECT_THAT(refusal({"--limit", "run.cpu_seconds=3"}),
                HasSubstr("was graded with another set of limits and compiler flags than"));
    EXPECT_THAT(refusal({"--repeat", "3"}), HasSubstr("another --repeat than"));
    EXPECT_THAT(refusal({"--variants", "2"}), AllOf(HasSubstr("another --variants than"), HasSubstr("2 from seed 1")));
    EXPECT_THAT(refusal({"--stress"}), HasSubstr("another --stress than"));
    if (holds_bwrap()) {
        EXPECT_THAT(refusal({"--sandbox", "landlock"}),
                    AllOf(HasSubstr("another sandbox than"), HasSubstr("bwrap+shim"), HasSubstr("landlock+shim")));
    }
    hand_in("dee", small_program);
    EXPECT_THAT(refusal({}), HasSubstr("was graded with another class than"));
}

TEST_F(Shards, OfADifferentCompilerOrRaygradeAreRefusedByName) {
    hand_in_three();
    grade_shards(3);
    const auto change = [&](int number, const std::string& from, const std::string& to) {
        std::string text = read(part(number, 3));
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos);
        write(part(number, 3), text.replace(at, from.size(), to));
    };
    change(1, "\"compiler\":\"", "\"compiler\":\"0");
    const Result compiler = merge(3);
    EXPECT_EQ(compiler.status, usage);
    EXPECT_THAT(compiler.voice, AllOf(HasSubstr("1-of-3.part: was graded with another compiler than"),
                                      Not(HasSubstr("2-of-3.part: was")), Not(HasSubstr("3-of-3.part: was"))));
    for (int number = 1; number <= 3; ++number) change(number, "\"raygrade\":\"", "\"raygrade\":\"9");
    const Result version = merge(3);
    EXPECT_EQ(version.status, usage);
    EXPECT_THAT(version.voice, HasSubstr("was graded by another raygrade than this one"));
}

TEST_F(Shards, AreWholeOrNotThereHoweverOftenTheyAreKilled) {
    using namespace std::chrono_literals;
    hand_in_three();
    ASSERT_EQ(grade().status, 0);
    fs::remove_all(folder / "cache");
    const std::vector<std::string> words =
        on_class("grade", {"--shard", "1/2", "--out", part(1, 2), "--merge-into", place("merged")});
    // A part that was there before stays whole too.
    for (const auto delay : {0ms, 20ms, 50ms, 100ms, 200ms, 400ms, 800ms, 1600ms}) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            become_raygrade(
                words, [this] { return setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1) == 0; }, "/dev/null",
                "/dev/null");
        }
        std::this_thread::sleep_for(delay);
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        if (!fs::exists(part(1, 2))) continue;
        const Result half = run({"merge", part(1, 2), "--out", place("merged")});
        EXPECT_THAT(half.voice, AllOf(HasSubstr("missing: part 2 of 2"), Not(HasSubstr("1-of-2"))));
    }
    fs::remove_all(folder / "one");
    ASSERT_EQ(grade().status, 0);
    expect_alike(2);
}

TEST_F(Shards, AreNotThereIfTheDiskIsFull) {
    hand_in("ada", std::string(small_program) + "//" + std::string(20'000, '.') + "\n");
    fs::create_directory(folder / "parts");
    const Result result = raygrade(on_class("grade", {"--shard", "1/1", "--out", part(1, 1)}), [this] {
        return setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1) == 0 && mount_tiny_disk(folder / "parts");
    });
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    EXPECT_THAT(result.voice, HasSubstr("1-of-1.part: can't be written: No space left on device"));
    EXPECT_THAT(result.output, Not(HasSubstr("part:")));
}

TEST_F(Shards, OfANodeWhoseDiskIsFullAreMissedByNameAndGradedAgain) {
    const std::string long_comment = "//" + std::string(20'000, '.');
    hand_in("ada", std::string(small_program) + long_comment + "\n");
    hand_in("ben", std::string(small_program) + long_comment + "ben\n");
    ASSERT_EQ(grade().status, 0);
    ASSERT_EQ(write_scripts().status, 0);
    ASSERT_EQ(script("shard 1"), 0);
    const auto with_full_disk = [this] { return mount_tiny_disk(folder / "scripts/parts"); };
    EXPECT_EQ(script("shard 2; echo $? >ended; ls -A parts >left", with_full_disk), 0);
    EXPECT_EQ(read(folder / "scripts/ended"), "1\n");
    EXPECT_EQ(read(folder / "scripts/left"), "") << "nothing unfinished either";
    EXPECT_THAT(read(folder / "scripts/logs/2.log"),
                HasSubstr("parts/2-of-2.part: can't be written: No space left on device"));
    EXPECT_EQ(script("merge"), usage);
    EXPECT_THAT(read(folder / "scripts/logs/merge.log"), HasSubstr("missing: part 2 of 2"));
    EXPECT_FALSE(fs::exists(folder / "merged"));
    EXPECT_EQ(script("shard 2"), 0);
    EXPECT_EQ(script("merge"), 0);
    expect_same(folder / "one", folder / "merged");
}

TEST_F(Shards, MoreThanThereAreSubmissionsAreEmpty) {
    hand_in_three();
    ASSERT_EQ(grade().status, 0);
    expect_alike(7);
    EXPECT_THAT(grade_shard(1, 7).output, HasSubstr(" of 3 submissions"));
}

TEST_F(Shards, UseTheResultsThatADifferentMachineHasKept) {
    hand_in_three();
    ASSERT_EQ(grade().status, 0);
    fs::rename(folder / "cache", folder / "theirs");
    options = {"--cache-from", place("theirs/raygrade")};
    EXPECT_THAT(grade_shard(1, 1).voice, HasSubstr("3 of 3 from earlier runs"));
    options = {"--cache-from", place("nowhere")};
    const Result without = grade_shard(1, 1);
    EXPECT_EQ(without.status, 0);
    EXPECT_THAT(without.voice, AllOf(HasSubstr("nowhere\" are not used"), HasSubstr("0 of 3 from earlier runs")));
}

TEST_F(Shards, RefuseWhatCannotBeMeantOfOne) {
    hand_in_three();
    for (const char* wrong : {"0/2", "3/2", "1", "1/", "x/2", "1/20000", "1/2/3", "-1/2"})
        EXPECT_THAT(run({"grade", place("class"), "--out", place("p"), "--shard", wrong}).voice,
                    HasSubstr("is no share of a class"))
            << wrong;
    for (const char* wrong : {"--apply", "--json"})
        EXPECT_EQ(run({"grade", place("class"), "--out", place("p"), "--shard", "1/2", wrong}).status, usage) << wrong;
    EXPECT_EQ(run({"grade", place("class"), "--shard", "1/2"}).status, usage) << "without --out";
    const Result over = run({"grade", place("class"), "--out", place("class"), "--shard", "1/2"});
    EXPECT_EQ(over.status, usage);
    EXPECT_THAT(over.voice, HasSubstr("class: is no file; name a file for the part with --out"));
    const Result below = run({"grade", place("class"), "--out", place("class/ada/ray_cast.cpp/p"), "--shard", "1/2"});
    EXPECT_EQ(below.status, usage);
    EXPECT_THAT(below.voice, HasSubstr("ray_cast.cpp/p: can't be written; name another file with --out"));
}

}  // namespace
}  // namespace scenario
