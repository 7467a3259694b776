#include "harness/header_shelf.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "harness/include_block.h"
#include "harness/limit_settings.h"
#include "temporary_folder.h"
#include "tests/strongest_tier.h"

namespace {

using namespace std::chrono_literals;
using harness::HeaderLines;
using harness::HeaderShelf;
using testing::ElementsAre;
using testing::IsEmpty;

const HeaderLines vectors{"#include <vector>"};
const std::string use_of_vectors = "#include <vector>\nint main() { std::vector<int> v(3); return v[0]; }\n";

struct Shelf {
    harness::BuildSettings settings = harness::default_build_settings(harness::read_limits({}, {}).compile);
    harness::Sandbox sandbox{strongest_tier()};
    TemporaryFolder cache;

    HeaderShelf shelf(const std::string& toolchain = "g++ 12", const harness::ShelfBounds& bounds = {}) const {
        return HeaderShelf(cache.path(), settings, toolchain, sandbox, bounds);
    }
    harness::Build build(const std::string& source, const std::optional<harness::PrecompiledHeader>& header) const {
        harness::Submission submission;
        submission.source = source;
        const harness::Scratch scratch(sandbox.workspace());
        return harness::build(submission, settings, sandbox, scratch, header);
    }
};

TEST(HeaderShelf, MakesAHeaderTheCompilerTakes) {
    const Shelf here;
    const auto header = here.shelf().get(vectors);
    ASSERT_TRUE(header);
    EXPECT_EQ(header->directives, 1U);
    struct stat info {};
    ASSERT_EQ(stat((header->file.string() + ".gch").c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0444U) << "read by everyone, written by nobody";
    EXPECT_EQ(info.st_uid, geteuid());
    // Were its text read and not the header, it would not compile.
    std::filesystem::remove(header->file);
    std::ofstream(header->file) << "#error read as text\n";
    const harness::Build built = here.build(use_of_vectors, header);
    EXPECT_TRUE(built.by_header) << built.diagnostics;
    EXPECT_EQ(built.diagnostics, "");
}

TEST(HeaderShelf, KeepsItForTheNextRun) {
    const Shelf here;
    EXPECT_THAT(here.shelf().made(), IsEmpty());
    ASSERT_TRUE(here.shelf().get(vectors));
    EXPECT_THAT(here.shelf().made(), ElementsAre(vectors));
    const harness::Sandbox next{strongest_tier()};
    auto settings = here.settings;
    settings.limits.cpu = 1ms;  // too little to make another
    const HeaderShelf shelf(here.cache.path(), settings, "g++ 12", next);
    const auto header = shelf.get(vectors);
    ASSERT_TRUE(header);
    EXPECT_TRUE(here.build(use_of_vectors, header).compiled);
}

TEST(HeaderShelf, MakesNoneWhereWhatIsMissingStaysMissing) {
    const Shelf here;
    const auto shelf = [&] {
        return HeaderShelf(here.cache.path(), here.settings, "g++ 12", here.sandbox, {},
                           harness::Missing::stays_missing);
    };
    EXPECT_FALSE(shelf().get(vectors));
    EXPECT_TRUE(std::filesystem::is_empty(here.cache.path() / "headers")) << "nor is it refused for later";
    {
        const harness::Sandbox other{strongest_tier()};
        ASSERT_TRUE(HeaderShelf(here.cache.path(), here.settings, "g++ 12", other).get(vectors));
    }
    const auto header = shelf().get(vectors);
    ASSERT_TRUE(header) << "what is there it gives";
    EXPECT_TRUE(here.build(use_of_vectors, header).by_header);
}

TEST(HeaderShelf, TakesNoneOfAnotherToolchainOrOtherFlags) {
    Shelf here;
    ASSERT_TRUE(here.shelf().get(vectors));
    EXPECT_THAT(here.shelf("g++ 13").made(), IsEmpty());
    here.settings.flags.emplace_back("-DA");
    EXPECT_THAT(here.shelf().made(), IsEmpty());
}

TEST(HeaderShelf, TakesNoneWhoseTextIsNotItsOwn) {
    const Shelf here;
    ASSERT_TRUE(here.shelf().get(vectors));
    for (const auto& entry : std::filesystem::directory_iterator(here.cache.path() / "headers")) {
        if (entry.path().extension() == ".h") here.cache.write(entry.path(), "#include <list>\n");
    }
    EXPECT_THAT(here.shelf().made(), IsEmpty());
}

TEST(HeaderShelf, HasNoneOfWhatTheCompilerDoesNotTakeWithoutAWord) {
    const Shelf here;
    for (const HeaderLines& lines :
         {HeaderLines{"#include <no/such/header>"}, HeaderLines{"#define GLM_ENABLE_EXPERIMENTAL 1"},
          HeaderLines{"#define __FILE__ 1"}}) {
        EXPECT_FALSE(here.shelf().get(lines)) << lines[0];
        EXPECT_FALSE(here.shelf().get(lines)) << "nor the second time: " << lines[0];
    }
    EXPECT_THAT(here.shelf().made(), IsEmpty());
}

TEST(HeaderShelf, DoesWithoutAFolderItCanNotWrite) {
    const Shelf here;
    for (const auto& cache : {std::optional<std::filesystem::path>("/proc/raygrade"), {}}) {
        const HeaderShelf shelf(cache, here.settings, "g++ 12", here.sandbox);
        EXPECT_TRUE(shelf.get(vectors));
        EXPECT_THAT(shelf.made(), IsEmpty());
    }
}

TEST(HeaderShelf, RemovesWhatIsBeyondItsBounds) {
    const Shelf here;
    ASSERT_TRUE(here.shelf().get(vectors));
    EXPECT_THAT(here.shelf("g++ 12", {.bytes = 1000, .age = 24h}).made(), IsEmpty());
    EXPECT_TRUE(std::filesystem::is_empty(here.cache.path() / "headers"));
    // The workspace has its own, so it can be kept anew.
    ASSERT_TRUE(here.shelf().get({"#include <list>"}));
    for (const auto& entry : std::filesystem::directory_iterator(here.cache.path() / "headers"))
        std::filesystem::last_write_time(entry.path(), std::filesystem::file_time_type::clock::now() - 25h);
    EXPECT_THAT(here.shelf("g++ 12", {.bytes = 1 << 30, .age = 24h}).made(), IsEmpty());
}

}  // namespace
