// Valid and invalid OBJ files. Each mistake is reported with the file's name and the way out.
#include "reference/render/scene/mesh_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "reference/toml/assignment_error.h"
#include "tests/given/message_of.h"

namespace {

using namespace reference;
using namespace reference::render;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

std::vector<Triangle<double>> read(const std::string& text) {
    std::istringstream obj(text);
    return read_mesh(obj, "bunny.obj");
}

std::string complaint(const std::string& text) {
    return message_of<AssignmentError>([&] { read(text); }, "accepted");
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(MeshReader, ReadsVerticesAndFaces) {
    const auto triangles = read(
        "# a comment\nmtllib none.mtl\no thing\nv 0 0 0\nv 1.5 0 -2e-1\nv 0 1 0\nvn 0 0 1\nvt 0 0\n"
        "usemtl none\ns off\nf 1/1/1 2/1/1 3//1\n");
    ASSERT_EQ(triangles.size(), 1U);
    EXPECT_EQ(triangles[0].B, Vec3<double>(1.5, 0, -0.2));
}

TEST(MeshReader, ReadsCoordinatesToTheirLastBit) {
    const auto triangles = read(
        "v 0.3 +0.7 1e-320\nv 0.1234567890123456789 -0 4503599627370497.5\nv 1. .5 -1E+2 0.9 0.9 0.9\n"
        "\tf  +1 2/9 3//9 \r\n");
    ASSERT_EQ(triangles.size(), 1U);
    EXPECT_EQ(triangles[0].A, Vec3<double>(0.3, 0.7, 1e-320));
    EXPECT_EQ(triangles[0].B, Vec3<double>(0.1234567890123456789, 0, 4503599627370497.5));
    EXPECT_EQ(triangles[0].C, Vec3<double>(1, 0.5, -100));
}

TEST(MeshReader, SplitsAPolygonIntoAFan) {
    const auto triangles = read(square + "f 1 2 3 4\n");
    ASSERT_EQ(triangles.size(), 2U);
    EXPECT_EQ(triangles[1].A, Vec3<double>(0, 0, 0));
    EXPECT_EQ(triangles[1].B, Vec3<double>(1, 1, 0));
    EXPECT_EQ(triangles[1].C, Vec3<double>(0, 1, 0));
    std::string wheel;
    std::string face = "f";
    for (int i = 1; i <= 300; ++i) {
        wheel += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
        face += " " + std::to_string(i);
    }
    EXPECT_EQ(read(wheel + face + "\n").size(), 298U);
}

TEST(MeshReader, CountsNegativeIndicesFromTheLastVertex) {
    EXPECT_EQ(read(square + "f -4 -3 -1\n")[0].C, Vec3<double>(0, 1, 0));
}

TEST(MeshReader, NamesTheFileAndWhatIsWrongWithIt) {
    const auto says = [](const std::string& what) { return AllOf(StartsWith("bunny.obj: "), HasSubstr(what)); };
    EXPECT_THAT(complaint(square + "f 1 2 5\n"), says("names vertex 5, and 4 vertices come before it"));
    EXPECT_THAT(complaint(square + "f 1 2 -5\n"), says("names vertex -5"));
    EXPECT_THAT(complaint("f 1 2 3\n" + square), says("0 vertices come before it"));
    EXPECT_THAT(complaint(square + "f 1 2\n"), says("a face has three or more"));
    EXPECT_THAT(complaint("v 0 0 1e31\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), says("vertex 1 has a coordinate beyond 1e30"));
    EXPECT_THAT(complaint("v 0 0 1e999\n"), says("vertex 1: \"1e999\" is not a number that a double holds"));
    EXPECT_THAT(complaint("v 0 0 nan\n"), says("vertex 1 has a coordinate beyond 1e30"));
    EXPECT_THAT(complaint("v 0 0 -inf\n"), says("vertex 1 has a coordinate beyond 1e30"));
    EXPECT_THAT(complaint("v 0 0 0\nv 1 0 0,5\n"), says("vertex 2: \"0,5\" is not a number"));
    EXPECT_THAT(complaint("v 0 0 +-1\n"), says("vertex 1: \"+-1\" is not a number"));
    EXPECT_THAT(complaint("v 1 2\n"), says("vertex 1 has fewer than three coordinates"));
    EXPECT_THAT(complaint(square + "f 1 2 0\n"), says("names vertex 0"));
    EXPECT_THAT(complaint(square + "f 1 2 x\n"), says("face 1: \"x\" is not a vertex's number"));
    EXPECT_THAT(complaint(square + "f 1 2 /3\n"), says("face 1: \"/3\" is not a vertex's number"));
    EXPECT_THAT(complaint(square + "f 1 2 99999999999999999999\n"), says("is not a vertex's number"));
    EXPECT_THAT(complaint(""), says("holds no faces"));
    EXPECT_THAT(complaint(square), says("holds no faces"));
    EXPECT_THAT(complaint(std::string("\x7f"
                                      "ELF\0\0\n\n\n",
                                      9)),
                says("bunny.obj: "));
}

TEST(MeshReader, ReportsAMissingFileWithItsPlaceInTheScene) {
    const MeshFile mesh{"nowhere/bunny.obj", {}, "scene.toml:7: mesh[1].file"};
    EXPECT_THAT(
        [&] { load_mesh(mesh); },
        ThrowsMessage<AssignmentError>(AllOf(HasSubstr("scene.toml:7"), HasSubstr("nowhere/bunny.obj: no such file"))));
}

/// A file cut off anywhere is read or refused.
TEST(MeshReader, ReadsOrRefusesAFileCutOffAnywhere) {
    const std::string whole =
        "v 0 0 0\nv 1 0 0\nv 0 1e0 -0.5\nf 1/2/3 2//3 -1\nusemtl x\ng a b\nt crease 1/0/1 2.5\nl 1 2\n";
    for (std::size_t end = 0; end <= whole.size(); ++end) {
        try {
            EXPECT_LE(read(whole.substr(0, end)).size(), 1U);
        } catch (const AssignmentError&) {
        }
    }
}

}  // namespace
