// A class that is graded on one machine and in shards.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {

/// Every file of a results folder by its name; a gradebook as its rows. Times of the clock are all the same word.
std::map<std::string, std::string> files_of(const std::filesystem::path& results);

/// Expects that two folders of results hold the same files and rows, apart from times of the clock.
void expect_same(const std::filesystem::path& one, const std::filesystem::path& other);

class Shards : public testing::Test {
  protected:
    Shards() {
        // If root runs the tests, the programs' accounts need access to this folder.
        std::filesystem::permissions(folder.path(), static_cast<std::filesystem::perms>(0755));
    }

    Result run(const std::vector<std::string>& words) const { return raygrade(words, with_cache(cache)); }
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
        std::filesystem::remove_all(folder / "merged");
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
            if (with_cache(cache)() && prepare())
                execlp("bash", "bash", "-c", whole.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
        int status = 0;
        waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    TemporaryFolder folder;
    std::filesystem::path hand_ins = folder / "class";
    std::filesystem::path cache = folder / "cache";
    std::vector<std::string> options{};  ///< of every grading
};

}  // namespace scenario
