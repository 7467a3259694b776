#include "harness/serve/request/rate_limit.h"

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <cmath>
#include <vector>

namespace harness::serve {

RateLimit::RateLimit(double turns_a_minute, int burst, std::size_t clients)
    : turns_a_second_(turns_a_minute / 60), burst_(burst), clients_(clients) {}

double RateLimit::turns_at(const Bucket& bucket, Clock::time_point now) const {
    const double seconds = std::chrono::duration<double>(now - bucket.at).count();
    return std::min(burst_, bucket.turns + std::max(0.0, seconds) * turns_a_second_);
}

std::chrono::seconds RateLimit::wait_of(const std::string& client, Clock::time_point now) const {
    const auto found = buckets_.find(client);
    if (found == buckets_.end()) return std::chrono::seconds(0);
    const double missing = 1 - turns_at(found->second, now);
    // Ignores rounding errors, which would cost a second.
    constexpr double nothing = 1e-6;
    if (missing <= nothing) return std::chrono::seconds(0);
    return std::chrono::seconds(static_cast<std::int64_t>(std::ceil(missing / turns_a_second_)));
}

void RateLimit::take(const std::string& client, Clock::time_point now) {
    if (buckets_.size() >= clients_ && !buckets_.contains(client)) forget_some(now);
    Bucket& bucket = buckets_.try_emplace(client, Bucket{burst_, now}).first->second;
    bucket = {turns_at(bucket, now) - 1, now};
}

/// Forgets the clients whose bucket is full again, which changes nothing. If those are too few, also forgets the least
/// recently used half of the others.
void RateLimit::forget_some(Clock::time_point now) {
    std::erase_if(buckets_, [&](const auto& one) { return turns_at(one.second, now) >= burst_; });
    if (buckets_.size() < clients_) return;
    std::vector<Clock::time_point> uses;
    uses.reserve(buckets_.size());
    for (const auto& [client, bucket] : buckets_) uses.push_back(bucket.at);
    const auto middle = uses.begin() + static_cast<std::ptrdiff_t>(uses.size() / 2);
    std::nth_element(uses.begin(), middle, uses.end());
    std::size_t surplus = uses.size() / 2 + 1;
    std::erase_if(buckets_, [&](const auto& one) { return one.second.at <= *middle && surplus > 0 && surplus-- > 0; });
}

std::string client_of(const std::string& address) {
    boost::system::error_code error;
    const auto parsed = boost::asio::ip::make_address(address, error);
    if (error || parsed.is_v4()) return address;
    const auto v6 = parsed.to_v6();
    if (v6.is_v4_mapped()) return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, v6).to_string();
    auto bytes = v6.to_bytes();
    constexpr std::size_t network = 8;
    std::fill(bytes.begin() + network, bytes.end(), static_cast<unsigned char>(0));
    return boost::asio::ip::address_v6(bytes).to_string() + "/64";
}

}  // namespace harness::serve
