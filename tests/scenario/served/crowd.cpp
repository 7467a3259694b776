#include "tests/scenario/served/crowd.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <stdexcept>

#include "tests/given/serve/attack.h"

namespace scenario {
namespace {

using namespace std::chrono_literals;
using harness::serve::head;

/// The address of a student who shares it with a part of the crowd. This part stays below what one address may hold and
/// sends nothing: one that is at work would take its neighbours' share.
constexpr std::uint8_t shared_address = 1;
constexpr std::size_t from_shared_address = 40;
constexpr std::uint8_t first_address = 20;
constexpr std::uint8_t addresses = 4;
constexpr std::size_t from_each_address = 70;

}  // namespace

Crowd::Crowd(std::uint16_t port, unsigned seed, const harness::serve::Target& target)
    : port_(port), target_(target), random_(seed) {
    for (std::size_t i = 0; i < from_each_address; ++i) {
        if (i < from_shared_address) add(shared_address);
        for (std::uint8_t j = 0; j < addresses; ++j) add(first_address + j);
    }
    thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

Crowd::~Crowd() {
    end();
}

void Crowd::end() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
    for (auto& [from, member] : members_) member.socket.receive(received_);
    members_.clear();
}

void Crowd::add(std::uint8_t from) {
    constexpr int quiet_kinds = 2;
    constexpr int kinds = 6;
    const Kind kind = static_cast<Kind>(random_() % (from == shared_address ? quiet_kinds : kinds));
    constexpr int few_bytes = 2048;
    Member member{kind, Socket(port_, from, kind == Kind::does_not_read ? few_bytes : 0), {}, 0};
    switch (kind) {
        case Kind::silent: break;
        case Kind::asks_once: member.bytes = head("GET", "/icon.svg", target_); break;
        case Kind::slow_head: member.bytes = head("GET", "/", target_, "X: " + std::string(9000, 'x') + "\r\n"); break;
        case Kind::slow_body:
            member.bytes = harness::serve::post(harness::serve::form_type, std::string(100'000, 'x'), target_);
            break;
        case Kind::large_body:
            member.bytes = harness::serve::post(harness::serve::form_type, std::string(1 << 20, 'x'), target_);
            member.bytes.pop_back();
            break;
        case Kind::does_not_read:
            for (int i = 0; i < 100; ++i) member.bytes += head("GET", "/style.css", target_);
            break;
    }
    ++opened_;
    members_.emplace_back(from, std::move(member));
}

/// Sends some more. False if the server has ended the connection.
bool Crowd::goes_on(Member& member) {
    const bool is_slow = member.kind == Kind::slow_head || member.kind == Kind::slow_body;
    constexpr std::size_t piece = 1 << 16;
    const std::string_view now = std::string_view(member.bytes).substr(member.sent, is_slow ? 1 : piece);
    std::string_view left = now;
    const bool is_taken = member.socket.send(left);
    member.sent += now.size() - left.size();
    if (member.kind == Kind::does_not_read) return is_taken;
    return member.socket.receive(received_) && is_taken;
}

void Crowd::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::vector<std::uint8_t> gone;
        const auto leave = [&](auto member) {
            gone.push_back(member->first);
            return members_.erase(member);
        };
        for (auto each = members_.begin(); each != members_.end();)
            each = goes_on(each->second) ? std::next(each) : leave(each);
        constexpr int leave_at_a_time = 4;
        for (int i = 0; i < leave_at_a_time && !members_.empty(); ++i)
            leave(std::next(members_.begin(), static_cast<std::ptrdiff_t>(random_() % members_.size())));
        try {
            for (const std::uint8_t from : gone) add(from);
        } catch (const std::runtime_error&) {
            return;  // the server is gone, which the test sees by itself
        }
        std::this_thread::sleep_for(20ms);
    }
}

}  // namespace scenario
