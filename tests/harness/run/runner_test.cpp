#include "harness/run/runner.h"

#include <gmock/gmock.h>

#include "harness/build/toolchain.h"
#include "tests/given/strongest_tier.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

class OpenRunner : public testing::Test {
  protected:
    RunnerOptions options() const {
        RunnerOptions options;
        options.sandbox = strongest_tier() == Tier::bwrap ? "bwrap" : "landlock";
        return options;
    }
    const TemporaryFolder cache;
};

TEST_F(OpenRunner, OpensBothCachesInTheFolderGiven) {
    RunnerOptions with_cache = options();
    with_cache.cache = cache.path();
    const Runner runner = open_runner(with_cache, {});
    EXPECT_EQ(runner.toolchain.fingerprint, examine_toolchain(runner.build.compiler).fingerprint);
    ASSERT_TRUE(runner.headers);
    EXPECT_TRUE(runner.headers->get({"#include <vector>"}));
    ASSERT_TRUE(runner.result_cache);
    Execution execution;
    execution.build.tried = true;
    execution.run.ended = Ended::exited;
    runner.result_cache->keep("k", execution);
    EXPECT_TRUE(ResultCache(cache.path()).contains("k"));
}

TEST_F(OpenRunner, KeepsNothingWithoutAFolder) {
    const Runner runner = open_runner(options(), {});
    EXPECT_FALSE(runner.result_cache);
    EXPECT_FALSE(runner.headers);
    EXPECT_EQ(runner.toolchain.name.substr(0, 4), "g++ ") << "reports name it";
}

TEST_F(OpenRunner, KeysDependOnSourceRunAndLimits) {
    const Runner runner = open_runner(options(), {});
    RunnerOptions longer = options();
    longer.limits = {"run.cpu_seconds=7"};
    const std::string key = execution_key("int main() {}", runner, "first");
    EXPECT_EQ(execution_key("int main() {}", runner, "first"), key);
    EXPECT_NE(execution_key("int main() { }", runner, "first"), key);
    EXPECT_NE(execution_key("int main() {}", runner, "repetition 2"), key);
    EXPECT_NE(execution_key("int main() {}", open_runner(longer, {}), "first"), key);
}

}  // namespace
}  // namespace harness
