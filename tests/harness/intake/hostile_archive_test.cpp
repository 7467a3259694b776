// Whatever a student's archive does, it costs that student alone.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "harness/intake/intake.h"
#include "harness/machine/errors.h"
#include "tests/given/hostile_archives.h"
#include "tests/given/packed.h"
#include "tests/given/temporary_folder.h"

namespace {

using harness::Submission;
using std::chrono::steady_clock;

const std::string honest = "int main() { return 0; }\n";

/// All names below a folder.
std::vector<std::string> everything_below(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) names.push_back(entry.path());
    std::sort(names.begin(), names.end());
    return names;
}

long most_memory_mib(int of) {
    rusage used{};
    getrusage(of, &used);
    return used.ru_maxrss / 1024;
}

const Submission* find(const std::vector<Submission>& all, const std::string& id) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Submission& one) { return one.id == id; });
    return found == all.end() ? nullptr : &*found;
}

void expect_honest(const std::vector<Submission>& taken, const std::string& id) {
    const Submission* const one = find(taken, id);
    ASSERT_NE(one, nullptr) << id;
    EXPECT_EQ(one->problem.value_or(""), "") << id;
    EXPECT_EQ(one->source, honest) << id;
}

void expect_a_source_or_a_reason(const Submission& one) {
    EXPECT_NE(one.problem.has_value(), !one.source.empty());
    std::size_t told = one.problem.value_or("").size();
    for (const std::string& note : one.notes) told += note.size();
    EXPECT_LT(told, 30'000U) << "the instructor reads this";
    EXPECT_EQ(one.problem.value_or("").find_first_of(std::string("\n\x1b\0", 3)), std::string::npos);
}

/// Takes in a class of three, the one in the middle being hostile: in folders, and as a zip of Moodle's.
void take_in_class_with(const HostileArchive& hostile) {
    const TemporaryFolder folder;
    folder.write("class/ada/ray_cast.cpp", honest);
    folder.write("class/mallory/" + hostile.name, hostile.bytes);
    folder.write("class/zoe/ray_cast.cpp", honest);
    const std::string of = "_assignsubmission_file_";
    const auto zip = pack(folder.path() / "moodle.zip", {{"Ada_1" + of + "ray_cast.cpp", honest},
                                                         {"Mallory_2" + of + hostile.name, hostile.bytes},
                                                         {"Zoe_3" + of + "ray_cast.cpp", honest}});
    const auto before = everything_below(folder.path());
    const auto in_folders = harness::take_in(folder.path() / "class");
    expect_honest(in_folders, "ada");
    expect_honest(in_folders, "zoe");
    ASSERT_EQ(in_folders.size(), 3U);
    expect_a_source_or_a_reason(in_folders[1]);

    const auto packed_in_zip = harness::take_in(zip);
    expect_honest(packed_in_zip, "Ada");
    expect_honest(packed_in_zip, "Zoe");
    ASSERT_EQ(packed_in_zip.size(), 3U);
    expect_a_source_or_a_reason(packed_in_zip[1]);

    const auto alone = folder.path() / "class/mallory" / hostile.name;
    expect_honest(harness::take_in_all({folder.path() / "class/ada", alone}).submissions, "ada");
    EXPECT_EQ(everything_below(folder.path()), before);
}

/// One round gives each attack as it is, the next one damages it.
TEST(HostileArchive, CostsOnlyItsOwnStudent) {
    const char* const wanted = std::getenv("RAYGRADE_HOSTILE_ARCHIVES");
    const auto count = wanted == nullptr ? 2 * hostile_archive_kinds() : static_cast<std::uint32_t>(std::atoi(wanted));
    std::uint32_t failed = 0;
    for (std::uint32_t seed = 0; seed < count; ++seed) {
        const HostileArchive hostile = hostile_archive(seed);
        SCOPED_TRACE(hostile.what + ", seed " + std::to_string(seed) + ", " + hostile.name);
        const bool failed_before = HasFailure();
        const auto begin = steady_clock::now();
        take_in_class_with(hostile);
        // Each of three readings has 5 s of processor time at the most, of which other work on this machine makes more.
        EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(60));
        if (!failed_before && HasFailure()) ++failed;
    }
    std::cout << count << " hostile archives, first failure counted: " << failed << '\n';
#if defined(__SANITIZE_ADDRESS__)
    constexpr bool is_sanitised = true;  // and keeps what was freed
#else
    constexpr bool is_sanitised = false;
#endif
    if (is_sanitised) return;
    EXPECT_LT(most_memory_mib(RUSAGE_CHILDREN), 1100) << "512 MiB for a class's archive, and what this process has";
    EXPECT_LT(most_memory_mib(RUSAGE_SELF), 700) << "512 MiB of sources, of an archive that could be a class's";
}

TEST(HostileArchive, MayBeAPipeThatNobodyWritesTo) {
    const TemporaryFolder folder;
    folder.write("class/ada/ray_cast.cpp", honest);
    folder.make_folder("class/mallory");
    const auto pipe = folder.path() / "class/mallory/x.zip";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const auto taken = harness::take_in(folder.path() / "class");
    expect_honest(taken, "ada");
    EXPECT_THAT(taken.at(1).problem.value_or(""), testing::HasSubstr("is a folder, pipe or device"));
    EXPECT_THROW(harness::take_in(pipe), harness::UsageError);
}

TEST(HostileArchive, IsNotGradedButTheOtherPathsAre) {
    const TemporaryFolder folder;
    const auto good = pack(folder.path() / "good.zip", {{"good.cpp", honest}});
    const auto bad = pack(folder.path() / "bad.zip", {{"../bad.cpp", honest}});
    const auto taken = harness::take_in_all({good, bad}).submissions;
    ASSERT_EQ(taken.size(), 2U);
    expect_honest(taken, "good");
    EXPECT_THAT(taken[1].problem.value_or(""), testing::HasSubstr("leads out"));
    EXPECT_THROW(harness::take_in_all({bad}), harness::UsageError) << "alone it is the command's mistake";
}

}  // namespace
