// Whatever system call of raygrade, of a compiler or of a program fails, and for whatever reason of the machine's: an
// honest program has its points or is not graded, and what is kept for the next time is right.
#include "tests/scenario/trouble/kernel_error.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/given/cases.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Call {
    std::string name;
    std::vector<int> errors;  ///< those that a machine in trouble gives
};

/// Neither brk nor munmap is among them: the C library takes an error of the one for an address, and ends the program
/// at one of the other.
std::vector<Call> calls() {
    const std::pair<std::vector<int>, std::vector<const char*>> by_errors[] = {
        {{ENOSPC, EDQUOT, ENOMEM, EMFILE, ENFILE, EIO, EROFS}, {"openat"}},
        {{ENOMEM, EIO}, {"read", "pread64", "newfstatat", "fstat", "statfs", "access", "readlink", "getdents64"}},
        {{ENOSPC, EDQUOT, EIO}, {"write", "pwrite64", "writev", "fallocate", "fsync", "fdatasync"}},
        {{ENOSPC, EDQUOT, ENOMEM, EIO, EROFS},
         {"mkdir", "mkdirat", "rename", "renameat2", "link", "linkat", "symlink"}},
        {{ENOMEM, EIO, EROFS}, {"unlink", "unlinkat", "chmod"}},
        {{ENOSPC, EIO, ENOMEM}, {"copy_file_range"}},
        {{ENOSPC, EIO, EROFS}, {"ftruncate"}},
        {{EIO}, {"lseek"}},
        {{EIO, EROFS}, {"fchmod"}},
        {{ENOMEM, EAGAIN, ENFILE}, {"mmap"}},
        {{ENOMEM, EAGAIN}, {"mremap", "clone", "clone3", "fork", "vfork"}},
        {{ENOMEM}, {"mprotect", "poll", "ppoll", "prlimit64", "sendmsg", "recvmsg", "seccomp", "prctl"}},
        {{ENOMEM, EMFILE, ENFILE, EIO, EAGAIN}, {"execve"}},
        {{EMFILE, ENFILE}, {"pipe2"}},
        {{EMFILE, ENFILE, ENOMEM},
         {"socketpair", "socket", "epoll_create1", "eventfd2", "timerfd_create", "signalfd4", "memfd_create",
          "pidfd_open", "landlock_create_ruleset"}},
        {{EMFILE}, {"dup", "dup2", "dup3"}},
        {{EMFILE, EAGAIN}, {"fcntl"}},
        {{ENOMEM, ENOSPC}, {"epoll_ctl", "unshare"}},
        {{ENOMEM, EMFILE, ENOSPC}, {"mount"}},
    };
    std::vector<Call> all;
    for (const auto& [errors, names] : by_errors) {
        for (const char* name : names) all.push_back({name, errors});
    }
    return all;
}

constexpr std::string_view answers =
    "#include <glm/glm.hpp>\n#include <iostream>\n#include <vector>\n"
    "int main() {\n"
    "    const std::vector<glm::vec3> many(1000, glm::vec3(0, 0, -1));\n"
    "    std::cout << \"Question 5:\\nV: vec3(0, 0, \" << many.at(7).z << \")\\n\";\n"
    "}\n";
/// Enough for a precompiled header to pay off.
constexpr std::array share_a_header{"one", "two", "three", "four"};
/// The answer is right, and printed before the program crashes.
constexpr std::string_view crashes =
    "#include <cstdio>\n#include <cstdlib>\n"
    "int main() { puts(\"Question 5:\\nV: vec3(0, 0, -1)\"); fflush(stdout); abort(); }\n";

class MachineInTrouble : public testing::Test {
  protected:
    MachineInTrouble() {
        fs::permissions(folder.path(), static_cast<fs::perms>(0755));
        for (const char* id : share_a_header)
            write(students() / id / "ray_cast.cpp", fmt::format("// {}\n{}", id, answers));
        write(students() / "crashes/ray_cast.cpp", crashes);
    }

    fs::path students() const { return folder / "class"; }
    fs::path out() const { return folder / "out"; }
    std::vector<std::string> command() const {
        return {"grade", students().string(), "--out", out().string(), "--apply", "-j", "2"};
    }
    Preparation with_own_folders() const {
        return [this] {
            fs::create_directories(folder / "tmp");
            fs::permissions(folder / "tmp", static_cast<fs::perms>(0777));
            return setenv("TMPDIR", (folder / "tmp").c_str(), 1) == 0 && with_cache(folder / "cache")();
        };
    }
    void start_anew() const {
        for (const char* name : {"out", "cache", "tmp"}) fs::remove_all(folder / name);
    }

    /// What is wrong with the marks; empty if each has its points, or none and `may_be_ungraded`.
    std::string wrong_marks(bool may_be_ungraded) const {
        const json grades = read_json(out() / "grades.json");
        std::string wrong;
        std::vector<std::string> ids(share_a_header.begin(), share_a_header.end());
        ids.emplace_back("crashes");
        for (const std::string& id : ids) {
            const json one = submission_in(grades, id);
            if (one.is_null()) {
                wrong += id + " is missing\n";
                continue;
            }
            const bool has_points = one.at("points") == 10.0;
            const bool is_ungraded = one.at("outcome") == "not_graded" && one.at("points").is_null();
            if (!has_points && !(may_be_ungraded && is_ungraded)) wrong += one.dump(2) + "\n";
        }
        return wrong;
    }

    /// Grades while the call fails, and again afterwards. Returns what went wrong; empty if nothing did.
    std::string try_error(const KernelError& error, long& reached) const {
        start_anew();
        CountedCalls counted;
        const Result in_trouble = raygrade(command(), counted.fail(error, with_own_folders()));
        reached += counted.of(error.call) >= error.first ? 1 : 0;
        constexpr int not_even_loaded = 127;  // the dynamic linker says why
        if (in_trouble.status > 3 && in_trouble.status != not_even_loaded) return all_of(in_trouble);
        if (fs::exists(out() / "grades.json")) {
            if (std::string wrong = wrong_marks(true); !wrong.empty()) return wrong + in_trouble.both();
        } else if (in_trouble.voice.empty() && error.call != "write") {
            return "says nothing\n" + all_of(in_trouble);
        }
        fs::remove_all(out());
        const Result afterwards = raygrade(command(), with_own_folders());
        if (afterwards.status != 0) return "afterwards: " + all_of(afterwards);
        const std::string wrong = wrong_marks(false);
        return wrong.empty() ? "" : "afterwards: " + wrong;
    }

    static std::string all_of(const Result& result) {
        return "status " + std::to_string(result.status) + "\n" + result.both();
    }

    TemporaryFolder folder;
};

TEST_F(MachineInTrouble, NeverCostsAnHonestProgramItsMark) {
    const int trials = is_nightly() ? 1500 : 8;
    const char* given = std::getenv("RAYGRADE_SEED");
    const unsigned seed = given != nullptr ? static_cast<unsigned>(std::atoi(given)) : 1;
    std::mt19937 random(seed);

    std::vector<Call> made = calls();
    std::vector<std::string> names;
    for (const Call& call : made) names.push_back(call.name);
    CountedCalls counted;
    ASSERT_EQ(raygrade(command(), counted.count(names, with_own_folders())).status, 0);
    ASSERT_EQ(wrong_marks(false), "");
    std::erase_if(made, [&](const Call& call) { return counted.of(call.name) == 0; });
    ASSERT_GT(made.size(), 20U);

    long reached = 0;
    for (int i = 0; i < trials; ++i) {
        const auto pick = [&](std::size_t count) {
            return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
        };
        const Call& call = made[pick(made.size())];
        const KernelError error{call.name, call.errors[pick(call.errors.size())],
                                static_cast<long>(pick(static_cast<std::size_t>(counted.of(call.name)))) + 1,
                                pick(3) == 0};
        const std::string wrong = try_error(error, reached);
        EXPECT_EQ(wrong, "") << error.text() << ", seed " << seed;
    }
    std::cout << trials << " errors of " << made.size() << " system calls, of which " << reached << " were met\n";
    EXPECT_GT(reached, trials / 2);
}

}  // namespace
}  // namespace scenario
