#include "harness/build/header_cache.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "harness/run/limits.h"
#include "tests/given/strongest_tier.h"
#include "tests/given/temporary_folder.h"

namespace {

using namespace std::chrono_literals;
using harness::HeaderCache;
using harness::HeaderLines;

const HeaderLines vectors{"#include <vector>"};
const std::string use_of_vectors = "#include <vector>\nint main() { std::vector<int> v(3); return v[0]; }\n";

struct CachedHeaders {
    harness::BuildSettings settings = harness::default_build_settings(harness::read_limits({}, {}).compile);
    harness::Sandbox sandbox{strongest_tier()};
    TemporaryFolder folder;

    HeaderCache headers(const std::string& toolchain = "g++ 12", const harness::HeaderCacheBounds& bounds = {}) const {
        return HeaderCache(folder.path(), settings, toolchain, sandbox, bounds);
    }
    harness::Build build(const std::string& source, const std::optional<std::filesystem::path>& header) const {
        harness::Submission submission;
        submission.source = source;
        const harness::Scratch scratch(sandbox.workspace());
        return harness::build(submission, settings, sandbox, scratch, header);
    }
};

TEST(HeaderCache, MakesAHeaderThatTheCompilerAccepts) {
    const CachedHeaders here;
    const auto header = here.headers().get(vectors);
    ASSERT_TRUE(header);
    struct stat info {};
    ASSERT_EQ(stat((header->string() + ".gch").c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, 0444U) << "read by everyone, written by nobody";
    EXPECT_EQ(info.st_uid, geteuid());
    // If the compiler read the text instead of the precompiled header, the source would not compile.
    std::filesystem::remove(*header);
    std::ofstream(*header) << "#error read as text\n";
    const harness::Build built = here.build(use_of_vectors, header);
    EXPECT_TRUE(built.by_header) << built.diagnostics;
    EXPECT_EQ(built.diagnostics, "");
}

TEST(HeaderCache, KeepsAHeaderForTheNextRun) {
    const CachedHeaders here;
    EXPECT_FALSE(here.headers().is_kept(vectors));
    ASSERT_TRUE(here.headers().get(vectors));
    EXPECT_TRUE(here.headers().is_kept(vectors));
    const harness::Sandbox next{strongest_tier()};
    auto settings = here.settings;
    settings.limits.cpu = 1ms;  // too little to make a new header
    const HeaderCache cache(here.folder.path(), settings, "g++ 12", next);
    const auto header = cache.get(vectors);
    ASSERT_TRUE(header);
    EXPECT_TRUE(here.build(use_of_vectors, header).compiled);
}

TEST(HeaderCache, IgnoresHeadersOfADifferentToolchainOrFlags) {
    CachedHeaders here;
    ASSERT_TRUE(here.headers().get(vectors));
    EXPECT_FALSE(here.headers("g++ 13").is_kept(vectors));
    here.settings.flags.emplace_back("-DA");
    EXPECT_FALSE(here.headers().is_kept(vectors));
}

TEST(HeaderCache, MakesNoHeaderThatTheCompilerWarnsAboutOrRejects) {
    const CachedHeaders here;
    for (const HeaderLines& lines :
         {HeaderLines{"#include <no/such/header>"}, HeaderLines{"#define GLM_ENABLE_EXPERIMENTAL 1"},
          HeaderLines{"#define __FILE__ 1"}}) {
        EXPECT_FALSE(here.headers().get(lines)) << lines[0];
        EXPECT_FALSE(here.headers().is_kept(lines)) << lines[0];
    }
}

TEST(HeaderCache, WorksWithoutAWritableFolder) {
    const CachedHeaders here;
    for (const auto& folder : {std::optional<std::filesystem::path>("/proc/raygrade"), {}}) {
        const HeaderCache cache(folder, here.settings, "g++ 12", here.sandbox);
        EXPECT_TRUE(cache.get(vectors));
        EXPECT_FALSE(cache.is_kept(vectors));
    }
}

TEST(HeaderCache, RemovesHeadersBeyondItsBounds) {
    const CachedHeaders here;
    ASSERT_TRUE(here.headers().get(vectors));
    EXPECT_FALSE(here.headers("g++ 12", {.bytes = 1000, .age = 24h}).is_kept(vectors));
    EXPECT_TRUE(std::filesystem::is_empty(here.folder.path() / "headers"));
    // The workspace has a copy of the header, so it can be stored again.
    ASSERT_TRUE(here.headers().get({"#include <list>"}));
    for (const auto& entry : std::filesystem::directory_iterator(here.folder.path() / "headers"))
        std::filesystem::last_write_time(entry.path(), std::filesystem::file_time_type::clock::now() - 25h);
    EXPECT_FALSE(here.headers("g++ 12", {.bytes = 1 << 30, .age = 24h}).is_kept(vectors));
}

}  // namespace
