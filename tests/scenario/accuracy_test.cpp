// `raygrade accuracy` as a person runs it: what it prints and writes, and the files it refuses to overwrite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

Result accuracy(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"accuracy", "--quick", "--rays", "256"});
    return raygrade(arguments);
}

TEST(Accuracy, PrintsATableAndWritesNothingByDefault) {
    const Result result = accuracy({});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr("Ray and sphere"));
    EXPECT_THAT(result.output, HasSubstr("\n* ")) << "the frontier is marked";
    EXPECT_THAT(result.both(), Not(HasSubstr("\x1b["))) << "no progress bar into a file";
}

TEST(Accuracy, WritesPagePictureAndFigures) {
    const TemporaryFolder folder;
    const Result result = accuracy({"--seed", "5", "--out", (folder / "out").string(), "--format", "json"});
    ASSERT_EQ(result.status, 0) << result.both();
    EXPECT_EQ(json::parse(result.output), read_json(folder / "out/accuracy.json"));
    EXPECT_EQ(json::parse(result.output).at("seed"), 5);
    EXPECT_THAT(read(folder / "out/accuracy.html"), HasSubstr("<h1>What accuracy costs in time</h1>"));
    EXPECT_THAT(read(folder / "out/accuracy.svg"), HasSubstr("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_THAT(read(folder / "out/accuracy.csv"), HasSubstr("primitive,kernel,scalar"));
    EXPECT_THAT(result.voice, HasSubstr("accuracy.html"));
}

TEST(Accuracy, PrintsItsSummaryAloneInAQuickRunAndWhereThePageShowsTheRest) {
    const TemporaryFolder folder;
    const Result whole = raygrade({"accuracy", "--rays", "256"});
    const Result with_page = raygrade({"accuracy", "--rays", "256", "--out", (folder / "out").string()});
    EXPECT_THAT(whole.output, HasSubstr("mean ULP")) << "the head of a distribution's table";
    for (const std::string& summary : {with_page.output, accuracy({}).output}) {
        EXPECT_THAT(summary, HasSubstr("Ray and sphere"));
        EXPECT_THAT(summary, Not(HasSubstr("mean ULP")));
    }
}

TEST(Accuracy, ReplacesItsEarlierResultsOnlyWithForce) {
    const TemporaryFolder folder;
    write(folder / "out/accuracy.json", "earlier");
    const std::vector<std::string> arguments{"--out", (folder / "out").string()};
    const Result refused = accuracy(arguments);
    EXPECT_EQ(refused.status, usage);
    EXPECT_THAT(refused.voice, HasSubstr("--force"));
    EXPECT_EQ(read(folder / "out/accuracy.json"), "earlier");
    std::vector<std::string> forced = arguments;
    forced.emplace_back("--force");
    EXPECT_EQ(accuracy(forced).status, 0);
    EXPECT_NE(read(folder / "out/accuracy.json"), "earlier");
}

TEST(Accuracy, NeverWritesIntoAFolderWithOtherFiles) {
    const TemporaryFolder folder;
    write(folder / "out/thesis.tex", "years");
    const Result result = accuracy({"--force", "--out", (folder / "out").string()});
    EXPECT_EQ(result.status, usage);
    EXPECT_FALSE(fs::exists(folder / "out/accuracy.json"));
}

TEST(Accuracy, ExaminesAnAssignmentWithoutMeasuringRays) {
    const Result result = raygrade({"accuracy", "--assignment", "a6-2021"});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr("triangle: t is exactly 0"));
    EXPECT_THAT(result.output, HasSubstr("× float"));
    EXPECT_THAT(result.output, Not(HasSubstr("rays of each distribution")));
}

TEST(Accuracy, RefusesCsvForAnAssignment) {
    const Result result = raygrade({"accuracy", "--assignment", "a6-2021", "--format", "csv"});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("--format json"));
}

/// An OBJ file: a tetrahedron, or one that lacks a face.
void write_tetrahedron(const fs::path& file, bool is_closed) {
    write(file, std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n") +
                    (is_closed ? "f 2 3 4\n" : ""));
}

TEST(Accuracy, MeasuresMeshesAlone) {
    const TemporaryFolder folder;
    write_tetrahedron(folder / "closed.obj", true);
    write_tetrahedron(folder / "open.obj", false);
    const Result result =
        accuracy({"--mesh", (folder / "closed.obj").string(), "--mesh", (folder / "open.obj").string()});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr("Ray and closed.obj: 2 benign and 4 hard distributions"));
    EXPECT_THAT(result.output, HasSubstr("closed.obj: 4 triangles"));
    EXPECT_THAT(result.output, HasSubstr("as 3 of its faces'"));
    EXPECT_THAT(result.output, HasSubstr("textbook float"));
    EXPECT_THAT(result.output, Not(HasSubstr("Ray and sphere")));
}

TEST(Accuracy, AddsAMeshToThePage) {
    const TemporaryFolder folder;
    write_tetrahedron(folder / "rock.obj", true);
    const Result result =
        accuracy({"--mesh", (folder / "rock.obj").string(), "--out", (folder / "out").string(), "--format", "json"});
    ASSERT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(read(folder / "out/accuracy.html"), HasSubstr(">Ray and sphere</text>"));
    EXPECT_THAT(read(folder / "out/accuracy.html"), HasSubstr(">Ray and rock.obj</text>"));
    EXPECT_THAT(read(folder / "out/accuracy.svg"), HasSubstr(">Ray and rock.obj</text>"));
    const json figures = json::parse(result.output);
    EXPECT_EQ(figures.at("meshes").at(0).at("open_edges"), 0);
    std::size_t certified = 0;
    for (const json& row : figures.at("rows")) {
        if (row.at("mesh") != "rock.obj" || !row.at("certain")) continue;
        ++certified;
        EXPECT_EQ(row.at("wrong"), 0) << row.at("distribution");
    }
    EXPECT_GE(certified, 6U);
}

TEST(Accuracy, RefusesMeshesThatItCantMeasure) {
    const TemporaryFolder folder;
    write_tetrahedron(folder / "rock.obj", true);
    write_tetrahedron(folder / "other/rock.obj", true);
    write(folder / "broken.obj", "v 0 0 0\nf 1 2 3\n");
    write(folder / "line.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\n");
    const auto refused = [&](const std::vector<std::string>& files) {
        std::vector<std::string> arguments;
        for (const std::string& file : files) arguments.insert(arguments.end(), {"--mesh", (folder / file).string()});
        const Result result = accuracy(arguments);
        EXPECT_EQ(result.status, usage) << result.both();
        return result.voice;
    };
    EXPECT_THAT(refused({"rock.obj", "other/rock.obj"}), HasSubstr("two meshes are called rock.obj"));
    EXPECT_THAT(refused({"broken.obj"}), HasSubstr("face 1 names vertex 2"));
    EXPECT_THAT(refused({"line.obj"}), HasSubstr("three different corners"));
    EXPECT_THAT(refused({"nowhere.obj"}), HasSubstr("nowhere.obj"));
    const Result kernel = accuracy({"--kernel", "certified", "--mesh", (folder / "rock.obj").string()});
    EXPECT_EQ(kernel.status, usage);
    EXPECT_THAT(kernel.voice, HasSubstr("--out"));
}

TEST(Accuracy, RefusesAnUnknownMethod) {
    const Result result = accuracy({"--kernel", "nonsense"});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("nonsense"));
}

}  // namespace
}  // namespace scenario
