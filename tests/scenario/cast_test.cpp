// `raygrade cast` as a program uses it: rays on stdin, answers on stdout.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string ray = "{\"origin\":[0.25,0.5,3],\"direction\":[0,0,-2]}\n";
const std::string hit = "{\"first\":\"mesh 0\",\"face\":1,\"t\":1.5,\"u\":0.25,\"v\":0.5}\n";

/// The same as records.
const std::string ray_record{
    "\0\0\0\0\0\0\xd0\x3f\0\0\0\0\0\0\xe0\x3f\0\0\0\0\0\0\x08\x40"
    "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\xc0",
    48};
const std::string hit_record{
    "\3\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0"
    "\0\0\0\0\0\0\xf8\x3f\0\0\0\0\0\0\xd0\x3f\0\0\0\0\0\0\xe0\x3f",
    40};

/// A scene file with a mesh of two faces, one of them without area.
class Cast : public testing::Test {
  protected:
    Cast() {
        const std::string lit = read(project_folder() / "reference/scenes/lit.toml");
        write(folder_ / "scenes/mesh.toml", lit.substr(0, lit.find("[[sphere]]")) + "[[mesh]]\nfile = \"flat.obj\"\n");
        write(folder_ / "scenes/flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 3 1\nf 1 2 3\n");
    }

    Result cast(std::vector<std::string> arguments, const std::string& input, const Preparation& also = {}) const {
        write(folder_ / "input", input);
        arguments.insert(arguments.begin(), "cast");
        return raygrade(arguments, [&] {
            const int in = open((folder_ / "input").c_str(), O_RDONLY);
            return dup2(in, STDIN_FILENO) == STDIN_FILENO && (!also || also());
        });
    }
    std::string scene() const { return (folder_ / "scenes/mesh.toml").string(); }

    TemporaryFolder folder_;
};

TEST_F(Cast, AnswersRaysAtASceneWithAMesh) {
    const Result result = cast({"--scene", scene()}, ray + ray);
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.output, hit + hit);
    EXPECT_THAT(result.voice, HasSubstr("note: 1 of 2 triangles of flat.obj left out: they have no area."));
}

TEST_F(Cast, AnswersTheSameInRecords) {
    const Result result = cast({"--scene", scene(), "--binary", "-j", "3"}, ray_record + ray_record);
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.output, hit_record + hit_record);
}

/// It sends a ray and waits for the answer before it sends the next one.
TEST_F(Cast, AnswersAProgramThatWaits) {
    std::array<int, 2> rays{}, answers{};
    ASSERT_EQ(pipe(rays.data()) + pipe(answers.data()), 0);
    const pid_t child = fork();
    if (child == 0) {
        const auto connect = [&] {
            close(rays[1]);
            return dup2(rays[0], STDIN_FILENO) == STDIN_FILENO && dup2(answers[1], STDOUT_FILENO) == STDOUT_FILENO;
        };
        become_raygrade({"cast", "--scene", scene(), "--binary"}, connect, "/dev/null", folder_ / "voice");
    }
    close(rays[0]);
    close(answers[1]);
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(::write(rays[1], ray_record.data(), ray_record.size()), static_cast<ssize_t>(ray_record.size()));
        pollfd ready{answers[0], POLLIN, 0};
        ASSERT_EQ(poll(&ready, 1, 60'000), 1) << "no answer within a minute";
        std::string answer(hit_record.size(), '\0');
        ASSERT_EQ(::read(answers[0], answer.data(), answer.size()), static_cast<ssize_t>(answer.size()));
        EXPECT_EQ(answer, hit_record);
    }
    close(rays[1]);
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    close(answers[0]);
}

TEST_F(Cast, NamesTheRecordThatIsCutOff) {
    const Result result = cast({"--scene", scene(), "--binary"}, ray_record + ray_record.substr(0, 20));
    EXPECT_EQ(result.status, some_not_graded);
    EXPECT_EQ(result.output, hit_record);
    EXPECT_THAT(result.voice, HasSubstr("record 2 is cut off after 20 of its 48 bytes"));
}

TEST_F(Cast, NamesTheLineThatIsNoRay) {
    const Result result = cast({"--scene", scene()}, ray + "{\"origin\":[0,0,0]}\n" + ray);
    EXPECT_EQ(result.status, some_not_graded);
    EXPECT_EQ(result.output, hit + R"({"error":"a query must have an origin and a direction","line":2})" + "\n" + hit);
}

TEST_F(Cast, AnswersQueriesThatBringTheirOwnObjects) {
    const Result result =
        cast({}, R"({"origin":[0,0,2],"direction":[0,0,-1],"spheres":[{"center":[0,0,0],"radius":1}]})");
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.output, R"({"spheres":[{"result":"hit","t":1}],"triangles":[],"first":"sphere 0"})"
                             "\n");
}

TEST_F(Cast, TakesRecordsOnlyForAScene) {
    const Result result = cast({"--binary"}, ray_record);
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.output, IsEmpty());
    EXPECT_THAT(result.voice, HasSubstr("--scene"));
}

TEST_F(Cast, SaysWhatIsWrongWithTheMesh) {
    write(folder_ / "scenes/flat.obj", "v 0 0\n");
    const Result result = cast({"--scene", scene()}, ray);
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("flat.obj: vertex 1 has fewer than three coordinates"));
}

TEST_F(Cast, SaysThatAnswersAreMissingOnAFullDisk) {
    const Result result = cast({"--scene", scene()}, ray, [] {
        const int full = open("/dev/full", O_WRONLY);
        return dup2(full, STDOUT_FILENO) == STDOUT_FILENO;
    });
    EXPECT_EQ(result.status, some_not_graded);
    EXPECT_THAT(result.voice, HasSubstr("stdout can't be written to"));
}

}  // namespace
}  // namespace scenario
