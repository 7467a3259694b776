#include "tests/scenario/served/serving.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace scenario {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using harness::serve::HttpAnswer;
using nlohmann::json;

Serving::Serving() {
    fs::create_directories(folder / "run");
    fs::permissions(folder.path(), static_cast<fs::perms>(0755));
}

Serving::~Serving() {
    if (server > 0) end(SIGKILL);
}

Preparation Serving::prepare() const {
    return [this] { return setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1) == 0; };
}

void Serving::start(std::vector<std::string> more, const Preparation& more_preparation) {
    more.insert(more.begin(), {"serve", "--assignment", assignment, "--port", "0"});
    fs::remove(output());
    server = fork();
    if (server == 0) {
        const auto all = [&] { return prepare()() && (!more_preparation || more_preparation()); };
        become_raygrade(more, all, output(), voice());
    }
    const auto late = std::chrono::steady_clock::now() + patience;
    while (port == 0 && std::chrono::steady_clock::now() < late) {
        std::this_thread::sleep_for(10ms);
        const std::string said = fs::exists(output()) ? read(output()) : "";
        const auto at = said.find("http://");  // behind a proxy it is not the first word
        const auto end = at == std::string::npos ? at : said.find("/\n", at);
        if (end != std::string::npos)
            port = static_cast<std::uint16_t>(std::stoi(said.substr(said.rfind(':', end) + 1)));
    }
    ASSERT_NE(port, 0) << read(voice());
}

int Serving::end(int signal) {
    kill(server, signal);
    int status = 0;
    waitpid(server, &status, 0);
    server = 0;
    port = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string Serving::hand_in(std::string_view source) const {
    const HttpAnswer answer = ask(harness::serve::upload(std::string(source)));
    EXPECT_EQ(answer.status, 303) << answer.body;
    return "/" + answer.fields.at("location");
}

json Serving::standing(const std::string& result) const {
    return json::parse(ask(harness::serve::get(result + "/standing")).body);
}

json Serving::outcome(const std::string& result) const {
    const auto late = std::chrono::steady_clock::now() + patience;
    json now = standing(result);
    while ((now.at("standing") == "waiting" || now.at("standing") == "grading") &&
           std::chrono::steady_clock::now() < late) {
        std::this_thread::sleep_for(50ms);
        now = standing(result);
    }
    return now;
}

}  // namespace scenario
