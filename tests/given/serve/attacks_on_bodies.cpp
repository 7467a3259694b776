#include <algorithm>

#include "tests/given/serve/attack.h"

namespace harness::serve {
namespace {

using namespace std::string_literals;

std::string chunked(const std::string& body) {
    constexpr char digits[] = "0123456789abcdef";
    std::string size;
    for (std::size_t left = body.size(); left > 0; left /= 16) size.insert(size.begin(), digits[left % 16]);
    return (body.empty() ? "" : size + "\r\n" + body + "\r\n") + "0\r\n\r\n";
}

/// Lengths on which two readers may differ. What follows may be read as the body or as a request for a stranger's
/// result; there must be one answer.
HostileRequest smuggled(Random& random, const Target& target) {
    const std::vector<std::string> fields = {
        "Content-Length: 5\r\nTransfer-Encoding: chunked\r\n",
        "Content-Length: 5\r\nContent-Length: 6\r\n",
        "Content-Length: 5, 6\r\n",
        "Content-Length: -1\r\n",
        "Content-Length: +5\r\n",
        "Content-Length:\r\n",
        "Content-Length: 99999999999999999999999\r\n",
        "Content-Length: 0\r\nTransfer-Encoding: identity\r\n",
        "Transfer-Encoding: identity\r\n",
        "Transfer-Encoding: xchunked\r\n",
        "Transfer-Encoding: chunked, identity\r\n",
        "Transfer-Encoding: chunked;q=0\r\n",
        "Transfer-Encoding: identity\r\nTransfer-Encoding: chunked\r\n",
        "Transfer-Encoding: gzip\r\n",
        "Transfer-Encoding: \x0b"
        "chunked\r\n",
        "Transfer-Encoding:\r\n chunked, x\r\n",
        "Transfer-Encoding : chunked\r\n",
    };
    const std::string type = "Content-Type: " + form_type + "\r\n";
    const bool is_get = random() % 2 == 0;
    std::string request = is_get ? head("GET", "/", target, one_of(random, fields))
                                 : head("POST", "/check", target, type + one_of(random, fields));
    if (random() % 4 == 0) request.replace(request.find("HTTP/1.1"), 8, "HTTP/1.0");
    const std::string first = random() % 2 == 0 ? "0\r\n\r\n" : "5\r\nhello\r\n0\r\n\r\n";
    return {"a length that says two things", request + first + head("GET", "/icon.svg", target), {400, 413, 501}};
}

HostileRequest bad_chunks(Random& random, const Target& target) {
    const std::vector<std::string> bodies = {
        "-5\r\nhello\r\n0\r\n\r\n",
        " 5\r\nhello\r\n0\r\n\r\n",
        "5\nhello\n0\n\n",
        "5\r\nhelloXX0\r\n\r\n",
        "FFFFFFFFFFFFFFFF\r\nhello",
        "7FFFFFFFFFFFFFFF\r\nhello",
        "5;" + std::string(number(random, 20'000, 200'000), 'x') + "\r\nhello\r\n0\r\n\r\n",
        "0\r\n" + std::string(number(random, 20'000, 200'000), 'x'),
        "g\r\n\r\n",
        "5\r\nhello\r\n0\r\nHost: evil.example\r\nContent-Length: 7\r\n\r\n",
    };
    return {"bad chunks",
            head("POST", "/check", target, "Content-Type: " + form_type + "\r\nTransfer-Encoding: chunked\r\n") +
                one_of(random, bodies),
            {0, 400, 413}};
}

/// An upload that ends before its length says.
HostileRequest half_body(Random& random, const Target& target) {
    const std::string whole = upload_to(target);
    const std::size_t body = whole.find("\r\n\r\n") + 4;
    if (random() % 2 == 0) return {"half a body", whole.substr(0, number(random, body, whole.size() - 1)), {0}};
    const std::string chunks = chunked(whole.substr(body));
    return {"half a chunked body",
            head("POST", "/check", target, "Content-Type: " + form_type + "\r\nTransfer-Encoding: chunked\r\n") +
                chunks.substr(0, number(random, 0, chunks.size() - 1)),
            {0, 400}};
}

HostileRequest bad_form(Random& random, const Target& target) {
    const std::string good = part(target.program);
    const std::string named = "\r\nContent-Disposition: form-data; name=";
    std::string many;
    for (int i = 0; i < 9; ++i) many += "--cut" + named + "\"x" + std::to_string(i) + "\"\r\n\r\nx\r\n";
    const std::vector<std::string> bodies = {
        "",
        "--cut--\r\n",
        "--cut" + good + "--cut" + good + "--cut--\r\n",
        "cut" + good + "cut--",
        "\r\n--cut" + good + "--cut--",
        "--cut" + named + "\"source\"\r\n\r\n\r\n--cut--",
        "--cut" + named + "\"source\r\n\r\nint main() {}\r\n--cut--",
        "--cut" + named + "\"other\"\r\n\r\nint main() {}\r\n--cut--",
        "--cut\r\nContent-Disposition: attachment; name=\"source\"\r\n\r\nint main() {}\r\n--cut--",
        "--cut\r\n\r\nint main() {}\r\n--cut--",
        "--cut\r\nContent-Disposition: form-data\r\n\r\nint main() {}\r\n--cut--",
        "--cut\r\nX: " + std::string(5000, 'x') + good + "--cut--",
        "--cut" + named + "\"source\"" + std::string(900, ';') + "\r\n\r\nint main() {}\r\n--cut--",
        many + "--cut" + good + "--cut--",
        "--cut" + part(std::string("int main() {\0}", 14)) + "--cut--",
        "--cut" + part("") + "--cut--",
        "--cut" + part("%PDF-1.4 " + hostile_markup) + "--cut--",
        "--cut" + part("PK\x03\x04 " + hostile_markup) + "--cut--",
        "--cut" +
            part("\x7f"
                 "ELF\x02" +
                 hostile_markup) +
            "--cut--",
        "<?xml version=\"1.0\"?><!DOCTYPE x [<!ENTITY y SYSTEM \"file://" + target.planted +
            "\">]><source>&y;</source>",
    };
    const std::string accept = random() % 2 == 0 ? "" : "Accept: application/json\r\n";
    return {"a form that is none", post(form_type, one_of(random, bodies), target, accept), {400}};
}

/// A program whose file is called so that its page might show markup.
HostileRequest hostile_name(Random& random, const Target& target) {
    const std::vector<std::string> names = {
        "<script>x7351()<\\/script>.cpp",
        "\\\"'><script>x7351()<img src=x7351>.cpp",
        "../../../../" + target.planted.substr(1),
        "..\\\\..\\\\x.cpp",
        "a\x1b[2J\x07\x7f\x01.cpp",
        "a\0b.cpp"s,
        "\xff\xfe\xc3.cpp",
        "\xe2\x80\xae"
        "ppc.tsac_yar",
        "%3Cscript%3Ex7351()%3C/script%3E.cpp",
        "&lt;script&gt;x7351()&#60;.cpp",
        std::string(number(random, 100, 3000), '<'),
        "",
    };
    HostileRequest made{
        "a file's name",
        upload_to(target, random() % 2 == 0 ? "Accept: application/json\r\n" : "", one_of(random, names)),
        {201, 303}};
    made.is_upload = true;
    return made;
}

}  // namespace

std::vector<Attack> attacks_on_bodies() {
    return {smuggled, smuggled, bad_chunks, half_body, bad_form, hostile_name};
}

}  // namespace harness::serve
