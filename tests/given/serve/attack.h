// Shared by the attacks on heads and on bodies.
#pragma once

#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "tests/given/serve/hostile_requests.h"

namespace harness::serve {

using Random = std::mt19937;
using Attack = HostileRequest (*)(Random&, const Target&);

/// The attacks on a request's head, and on its body.
std::vector<Attack> attacks_on_heads();
std::vector<Attack> attacks_on_bodies();

inline std::size_t number(Random& random, std::size_t least, std::size_t most) {
    return least + random() % (most - least + 1);
}

template <class Value>
const Value& one_of(Random& random, const std::vector<Value>& values) {
    return values[random() % values.size()];
}

/// "METHOD path HTTP/1.1", the server's name, and further fields ("Name: value\r\n").
std::string head(const std::string& method, const std::string& path, const Target& target,
                 const std::string& more = "");
/// A request with this body and its length.
std::string post(const std::string& type, const std::string& body, const Target& target, const std::string& more = "");
/// The one part of the site's form, without the boundary before and after it.
std::string part(const std::string& program, const std::string& file = "ray_cast.cpp");
/// A whole and honest upload.
std::string upload_to(const Target& target, const std::string& more = "", const std::string& file = "ray_cast.cpp");

inline const std::string form_type = "multipart/form-data; boundary=cut";

}  // namespace harness::serve
