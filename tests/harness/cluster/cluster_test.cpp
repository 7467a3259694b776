// What the scripts hold, and what they do.
#include "harness/cluster/cluster.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

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
    }
    ~Cluster() override { fs::remove_all(folder); }
    Cluster(const Cluster&) = delete;
    Cluster& operator=(const Cluster&) = delete;

    /// A program that writes its words to the file `words` beside it, one a line, and then does `more`.
    fs::path stub(std::string_view name, std::string_view more = "") const {
        const fs::path path = folder / name;
        std::ofstream(path) << "#!/bin/bash\nprintf '%s\\n' \"$@\" >>\"$(dirname \"$0\")/words\"\n" << more << '\n';
        fs::permissions(path, fs::perms::owner_all);
        return path;
    }

    std::string words() const { return text_of(folder / "words"); }

    static std::string text_of(const fs::path& file) {
        std::ifstream stream(file);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    /// What the last script printed.
    std::string output() const { return text_of(folder / "output"); }

    /// What `SETTING bash SCRIPT WORDS` ends with. The programs of this folder come before those of the machine.
    int start(std::string_view script, std::string_view words = "", std::string_view setting = "") const {
        const std::string command = std::string(setting) + " PATH=" + quoted(folder.string()) + ":\"$PATH\" bash " +
                                    quoted((plan.folder / script).string()) + " " + std::string(words) + " >" +
                                    quoted((folder / "output").string()) + " 2>&1";
        return std::system(command.c_str());
    }

    fs::path folder = fs::temp_directory_path() / ("cluster_test_" + std::to_string(getpid()));
    Plan plan;
};

TEST(Quoted, RefusesALineBreak) {
    EXPECT_THROW(quoted("a\nb"), UsageError);
    EXPECT_THROW(quoted("a\rb"), UsageError);
}

TEST_F(Cluster, AShardGetsEveryWordAsItWasGiven) {
    const fs::path strange = folder / "it's \"a\" $HOME * %j";
    fs::create_directories(strange);
    fs::rename(stub("raygrade", "touch \"${7}\""), strange / "raygrade");
    plan.work = folder;
    plan.folder = strange / "cluster";
    plan.raygrade = strange / "raygrade";
    plan.results = "re'sults";
    plan.classes = {"/a b/c'd", "--odd"};
    plan.options = {"--limit=x y", "--assignment=\"$(rm)`;"};
    plan.shards = 3;
    write_scripts(plan);
    EXPECT_EQ(start("shard", "2", "SLURM_CPUS_PER_TASK=5"), 0);
    const std::string at = plan.folder.string();
    EXPECT_EQ(
        text_of(strange / "words"),
        "grade\n/a b/c'd\n--odd\n--shard\n2/3\n--out\n" + at +
            "/parts/2-of-3.part\n--merge-into\nre'sults\n--quiet\n--limit=x y\n--assignment=\"$(rm)`;\n--jobs\n5\n");
}

TEST_F(Cluster, TheMissingShardsAreSubmittedAndThenTheMerge) {
    stub("sbatch", "echo '7;cluster'");
    plan.work = folder;
    plan.shards = 3;
    write_scripts(plan);
    std::ofstream(plan.folder / "parts/2-of-3.part") << "part";
    EXPECT_EQ(start("submit", "'--partition=a b' --time=6"), 0);
    const std::string at = plan.folder.string();
    EXPECT_EQ(
        words(),
        "--parsable\n--requeue\n--array=1,3\n--job-name=raygrade\n--output=/dev/null\n--partition=a b\n--time=6\n" +
            at +
            "/shard\n--parsable\n--requeue\n--job-name=raygrade-merge\n--output=/dev/null\n--partition=a b\n"
            "--time=6\n--dependency=afterany:7\n" +
            at + "/merge\n");
    EXPECT_EQ(text_of(plan.folder / "jobs"), "7\n");
    EXPECT_THAT(output(), testing::StartsWith("submitted: shards 1,3\n"));
}

TEST_F(Cluster, AShardThatStillRunsIsNotSubmittedAgainAndTheMergeWaitsForIt) {
    stub("sbatch", "echo 8");
    stub("squeue", "echo '5 1'; echo '5 3'");
    plan.work = folder;
    plan.shards = 3;
    write_scripts(plan);
    std::ofstream(plan.folder / "jobs") << "5\n";
    EXPECT_EQ(start("submit"), 0);
    EXPECT_THAT(words(), testing::HasSubstr("--array=2\n"));
    EXPECT_THAT(words(), testing::HasSubstr("--dependency=afterany:8:5\n"));
    EXPECT_THAT(words(), testing::Not(testing::HasSubstr("--partition")));
}

TEST_F(Cluster, WithAllShardsDoneTheMergeAloneIsSubmittedAndThatIsSaid) {
    stub("sbatch", "echo 9");
    plan.work = folder;
    plan.shards = 1;
    write_scripts(plan);
    std::ofstream(plan.folder / "parts/1-of-1.part") << "part";
    EXPECT_EQ(start("submit"), 0);
    EXPECT_THAT(words(), testing::Not(testing::HasSubstr("--array")));
    EXPECT_THAT(words(), testing::HasSubstr("--job-name=raygrade-merge\n"));
    EXPECT_THAT(output(), testing::StartsWith("submitted: only the merge, because all shards are done\n"));
}

TEST_F(Cluster, AFolderWithFilesIsLeftAlone) {
    write_scripts(plan);
    const fs::path part = plan.folder / "parts/1-of-2.part";
    std::ofstream(part) << "part";
    EXPECT_THAT([&] { write_scripts(plan); },
                testing::ThrowsMessage<UsageError>(testing::HasSubstr("Continue it with bash")));
    EXPECT_TRUE(fs::exists(part));
    plan.folder = folder / "other";
    fs::create_directories(plan.folder);
    std::ofstream(plan.folder / "shard") << "mine";
    EXPECT_THROW(write_scripts(plan), UsageError);
}

}  // namespace
}  // namespace harness::cluster
