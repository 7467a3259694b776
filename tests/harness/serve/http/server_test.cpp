// Clients that are slow, broken, greedy or hostile, and how the server treats the other clients meanwhile.
#include "harness/serve/http/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <list>
#include <thread>

#include "tests/given/serve/running_server.h"

namespace harness::serve {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

/// Whether the connection ends without a further complete answer.
bool ends_unanswered(Client& client) {
    return client.ends_within(soon) && client.answer().status == 0;
}

TEST(Server, AnswersAClientThatStillSendsARefusedBody) {
    const RunningServer server;
    Client client(server.port());
    client.send(upload(std::string(3 << 20, 'x')));
    const HttpAnswer answer = client.answer();
    EXPECT_EQ(answer.status, 413);
    EXPECT_THAT(answer.body, HasSubstr("1 MiB"));
    EXPECT_TRUE(client.ends_within(soon));
    EXPECT_FALSE(client.was_reset());
}

TEST(Server, RefusesAChunkedBodyThatGrowsTooLarge) {
    const RunningServer server;
    Client client(server.port());
    client.send(head_of_upload("Transfer-Encoding: chunked\r\n"));
    const std::string chunk = "10000\r\n" + std::string(0x10000, 'x') + "\r\n";
    for (int i = 0; i < 20 && client.send(chunk); ++i) {
    }
    EXPECT_EQ(client.answer().status, 413);
}

TEST(Server, AcceptsTheLargestAllowedProgram) {
    const RunningServer server;
    EXPECT_EQ(server.ask(upload(std::string(1 << 20, 'x'))).status, 303);
    EXPECT_EQ(server.ask(upload(std::string((1 << 20) + 1, 'x'))).status, 400);
}

TEST(Server, RefusesAHeadThatIsTooLarge) {
    const RunningServer server;
    const HttpAnswer one_field = server.ask(get("/", "X-Long: " + std::string(20'000, 'x') + "\r\n"));
    EXPECT_EQ(one_field.status, 431);
    std::string fields;
    for (int i = 0; i < 2000; ++i) fields += "X-" + std::to_string(i) + ": y\r\n";
    EXPECT_EQ(server.ask(get("/", fields)).status, 431);
    EXPECT_EQ(server.ask("GET /" + std::string(100'000, 'x')).status, 431);
    EXPECT_EQ(server.ask(get("/")).status, 200);
}

TEST(Server, CutsOffAHeadOrABodySentByteByByte) {
    RunningServer::Options options;
    options.limits.head_time = options.limits.body_time = 500ms;
    const RunningServer server(options);
    for (const std::string& begun :
         {std::string("GET / HTTP/1.1\r\nHost: localhost\r\nX-Slow: "), head_of_upload("Content-Length: 100000\r\n")}) {
        Client client(server.port());
        const auto begin = std::chrono::steady_clock::now();
        client.send(begun);
        while (client.send("x") && std::chrono::steady_clock::now() - begin < soon) std::this_thread::sleep_for(20ms);
        EXPECT_LT(std::chrono::steady_clock::now() - begin, soon) << begun;
        EXPECT_TRUE(ends_unanswered(client)) << begun;
    }
}

TEST(Server, CutsOffAClientThatDoesNotReadItsAnswer) {
    RunningServer::Options options;
    options.limits.answer_time = 500ms;
    options.limits.connections = 1;
    RunningServer server(options);
    const std::string result = "/" + server.ask(upload("x")).fields.at("location");
    server.queue().finish(server.queue().next().value(), {std::string(24 << 20, 'x'), 1, 1});
    constexpr int busy = 503;  // while the connection before still counts
    HttpAnswer answer;
    do {
        Client client(server.port());
        client.send(get(result));
        EXPECT_TRUE(server.has_room_within(soon)) << "it can't see that it was left without reading";
        EXPECT_TRUE(client.ends_within(soon));
        answer = client.answer();
    } while (answer.status == busy);
    EXPECT_EQ(answer.status, 0);
}

TEST(Server, CutsOffASilentConnection) {
    RunningServer::Options options;
    options.limits.head_time = 200ms;
    const RunningServer server(options);
    Client never_asks(server.port());
    EXPECT_TRUE(never_asks.ends_within(soon));
}

/// UnderAttack in scenario/served sends lengths that say two things.
TEST(Server, IsNotMisledAboutWhereARequestEnds) {
    const RunningServer server;
    const std::string smuggled = get("/style.css");
    // Neither a body nor what follows a request is read as the next one.
    for (const std::string& request :
         {get("/icon.svg", "Content-Length: " + std::to_string(smuggled.size()) + "\r\n"), get("/icon.svg")}) {
        Client client(server.port());
        client.send(request + smuggled);
        EXPECT_EQ(client.answer().status, 200);
        EXPECT_TRUE(ends_unanswered(client));
    }
}

TEST(Server, SendsContinueOnlyForAWelcomeBody) {
    const RunningServer server;
    const std::string whole = upload("int main() {}", "Expect: 100-continue\r\n");
    const std::size_t body = whole.find("\r\n\r\n") + 4;
    Client client(server.port());
    client.send(whole.substr(0, body));
    EXPECT_EQ(client.answer().status, 100);
    client.send(whole.substr(body));
    EXPECT_EQ(client.answer().status, 303);
    Client stranger(server.port());
    stranger.send(upload("x", "Expect: 100-continue\r\nOrigin: http://evil.example\r\n").substr(0, 200));
    EXPECT_EQ(stranger.answer().status, 403);
}

TEST(Server, RefusesAConnectionWhileAllOthersAreAtWork) {
    RunningServer::Options options;
    options.limits.connections = 3;
    const RunningServer server(options);
    std::list<Client> clients;
    for (int i = 0; i < 3; ++i) {
        clients.emplace_back(server.port()).send(head_of_upload("Expect: 100-continue\r\nContent-Length: 9\r\n"));
        ASSERT_EQ(clients.back().answer().status, 100);
    }
    const HttpAnswer refused = server.ask("");
    EXPECT_EQ(refused.status, 503);
    EXPECT_EQ(refused.fields.at("retry-after"), "5");
    clients.clear();
    EXPECT_TRUE(server.has_room_within(soon));
}

TEST(Server, StopsWithWorkLeft) {
    RunningServer server;
    EXPECT_EQ(server.ask(upload("x")).status, 303);
    server.stop();
    server.join();
    EXPECT_EQ(server.queue().unfinished(), 1U);
}

TEST(Server, DoesNotWaitForSilentClientsWhenStopped) {
    RunningServer::Options options;
    options.limits.head_time = 60s;
    RunningServer server(options);
    Client silent(server.port());
    ASSERT_EQ(server.ask(get("/icon.svg")).status, 200);
    server.stop();
    EXPECT_TRUE(silent.ends_within(soon));
}

}  // namespace
}  // namespace harness::serve
