#include "tests/given/serve/attack.h"

namespace harness::serve {
namespace {

using namespace std::string_literals;

/// Never read as a request's head.
HostileRequest no_head(Random& random, const Target& target) {
    const std::string host = "\r\nHost: " + target.host + "\r\n\r\n";
    const std::vector<std::string> heads = {
        "GET /\r\n",
        "GET / HTTP/1.9" + host,
        "GET  / HTTP/1.1" + host,
        " GET / HTTP/1.1" + host,
        "GET /\0 HTTP/1.1"s + host,
        "GET /a b HTTP/1.1" + host,
        "GET / HTTP/1.1\nHost: " + target.host + "\n\n",
        "GET / HTTP/1.1\r\nX : a" + host,
        "GET / HTTP/1.1\r\nX: a\0b"s + host,
        "GET / HTTP/1.1\r\nX<script>: a" + host,
        "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
        "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03"s + std::string(300, '\x7f'),
    };
    return {"what is no head", one_of(random, heads), {400}};
}

HostileRequest random_bytes(Random& random, const Target&) {
    std::string bytes;
    for (std::size_t i = 0, count = number(random, 1, 5000); i < count; ++i) bytes += static_cast<char>(random());
    return {"random bytes", bytes, {0, 400, 431}};
}

HostileRequest half_head(Random& random, const Target& target) {
    const std::string whole = head("GET", "/", target, "X-Long: " + std::string(number(random, 0, 9000), 'x') + "\r\n");
    return {"half a head", whole.substr(0, number(random, 0, whole.size() - 1)), {0}};
}

/// Paths that lead to nothing of the site.
HostileRequest bad_path(Random& random, const Target& target) {
    const std::string out = one_of(random, std::vector<std::string>{"..", "%2e%2e", "%2E.", "..%2f", "..%5c", "..\\",
                                                                    "%252e%252e", "%c0%ae%c0%ae", "..;", "....//"});
    std::string up = "/";
    for (std::size_t i = 0, count = number(random, 1, 12); i < count; ++i) up += out + "/";
    const std::vector<std::string> paths = {
        up + "etc/passwd",
        up.substr(0, up.size() - 1) + target.planted,
        "/result" + up + "style.css",
        "/result/" + up + target.planted,
        "/style.css" + up + "style.css",
        "/style.css/",
        "/%73tyle.css",
        "//evil.example/style.css",
        target.planted,
        "/file://" + target.planted,
        "/spool.sqlite",
        "/result/",
        "/result//standing",
        "/check/",
        "/%0d%0aX-Injected:%20x7351",
        "/" + std::string(number(random, 1, 8000), '/'),
        "/%3Cscript%3Ex7351()%3C/script%3E",
        "/<script>x7351()</script><img/src=x7351>",
        "/\"'><script>x7351()</script>",
        "/\xff\xfe\xe2\x80\xae",
    };
    return {"a path that leads elsewhere", head("GET", one_of(random, paths), target), {400, 404}};
}

/// Near misses of a stranger's result, and addresses drawn by chance.
HostileRequest forged_address(Random& random, const Target& target) {
    const std::string address = target.result.substr(target.result.rfind('/') + 1);
    std::string flipped = address;
    char& digit = flipped[random() % flipped.size()];
    digit = digit == '0' ? '1' : '0';
    std::string drawn;
    for (std::size_t i = 0; i < address.size(); ++i) drawn += "0123456789abcdef"[random() % 16];
    std::string encoded = address;
    encoded.replace(random() % encoded.size(), 1, "%3" + std::to_string(random() % 10));
    const std::vector<std::string> forged = {
        flipped,
        drawn,
        encoded,
        address.substr(1),
        address.substr(0, address.size() - number(random, 1, 31)),
        address + "0",
        "*",
        "' OR '1'='1",
        std::string(address.size(), '0'),
        std::string(number(random, 33, 6000), 'a'),
        "../result/" + flipped,
        flipped + "/..",
    };
    const std::string path = "/result/" + one_of(random, forged) + (random() % 2 == 0 ? "/standing" : "");
    const std::string secret = "Cookie: session=" + drawn + "; admin=1\r\nAuthorization: Basic YWRtaW46YWRtaW4=\r\n" +
                               "X-Original-URL: " + target.result + "\r\nX-Rewrite-URL: /\r\nX-Token: " + drawn +
                               "\r\n";
    return {"a forged address", head("GET", path, target, random() % 2 == 0 ? secret : ""), {400, 404}};
}

/// A name that is not the server's, as with DNS rebinding.
HostileRequest foreign_host(Random& random, const Target& target) {
    const std::string own = target.host;
    const std::vector<std::string> hosts = {
        "evil.example",
        own + ".evil.example",
        own + "@evil.example",
        "evil.example#" + own,
        own + ":80:80",
        own + "/",
        "[::1",
        "127.0.0.1.evil",
        "2130706433",
        "169.254.169.254",
        "<script>x7351()</script>",
        "\xff\xfe",
        own + " evil.example",
    };
    const std::string host = one_of(random, hosts);
    if (random() % 2 == 0) return {"a foreign Host", "GET / HTTP/1.1\r\nHost: " + host + "\r\n\r\n", {400, 421}};
    Target foreign = target;
    foreign.host = host;
    return {"an upload to a foreign Host", upload_to(foreign, "Origin: http://" + host + "\r\n"), {400, 403, 421}};
}

/// A form of another site.
HostileRequest foreign_origin(Random& random, const Target& target) {
    const std::string own = "Origin: http://" + target.host + "\r\n";
    const std::vector<std::string> fields = {
        "Origin: http://evil.example\r\n",
        "Origin: null\r\n",
        "Origin: http://" + target.host + ".evil.example\r\n",
        "Origin: http://evil.example/" + target.host + "\r\n",
        "Origin: http://" + target.host + "@evil.example\r\n",
        own + "Origin: http://evil.example\r\n",
        "Origin: http://evil.example\r\n" + own,
        "Sec-Fetch-Site: cross-site\r\n",
        "Sec-Fetch-Site: same-site\r\n" + own,
        "Sec-Fetch-Site: same-origin\r\nSec-Fetch-Site: cross-site\r\n",
        "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Site: same-origin\r\n",
    };
    return {"a form of another site", upload_to(target, one_of(random, fields)), {403}};
}

/// Fields that change nothing for a server like this one.
HostileRequest odd_fields(Random& random, const Target& target) {
    const std::vector<std::string> fields = {
        "Range: bytes=0-18446744073709551615\r\n",
        "Upgrade: h2c\r\nConnection: Upgrade, HTTP2-Settings\r\nHTTP2-Settings: AAMAAABkAAQAAP__\r\n",
        "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n",
        "Accept-Encoding: gzip;q=1e999, *;q=-1\r\nAccept: " + hostile_markup + "\r\n",
        "User-Agent: " + hostile_markup + "\r\nReferer: " + hostile_markup + "\r\n",
        "X-Forwarded-For: " + hostile_markup + "\r\nX-Forwarded-Host: evil.example\r\nForwarded: for=_x\r\n",
        "Connection: close, keep-alive, Host, Content-Length\r\n",
        "Accept-Language: () { :; }; /bin/cat " + target.planted + "\r\n",
        "X: a\xff\xfe\r\n",
    };
    HostileRequest made{"odd fields", head("GET", "/", target, one_of(random, fields)), {200}};
    if (random() % 4 == 0) {
        made.is_to_head = true;
        made.bytes.replace(0, 3, "HEAD");
    }
    return made;
}

HostileRequest pipelined(Random& random, const Target& target) {
    HostileRequest made{"pipelined requests", "", {200, 404}};
    const std::size_t count = number(random, 2, 200);
    const std::vector<std::string> paths = {"/",         "/style.css", "/script.js",
                                            "/icon.svg", "/nothing",   "/?x=" + hostile_markup.substr(0, 1)};
    for (std::size_t i = 0; i < count; ++i) made.bytes += head("GET", one_of(random, paths), target);
    made.most_answers = count;
    return made;
}

HostileRequest reset(Random& random, const Target& target) {
    HostileRequest made{
        "a reset", random() % 2 == 0 ? head("GET", "/", target) : upload_to(target).substr(0, 200), {0}};
    made.resets = true;
    return made;
}

}  // namespace

std::vector<Attack> attacks_on_heads() {
    return {no_head,      random_bytes,   half_head,  bad_path,  bad_path, forged_address,
            foreign_host, foreign_origin, odd_fields, pipelined, reset};
}

}  // namespace harness::serve
