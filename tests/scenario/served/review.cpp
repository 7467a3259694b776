#include "tests/scenario/served/review.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <cstdio>
#include <regex>
#include <string>
#include <thread>

#include "tests/given/serve/client.h"
#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using harness::serve::HttpAnswer;

std::string encoded(const Fields& fields) {
    std::string body;
    for (const auto& [name, value] : fields) {
        body += (body.empty() ? "" : "&") + name + "=";
        for (const unsigned char c : value) {
            char hex[4];
            std::snprintf(hex, sizeof hex, "%%%02X", c);
            body += std::isalnum(c) != 0 ? std::string(1, static_cast<char>(c)) : hex;
        }
    }
    return body;
}

}  // namespace

std::string twice(const std::string& numbers, const std::string& title) {
    return "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(" + numbers + ")\\n" + title +
           ":\\na: 1\\nQuestion 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); }\n";
}

Review::Review() {
    fs::permissions(folder.path(), static_cast<fs::perms>(0755));
    fs::create_directories(folder / "run");
    write(student("ada"), twice("0.5, 0, -1"));
    write(student("ben"), twice("0.25, 0, -1"));
    write(student("cy"), twice("0.125, 0, -1", "Sphere of question 6"));
    write(student("dee"), small_program);
    fs::create_directories(folder / "class/eve");
    grade();
    start();
}

void Review::start() {
    server = fork();
    if (server == 0)
        become_raygrade({"review", out().string(), "--by", "Prof. X"}, {}, folder / "run/out", folder / "run/err");
    const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    std::smatch found;
    while (port == 0 && std::chrono::steady_clock::now() < late) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        const std::string said = fs::exists(folder / "run/out") ? read(folder / "run/out") : "";
        if (!std::regex_search(said, found, std::regex("Open http://127\\.0\\.0\\.1:(\\d+)(/[0-9a-f]{32})/\n")))
            continue;
        port = static_cast<std::uint16_t>(std::stoi(found[1]));
        root = found[2];
    }
    ASSERT_NE(port, 0) << read(folder / "run/err");
}

int Review::end() {
    kill(server, SIGTERM);
    int status = 0;
    waitpid(server, &status, 0);
    server = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

HttpAnswer Review::post(const std::string& path, const Fields& fields, const std::string& more) const {
    const std::string body = encoded(fields);
    return harness::serve::ask(port, "POST " + root + path +
                                         " HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                                         "application/x-www-form-urlencoded\r\n" +
                                         more + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
}

Fields Review::whose(const std::string& page) {
    std::smatch id, state;
    const bool found = std::regex_search(page, id, std::regex("name=\"student\" value=\"([^\"]*)\"")) &&
                       std::regex_search(page, state, std::regex("name=\"state\" value=\"([0-9a-f]{32})\""));
    EXPECT_TRUE(found) << page;
    return found ? Fields{{"student", id[1]}, {"state", state[1]}} : Fields{};
}

std::string Review::decision(const HttpAnswer& answer) {
    EXPECT_EQ(answer.status, 303) << answer.body;
    const std::string location = answer.status == 303 ? answer.fields.at("location") : "/";
    return location.substr(location.rfind('/') + 1);
}

std::vector<std::string> Review::offered(const std::string& page) {
    std::vector<std::string> all;
    const std::regex box("name=\"who\" value=\"([^\"]*)\"");
    for (std::sregex_iterator it(page.begin(), page.end(), box), end; it != end; ++it) all.push_back((*it)[1]);
    return all;
}

}  // namespace scenario
