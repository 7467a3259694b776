// `raygrade cast` as a program uses it: queries on stdin, answers on stdout.
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

using testing::HasSubstr;

const std::string query =
    "{\"origin\":[0,0,2],\"direction\":[0,0,-1],\"spheres\":[{\"center\":[0,0,0],\"radius\":1}]}\n";
const std::string answer = "{\"spheres\":[{\"result\":\"hit\",\"t\":1}],\"triangles\":[],\"first\":\"sphere 0\"}\n";

class Cast : public testing::Test {
  protected:
    Result cast(const std::string& input, const Preparation& also = {}) const {
        write(folder_ / "input", input);
        return raygrade({"cast"}, [&] {
            const int in = open((folder_ / "input").c_str(), O_RDONLY);
            return dup2(in, STDIN_FILENO) == STDIN_FILENO && (!also || also());
        });
    }

    TemporaryFolder folder_;
};

/// It sends a query and waits for the answer before it sends the next one.
TEST_F(Cast, AnswersEachLineAtOnce) {
    std::array<int, 2> queries{}, answers{};
    ASSERT_EQ(pipe(queries.data()) + pipe(answers.data()), 0);
    const pid_t child = fork();
    if (child == 0) {
        const auto connect = [&] {
            close(queries[1]);
            return dup2(queries[0], STDIN_FILENO) == STDIN_FILENO && dup2(answers[1], STDOUT_FILENO) == STDOUT_FILENO;
        };
        become_raygrade({"cast"}, connect, "/dev/null", folder_ / "voice");
    }
    close(queries[0]);
    close(answers[1]);
    for (int i = 0; i < 3; ++i) {
        ASSERT_EQ(::write(queries[1], query.data(), query.size()), static_cast<ssize_t>(query.size()));
        pollfd ready{answers[0], POLLIN, 0};
        ASSERT_EQ(poll(&ready, 1, 60'000), 1) << "no answer within a minute";
        std::string received(answer.size(), '\0');
        ASSERT_EQ(::read(answers[0], received.data(), received.size()), static_cast<ssize_t>(received.size()));
        EXPECT_EQ(received, answer);
    }
    close(queries[1]);
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    close(answers[0]);
}

TEST_F(Cast, SaysThatAnswersAreMissingIfTheDiskIsFull) {
    const Result result = cast(query, [] {
        const int full = open("/dev/full", O_WRONLY);
        return dup2(full, STDOUT_FILENO) == STDOUT_FILENO;
    });
    EXPECT_EQ(result.status, some_not_graded);
    EXPECT_THAT(result.voice, HasSubstr("cannot write to stdout"));
}

}  // namespace
}  // namespace scenario
