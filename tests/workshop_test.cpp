#include "harness/workshop.h"

#include <gmock/gmock.h>

#include "tests/bytes_of.h"
#include "tests/strongest_tier.h"
#include "tests/temporary_folder.h"

namespace harness {
namespace {

const std::string one_look(64, 'a'), other_look(64, 'b');

std::future<std::string> found(const std::string& toolchain) {
    std::promise<std::string> promise;
    promise.set_value(toolchain);
    return promise.get_future();
}

class Looks : public testing::Test {
  protected:
    Workshop open(std::future<std::string> toolchain) const {
        return open_workshop(options(), {}, std::move(toolchain));
    }
    Workshop open_by_last(std::future<std::string> toolchain) const {
        return open_workshop_by_last_look(options(), {}, std::move(toolchain));
    }
    WorkshopOptions options() const {
        WorkshopOptions options;
        options.sandbox = strongest_tier() == Tier::bwrap ? "bwrap" : "landlock";
        options.cache = cache.path();
        return options;
    }
    /// What was printed, kept under "k", as the next run finds it.
    bool is_kept() const { return Store(cache.path()).contains("k"); }
    static void keep(const Workshop& workshop) {
        Execution execution;
        execution.build.tried = true;
        execution.run.ended = Ended::exited;
        workshop.store->keep("k", execution);
    }

    TemporaryFolder cache;
    const std::filesystem::path file = cache.path() / "toolchain";
};

TEST_F(Looks, AreWaitedForWhereThereWasNone) {
    Workshop workshop = open_by_last(found(one_look));
    EXPECT_EQ(workshop.toolchain, one_look);
    keep(workshop);
    EXPECT_TRUE(is_kept()) << "there is nothing to settle";
    EXPECT_TRUE(settle(workshop));
    EXPECT_EQ(bytes_of(file), one_look);
}

TEST_F(Looks, ThatFindWhatTheLastOneFoundSettleWhatWasMade) {
    open(found(one_look));
    std::promise<std::string> coming;
    Workshop workshop = open_by_last(coming.get_future());
    EXPECT_EQ(workshop.toolchain, one_look) << "without waiting";
    const HeaderLines vectors{"#include <vector>"};
    EXPECT_FALSE(workshop.headers->get(vectors)) << "made by a guess";
    keep(workshop);
    EXPECT_FALSE(is_kept());
    coming.set_value(one_look);
    EXPECT_TRUE(settle(workshop));
    EXPECT_TRUE(is_kept());
    EXPECT_TRUE(settle(workshop)) << "once is enough";
    EXPECT_TRUE(workshop.headers->get(vectors));
}

TEST_F(Looks, ThatFindAnotherCompilerLeaveNothingOfWhatWasMade) {
    open(found(one_look));
    {
        Workshop workshop = open_by_last(found(other_look));
        EXPECT_EQ(workshop.toolchain, one_look);
        keep(workshop);
        EXPECT_FALSE(settle(workshop));
        EXPECT_EQ(workshop.toolchain, other_look);
        EXPECT_FALSE(workshop.store->contains("k"));
        EXPECT_EQ(bytes_of(file), other_look);
        keep(workshop);
        EXPECT_TRUE(is_kept()) << "what is made again";
        EXPECT_TRUE(settle(workshop));
    }
    EXPECT_EQ(open_by_last(found(one_look)).toolchain, other_look);
}

TEST_F(Looks, LeaveWhatTheStoreHasToTell) {
    open(found(one_look));
    cache.write("results.sqlite", std::string(8192, 'x'));
    Workshop workshop = open_by_last(found(other_look));
    EXPECT_FALSE(settle(workshop));
    EXPECT_THAT(workshop.store->problems(), testing::ElementsAre(testing::HasSubstr("results.sqlite.set-aside")));
}

TEST_F(Looks, OfWhichLittleIsLeftAreNotGoneBy) {
    const auto elsewhere = cache.write("elsewhere", one_look);
    for (const std::string& text : {std::string(), std::string(63, 'a'), std::string(65, 'a')}) {
        cache.write("toolchain", text);
        EXPECT_EQ(open_by_last(found(other_look)).toolchain, other_look) << text.size();
    }
    std::filesystem::remove(file);
    std::filesystem::create_symlink(elsewhere, file);
    EXPECT_EQ(open_by_last(found(other_look)).toolchain, other_look);
    EXPECT_EQ(bytes_of(elsewhere), one_look) << "the link is replaced and not what it leads to";
}

TEST_F(Looks, AreNotThereWithoutACache) {
    Workshop workshop = open_by_last({});
    EXPECT_FALSE(workshop.store);
    EXPECT_TRUE(settle(workshop));
    EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace harness
