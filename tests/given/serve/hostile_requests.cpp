#include "tests/given/serve/hostile_requests.h"

#include "tests/given/serve/attack.h"

namespace harness::serve {
namespace {

const std::vector<Attack>& attacks() {
    static const std::vector<Attack> all = [] {
        std::vector<Attack> both = attacks_on_heads();
        const std::vector<Attack> bodies = attacks_on_bodies();
        both.insert(both.end(), bodies.begin(), bodies.end());
        return both;
    }();
    return all;
}

void damage(std::string& bytes, Random& random) {
    if (bytes.empty()) return;
    const std::size_t at = random() % bytes.size();
    switch (random() % 4) {
        case 0:
            for (std::size_t i = 0, count = number(random, 1, 10); i < count; ++i)
                bytes[random() % bytes.size()] ^= static_cast<char>(1U << random() % 8);
            return;
        case 1: bytes.resize(at); return;
        case 2: bytes += bytes.substr(at); return;
        default: bytes.erase(at, number(random, 1, 60)); return;
    }
}

}  // namespace

std::string head(const std::string& method, const std::string& path, const Target& target, const std::string& more) {
    return method + " " + path + " HTTP/1.1\r\nHost: " + target.host + "\r\n" + more + "\r\n";
}

std::string post(const std::string& type, const std::string& body, const Target& target, const std::string& more) {
    return head("POST", "/check", target,
                "Content-Type: " + type + "\r\n" + more + "Content-Length: " + std::to_string(body.size()) + "\r\n") +
           body;
}

std::string part(const std::string& program, const std::string& file) {
    return "\r\nContent-Disposition: form-data; name=\"source\"; filename=\"" + file + "\"\r\n\r\n" + program + "\r\n";
}

std::string upload_to(const Target& target, const std::string& more, const std::string& file) {
    return post(form_type, "--cut" + part(target.program, file) + "--cut--\r\n", target, more);
}

std::uint32_t hostile_request_kinds() {
    return static_cast<std::uint32_t>(attacks().size());
}

HostileRequest hostile_request(std::uint32_t seed, const Target& target) {
    Random random(seed);
    HostileRequest made = attacks()[seed % attacks().size()](random, target);
    if (seed / hostile_request_kinds() % 3 == 2) {
        damage(made.bytes, random);
        made.is_damaged = true;
        made.what += ", damaged";
    }
    return made;
}

}  // namespace harness::serve
