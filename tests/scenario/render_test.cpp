// `raygrade render` as a person runs it: the picture, the explanation, and the files it refuses to overwrite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* png = "\x89PNG\r\n\x1a\n";

std::string scene_file(const std::string& name) {
    return (project_folder() / "reference/scenes" / name).string();
}

TEST(Render, DrawsAnAssignmentAndExplainsIt) {
    const TemporaryFolder folder;
    const std::string out = (folder / "2021.png").string();
    const Result result = raygrade({"render", "--assignment", "a6-2021", "-o", out, "--size", "60x40", "--explain"});
    ASSERT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(read(out), StartsWith(png));
    EXPECT_THAT(result.output, HasSubstr("shadows              off  no light: no shading, no shadow rays\n"));
    EXPECT_THAT(result.output, ContainsRegex("camera rays +2400 +2400\n"));
    EXPECT_THAT(result.output, ContainsRegex("mirrored rays +0 +[1-9][0-9]*\n"));
    EXPECT_THAT(result.output, HasSubstr("\nEqual pictures; all effects take "));
    EXPECT_THAT(result.voice, HasSubstr(out));
}

TEST(Render, RefusesAnInvalidSize) {
    for (const char* size : {"640", "640x", "x480", "0x4", "4x0", "640x480x2", "-4x3", "4 x3", "99999999999x1"}) {
        const Result result = raygrade({"render", "--size", size, "-o", "/dev/null/a.png"});
        EXPECT_EQ(result.status, usage) << size;
        EXPECT_THAT(result.voice, HasSubstr("640x480")) << size;
    }
}

TEST(Render, AcceptsASceneWithoutAPixelOnlyForRendering) {
    const TemporaryFolder folder;
    const std::string out = (folder / "a.png").string();
    EXPECT_EQ(raygrade({"render", "--scene", scene_file("lit.toml"), "--size", "4x3", "-o", out}).status, 0);
    const Result result =
        raygrade({"render", "--assignment", scene_file("lit.toml"), "--size", "4x3", "-o", out, "--force"});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("window.pixel"));
    EXPECT_EQ(raygrade({"render", "--scene", scene_file("lit.toml"), "--assignment", "a6-2021", "-o", out}).status,
              usage);
    EXPECT_THAT(raygrade({"render", "--scene", "nowhere.toml", "-o", out, "--force"}).voice,
                HasSubstr("nowhere.toml; name a scene's .toml file"));
}

}  // namespace
}  // namespace scenario
