#include "harness/serve/http/connections.h"

#include <algorithm>
#include <utility>

namespace harness::serve {
namespace {

using namespace std::chrono_literals;

/// Whether a connection may be closed although its client holds no more than others: nothing is under way, or nothing
/// has moved for a moment.
bool is_waiting(const Connection& connection) {
    return connection.is_idle || Connection::Clock::now() - connection.silent_since >= 1s;
}

}  // namespace

std::size_t Connections::count_of(const std::string& client) const {
    const auto found = counts_.find(client);
    return found == counts_.end() ? 0 : found->second;
}

const std::string& Connections::largest_client() const {
    return std::max_element(counts_.begin(), counts_.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
}

/// Of this client's connections, or of all if it is null. Null if there is none.
Connection* Connections::longest_silent(const std::string* client) {
    Connection* longest = nullptr;
    for (Connection& each : all_) {
        if (each.is_displaced || (client != nullptr && each.client != *client)) continue;
        const auto order = [](const Connection& one) { return std::pair(!is_waiting(one), one.silent_since); };
        if (longest == nullptr || order(each) < order(*longest)) longest = &each;
    }
    return longest;
}

bool Connections::make_room_for(const std::string& client) {
    const std::size_t own = count_of(client);
    const bool has_its_share = !behind_proxy_ && own >= limits_.connections_of_one_address;
    std::size_t open = 0;
    for (const auto& [name, count] : counts_) open += count;
    if (!has_its_share && open < limits_.connections) return true;
    const std::string& largest = largest_client();
    const bool another_holds_more = !has_its_share && count_of(largest) > own + 1;
    Connection* const leaves = longest_silent(has_its_share ? &client : another_holds_more ? &largest : nullptr);
    // Who holds more gives up what is at work too; but the connections of a proxy are those of many clients.
    if (!is_waiting(*leaves) && (!another_holds_more || behind_proxy_)) return false;
    leaves->is_displaced = true;
    body_bytes_ -= std::exchange(leaves->body_bytes, 0);
    if (--counts_[leaves->client] == 0) counts_.erase(leaves->client);
    leaves->stream.close();
    return true;
}

Connections::Iterator Connections::add(boost::asio::ip::tcp::socket socket, const std::string& client) {
    ++counts_[client];
    // Room for a head and for what one read returns beyond it.
    const std::size_t most_bytes = 2 * limits_.head_bytes;
    return all_.insert(all_.end(), Connection{boost::beast::tcp_stream(std::move(socket)), client,
                                              boost::beast::flat_buffer(most_bytes)});
}

void Connections::remove(Iterator connection) {
    body_bytes_ -= connection->body_bytes;
    if (!connection->is_displaced && --counts_[connection->client] == 0) counts_.erase(connection->client);
    all_.erase(connection);
}

bool Connections::hold_body(Connection& connection, std::size_t bytes) {
    body_bytes_ = body_bytes_ - connection.body_bytes + bytes;
    connection.body_bytes = bytes;
    while (body_bytes_ > limits_.all_body_bytes) {
        std::map<std::string, std::size_t> held;
        for (const Connection& each : all_) held[each.client] += each.body_bytes;
        const auto most = std::max_element(held.begin(), held.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        Connection* leaves = nullptr;
        for (Connection& each : all_) {
            if (each.body_bytes == 0 || each.client != most->first) continue;
            if (leaves == nullptr || each.silent_since < leaves->silent_since) leaves = &each;
        }
        body_bytes_ -= std::exchange(leaves->body_bytes, 0);
        if (leaves == &connection) return false;
        leaves->is_refused_body = true;
        leaves->stream.cancel();
    }
    return true;
}

}  // namespace harness::serve
