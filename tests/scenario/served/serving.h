// The real `raygrade serve` in a test: started at a free port, asked and stopped.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/given/serve/client.h"
#include "tests/scenario/scenario.h"

namespace scenario {

/// Long enough to compile a few programs on a busy machine, with sanitizers.
constexpr auto patience = std::chrono::seconds(120);

class Serving : public testing::Test {
  protected:
    Serving();
    ~Serving() override;

    Preparation prepare() const;
    /// Starts raygrade serve at a free port, and waits until it prints the port.
    void start(std::vector<std::string> more = {}, const Preparation& more_preparation = {});
    /// Sends the signal. Returns the server's exit status, or 128 + the signal that killed it.
    int end(int signal);
    harness::serve::HttpAnswer ask(const std::string& request) const { return harness::serve::ask(port, request); }
    /// Hands in a program. Returns the path of its result.
    std::string hand_in(std::string_view source) const;
    nlohmann::json standing(const std::string& result) const;
    /// The state of a submission as soon as it is neither waiting nor being graded.
    nlohmann::json outcome(const std::string& result) const;
    std::filesystem::path output() const { return folder / "run/stdout"; }
    std::filesystem::path voice() const { return folder / "run/stderr"; }

    TemporaryFolder folder;
    std::string assignment = "a6-2021";
    pid_t server = 0;
    std::uint16_t port = 0;
};

}  // namespace scenario
