// Who makes room when connections or their bodies are too many.
#include "harness/serve/http/connections.h"

#include <gtest/gtest.h>

#include <list>
#include <thread>

#include "tests/given/serve/running_server.h"

namespace harness::serve {
namespace {

using namespace std::chrono_literals;

TEST(Connections, AnAddressAtItsLimitGivesUpItsOwnIdleConnectionOrIsRefused) {
    RunningServer::Options options;
    options.limits.connections_of_one_address = 3;
    const RunningServer server(options);
    std::list<Client> clients;
    for (int i = 0; i < 3; ++i) {
        clients.emplace_back(server.port()).send(get("/icon.svg"));
        ASSERT_EQ(clients.back().answer().status, 200);
    }
    EXPECT_EQ(server.ask(get("/icon.svg")).status, 200) << "the longest idle one made room";
    EXPECT_TRUE(clients.front().ends_within(soon));
    clients.clear();
    ASSERT_TRUE(server.has_room_within(soon));
    for (int i = 0; i < 3; ++i) {
        clients.emplace_back(server.port()).send(head_of_upload("Expect: 100-continue\r\nContent-Length: 9\r\n"));
        ASSERT_EQ(clients.back().answer().status, 100);
    }
    const HttpAnswer refused = server.ask("");
    EXPECT_EQ(refused.status, 503) << "all are at work";
    EXPECT_EQ(refused.fields.at("retry-after"), "5");
    EXPECT_EQ(server.ask(get("/icon.svg"), 2).status, 200) << "another address";
    clients.clear();
    EXPECT_TRUE(server.has_room_within(soon));
}

TEST(Connections, ClosesTheLongestIdleConnectionToMakeRoom) {
    RunningServer::Options options;
    options.limits.connections = 3;
    options.limits.head_time = 5min;  // so that no connection ends by itself
    const RunningServer server(options);
    std::list<Client> clients;
    for (int i = 0; i < 3; ++i) {
        clients.emplace_back(server.port()).send(get("/icon.svg"));
        ASSERT_EQ(clients.back().answer().status, 200);
        std::this_thread::sleep_for(5ms);
    }
    EXPECT_EQ(server.ask(get("/")).status, 200);
    EXPECT_TRUE(clients.front().ends_within(soon));
    clients.back().send(get("/"));
    EXPECT_EQ(clients.back().answer().status, 200);
}

TEST(Connections, LimitsTheBytesOfAllBodiesTogether) {
    RunningServer::Options options;
    options.limits.all_body_bytes = 1'000'000;
    const RunningServer server(options);
    const std::string whole = upload(std::string(900'000, 'x'));
    constexpr std::size_t most = 800'000;
    Client a(server.port()), b(server.port());
    a.send(std::string_view(whole).substr(0, most));
    b.send(std::string_view(whole).substr(0, most));
    // It is random which of them was one too many.
    const auto end = std::chrono::steady_clock::now() + soon;
    while (!a.is_told_within(10ms) && !b.is_told_within(10ms) && std::chrono::steady_clock::now() < end) {
    }
    Client& refused = a.is_told_within(0ms) ? a : b;
    Client& other = &refused == &a ? b : a;
    EXPECT_EQ(refused.answer().status, 503);
    other.send(std::string_view(whole).substr(most));
    EXPECT_EQ(other.answer().status, 303);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(server.ask(whole).status, 303) << "what was held is held no more";
}

TEST(Connections, BodiesThatFallSilentCostNobodyElsesUpload) {
    RunningServer::Options options;
    options.limits.all_body_bytes = 1'000'000;
    const RunningServer server(options);
    const std::string large = upload(std::string(90'000, 'x'));
    std::list<Client> silent;
    for (int i = 0; i < 40; ++i) send_most_of(silent.emplace_back(server.port(), 9), large);
    std::this_thread::sleep_for(100ms);
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(server.ask(large, static_cast<std::uint8_t>(10 + i % 5)).status, 303) << "upload " << i;
}

TEST(Connections, OneAddressMayUseAllTheRoomWhileNobodyElseNeedsIt) {
    RunningServer::Options options;
    options.limits.all_body_bytes = 1'000'000;
    const RunningServer server(options);
    const std::string large = upload(std::string(90'000, 'x'));
    std::list<Client> lab;
    for (int i = 0; i < 10; ++i) send_most_of(lab.emplace_back(server.port(), 9), large);
    for (Client& each : lab) {
        each.send(std::string_view(large).substr(large.size() - 100));
        EXPECT_EQ(each.answer().status, 303);
    }
}

TEST(Connections, HalfSentBodiesMakeRoomForNewConnections) {
    RunningServer::Options options;
    options.limits.connections = 16;
    options.limits.connections_of_one_address = 4;
    const RunningServer server(options);
    const std::string whole = upload(std::string(1'000, 'x'));
    std::list<Client> halves;
    for (std::uint8_t address = 10; address < 14; ++address) {
        for (int i = 0; i < 4; ++i) send_most_of(halves.emplace_back(server.port(), address), whole);
    }
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(server.ask(get("/icon.svg"), static_cast<std::uint8_t>(20 + i % 6)).status, 200) << "page " << i;
}

TEST(Connections, AReaderThatStopsMakesRoomForNewConnections) {
    RunningServer::Options options;
    options.limits.connections = 8;
    const RunningServer server(options);
    std::list<Client> readers;
    for (int i = 0; i < 8; ++i) {
        Client& reader = readers.emplace_back(server.port(), 9);
        for (int k = 0; k < 90; ++k) reader.send(get("/"));
    }
    for (int i = 0; i < 10; ++i) EXPECT_EQ(server.ask(get("/icon.svg"), 20).status, 200) << "page " << i;
}

TEST(Connections, ServesOthersWhileManyAreSlow) {
    const RunningServer server;
    std::list<Client> slow;
    for (int i = 0; i < 50; ++i) {
        slow.emplace_back(server.port())
            .send(i % 2 == 0 ? "GET / HTTP/1.1\r\nX-" : head_of_upload("Content-Length: 9\r\n"));
    }
    EXPECT_EQ(server.ask(upload("int main() {}")).status, 303);
}

}  // namespace
}  // namespace harness::serve
