// The answers of the self-check page, over real sockets.
#include "harness/serve/site/site.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/given/serve/running_server.h"

namespace harness::serve {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* as_script = "Accept: application/json\r\n";

/// Hands in a program. Returns the path of its result, with the leading slash.
std::string result_of(const RunningServer& server, const std::string& source) {
    const HttpAnswer answer = server.ask(upload(source, as_script));
    EXPECT_EQ(answer.status, 201) << answer.body;
    return "/" + json::parse(answer.body).at("result").get<std::string>();
}

json standing(const RunningServer& server, const std::string& result) {
    return json::parse(server.ask(get(result + "/standing")).body);
}

void expect_guarded(const HttpAnswer& answer, const std::string& of) {
    const auto field = [&](const char* name) {
        const auto found = answer.fields.find(name);
        return found == answer.fields.end() ? "" : found->second;
    };
    EXPECT_EQ(field("cache-control"), "no-store") << of;
    EXPECT_EQ(field("x-content-type-options"), "nosniff") << of;
    EXPECT_EQ(field("referrer-policy"), "same-origin") << of;
    EXPECT_EQ(field("cross-origin-opener-policy"), "same-origin") << of;
    EXPECT_EQ(field("cross-origin-resource-policy"), "same-origin") << of;
    EXPECT_THAT(field("content-security-policy"),
                AllOf(HasSubstr("default-src 'none'"), HasSubstr("frame-ancestors 'none'"), Not(HasSubstr("unsafe")),
                      Not(HasSubstr("http")), Not(HasSubstr("*"))))
        << of;
}

TEST(Site, ShowsTheFormWithSecurityHeaders) {
    const RunningServer server;
    const HttpAnswer answer = server.ask(get("/"));
    EXPECT_EQ(answer.status, 200);
    expect_guarded(answer, "/");
    EXPECT_THAT(answer.body,
                AllOf(HasSubstr("multipart/form-data"), HasSubstr("An &lt;assignment&gt;"),
                      Not(HasSubstr("<assignment>")), Not(HasSubstr("<style")), Not(HasSubstr("onclick"))));
    EXPECT_THAT(server.ask(get("/?query#part")).status, 200);
    for (const auto& [path, type] : {std::pair("/style.css", "text/css; charset=utf-8"),
                                     {"/script.js", "text/javascript; charset=utf-8"},
                                     {"/icon.svg", "image/svg+xml"}}) {
        const HttpAnswer asset = server.ask(get(path));
        EXPECT_EQ(asset.status, 200);
        EXPECT_EQ(asset.fields.at("content-type"), type);
        EXPECT_FALSE(asset.body.empty());
        expect_guarded(asset, path);
    }
}

TEST(Site, TakesAProgramThroughTheQueueToItsPage) {
    RunningServer server;
    const std::string first = result_of(server, "first");
    const std::string second = result_of(server, "second");
    EXPECT_NE(first, second);
    EXPECT_EQ(standing(server, second).at("standing"), "waiting");
    EXPECT_EQ(standing(server, second).at("position"), 2);
    EXPECT_EQ(standing(server, second).at("length"), 2);
    EXPECT_THAT(server.ask(get(second)).body, HasSubstr("number 2 of 2 in the queue"));
    const Task task = server.queue().next().value();
    EXPECT_EQ(task.source, "first");
    EXPECT_EQ(standing(server, first).at("standing"), "grading");
    EXPECT_EQ(standing(server, second).at("position"), 1);
    server.queue().finish(task,
                          {"<html><head><style>p{}</style></head><body><p>Well done</p></body></html>", 70.5, 100});
    const json done = standing(server, first);
    EXPECT_EQ(done.at("standing"), "done");
    EXPECT_EQ(done.at("points"), 70.5);
    EXPECT_EQ(done.at("max_points"), 100);
    const HttpAnswer page = server.ask(get(first));
    expect_guarded(page, "result");
    EXPECT_THAT(page.body, HasSubstr("Well done"));
    // printf 'p{}' | openssl dgst -sha256 -binary | base64
    EXPECT_THAT(page.fields.at("content-security-policy"),
                AllOf(HasSubstr("style-src 'sha256-gG2yISYereRMiG2lMXrbiUgi0Ubw9p7QCeWcroOvy9Y='"),
                      Not(HasSubstr("script-src"))));
    EXPECT_EQ(standing(server, second).at("standing"), "waiting");
}

/// Links also work from a path of several folders, and below any path at which a proxy publishes the page.
TEST(Site, LinksBackToTheFormFromEveryPage) {
    const RunningServer server;
    for (const auto& [path, top] : {std::pair("/a", "."), {"/a/", ".."}, {"/a/b", ".."}, {"/a/b/c", "../.."}}) {
        const std::string page = server.ask(get(path)).body;
        EXPECT_THAT(page, HasSubstr("href=\"" + std::string(top) + "/\"")) << path;
        EXPECT_THAT(page, HasSubstr("href=\"" + std::string(top) + "/style.css\"")) << path;
    }
}

TEST(Site, RefusesOtherMethods) {
    const RunningServer server;
    for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", "PATCH", "BREW"}) {
        const HttpAnswer answer = server.ask(std::string(method) + " / HTTP/1.1\r\nHost: localhost\r\n\r\n");
        EXPECT_EQ(answer.status, 405) << method;
        EXPECT_EQ(answer.fields.at("allow"), "GET, HEAD") << method;
    }
    const HttpAnswer answer = server.ask(get("/check"));
    EXPECT_EQ(answer.status, 405);
    EXPECT_EQ(answer.fields.at("allow"), "POST");
}

TEST(Site, AnswersHeadWithoutABody) {
    const RunningServer server;
    Client client(server.port());
    client.send("HEAD / HTTP/1.1\r\nHost: localhost\r\n\r\n");
    const HttpAnswer head = client.answer(true);
    EXPECT_EQ(head.status, 200);
    EXPECT_EQ(head.fields.at("content-length"), server.ask(get("/")).fields.at("content-length"));
    EXPECT_EQ(client.rest(), "");
}

TEST(Site, SaysWhatIsWrongWithAForm) {
    const RunningServer server;
    const HttpAnswer empty = server.ask(upload(" \n"));
    EXPECT_EQ(empty.status, 400);
    expect_guarded(empty, "empty");
    EXPECT_THAT(empty.body, AllOf(HasSubstr("<main>"), HasSubstr("empty")));
    EXPECT_THAT(json::parse(server.ask(upload(" \n", as_script)).body).at("error").get<std::string>(),
                HasSubstr("empty"));
    EXPECT_EQ(server
                  .ask("POST /check HTTP/1.1\r\nHost: localhost\r\nContent-Type: text/plain\r\nContent-Length: 1"
                       "\r\n\r\nx")
                  .status,
              400);
    EXPECT_EQ(server.ask("POST /check HTTP/1.1\r\nHost: localhost\r\n\r\n").status, 400);
}

TEST(Site, AnswersOnlyToItsOwnNames) {
    const RunningServer server;
    EXPECT_EQ(server.ask("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n").status, 421);
    EXPECT_EQ(server.ask("GET / HTTP/1.1\r\n\r\n").status, 400);
    EXPECT_EQ(server.ask("GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n").status, 400);
    EXPECT_EQ(server.ask("GET / HTTP/1.1\r\nHost: 127.0.0.1:1\r\n\r\n").status, 200);
}

TEST(Site, RefusesProgramsFromOtherSites) {
    RunningServer server;
    for (const char* from : {"Origin: http://evil.example\r\n", "Origin: null\r\n", "Sec-Fetch-Site: cross-site\r\n",
                             "Sec-Fetch-Site: same-site\r\nOrigin: http://localhost\r\n",
                             "Origin: http://localhost\r\nOrigin: http://evil.example\r\n",
                             "Origin: http://evil.example\r\nOrigin: http://localhost\r\n",
                             "Sec-Fetch-Site: same-origin\r\nSec-Fetch-Site: cross-site\r\n"}) {
        EXPECT_EQ(server.ask(upload("x", from)).status, 403) << from;
    }
    EXPECT_TRUE(server.queue().is_idle());
    EXPECT_EQ(server.ask(upload("x", "Origin: http://localhost\r\nSec-Fetch-Site: same-origin\r\n")).status, 303);
}

TEST(Site, AsksToRetryWhenTheQueueIsFull) {
    RunningServer::Options options;
    options.queue = 1;
    RunningServer server(options);
    const std::string waiting = result_of(server, "x");
    const HttpAnswer full = server.ask(upload("y"));
    EXPECT_EQ(full.status, 503);
    EXPECT_EQ(full.fields.at("retry-after"), "30");
    EXPECT_THAT(full.body, HasSubstr("waiting"));
    EXPECT_EQ(standing(server, waiting).at("position"), 1);
    server.queue().next();
    EXPECT_EQ(server.ask(upload("y")).status, 303);
}

TEST(Site, SaysThatADiskLostAResult) {
    RunningServer server;
    const std::string result = result_of(server, "x");
    const Task task = server.queue().next().value();
    {
        SQLite::Database other((server.folder() / "spool.sqlite").string(), SQLite::OPEN_READWRITE);
        other.exec("BEGIN EXCLUSIVE");
        server.queue().finish(task, {"page", 1, 1});
    }
    const HttpAnswer page = server.ask(get(result));
    EXPECT_EQ(page.status, 500);
    EXPECT_THAT(page.body, HasSubstr("disk"));
    EXPECT_EQ(standing(server, result).at("standing"), "lost");
}

}  // namespace
}  // namespace harness::serve
