// What the scripts hold, and which machines are alike.
#include "harness/cluster/cluster.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "harness/cluster/preflight.h"
#include "harness/machine/errors.h"

namespace harness::cluster {
namespace {

namespace fs = std::filesystem;

class Cluster : public testing::Test {
  protected:
    Cluster() {
        fs::remove_all(folder);
        fs::create_directories(folder);
        plan.folder = folder / "cluster";
        plan.fingerprint = "abc\n";
    }
    ~Cluster() override { fs::remove_all(folder); }
    Cluster(const Cluster&) = delete;
    Cluster& operator=(const Cluster&) = delete;

    fs::path folder = fs::temp_directory_path() / ("cluster_test_" + std::to_string(getpid()));
    Plan plan;
};

TEST(Quoted, IsOneWordForTheShellWhateverIsInIt) {
    EXPECT_EQ(quoted("a b"), "'a b'");
    EXPECT_EQ(quoted("$(rm) `x` \\ \" ; * %j"), "'$(rm) `x` \\ \" ; * %j'");
    EXPECT_EQ(quoted("it's"), "'it'\\''s'");
    EXPECT_EQ(quoted(""), "''");
}

TEST(Quoted, RefusesALineBreak) {
    EXPECT_THROW(quoted("a\nb"), UsageError);
    EXPECT_THROW(quoted("a\rb"), UsageError);
}

TEST_F(Cluster, PartsOfADifferentGradingStayUnlessTheyAreGivenUp) {
    write_scripts(plan, {{"shard", "x"}}, OldParts::keep);
    const fs::path part = plan.folder / "parts/1-of-2.part";
    std::ofstream(part) << "part";
    write_scripts(plan, {{"shard", "x"}}, OldParts::keep);
    EXPECT_TRUE(fs::exists(part));
    plan.fingerprint = "def\n";
    EXPECT_THROW(write_scripts(plan, {{"shard", "x"}}, OldParts::keep), UsageError);
    EXPECT_TRUE(fs::exists(part));
    write_scripts(plan, {{"shard", "x"}}, OldParts::give_up);
    EXPECT_FALSE(fs::exists(part));
}

TEST_F(Cluster, AFolderOfOthersIsLeftAlone) {
    fs::create_directories(plan.folder);
    std::ofstream(plan.folder / "shard") << "mine";
    EXPECT_THROW(write_scripts(plan, {{"shard", "x"}}, OldParts::give_up), UsageError);
}

TEST_F(Cluster, AMachineIsComparedWithTheFirst) {
    const fs::path file = folder / "node.json";
    const Node first{"n1", {{"compiler", "a"}, {"sandbox", "bwrap"}}};
    EXPECT_EQ(difference_from_first(first, file), "");
    EXPECT_EQ(difference_from_first({"n2", first.traits}, file), "");
    const std::string differs = difference_from_first({"n3", {{"compiler", "b"}, {"sandbox", "bwrap"}}}, file);
    EXPECT_EQ(differs, "this machine, n3, differs from \"n1\", which started first: compiler");
}

TEST_F(Cluster, ADamagedFileOfTheFirstMachineIsTold) {
    const fs::path file = folder / "node.json";
    for (const char* damaged : {"", "{\"alike\":", "[]", "{\"alike\":1}"}) {
        std::ofstream(file) << damaged;
        EXPECT_THROW(difference_from_first({"n1", {{"compiler", "a"}}}, file), HarnessError) << damaged;
    }
}

}  // namespace
}  // namespace harness::cluster
