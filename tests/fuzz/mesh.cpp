#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "reference/render/scene/mesh_reader.h"
#include "reference/toml/assignment_error.h"
#include "tests/fuzz/properties.h"

namespace {

using Triangles = std::vector<reference::Triangle<double>>;

Triangles read(const std::string& obj) {
    std::istringstream in(obj);
    return reference::render::read_mesh(in, "ball.obj");
}

std::string written(const Triangles& triangles) {
    std::string obj;
    for (const auto& [A, B, C] : triangles) {
        for (const auto& p : {A, B, C}) obj += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
        obj += "f -3 -2 -1\n";
    }
    return obj;
}

}  // namespace

std::string check_mesh(std::string_view obj) {
    try {
        const Triangles triangles = read(std::string(obj));
        if (triangles.empty()) return "a mesh without triangles";
        for (const auto& [A, B, C] : triangles) {
            for (const auto& p : {A, B, C}) {
                for (const double x : {p.x, p.y, p.z}) {
                    if (!(std::abs(x) <= 1e30)) return "a coordinate beyond 1e30";
                }
            }
        }
        if (written(read(written(triangles))) != written(triangles))
            return "a mesh is read otherwise than it was written";
    } catch (const reference::AssignmentError& error) {
        const std::string_view message = error.what();
        if (!message.starts_with("ball.obj: ") || message.size() > 200)
            return "a message without the file's name, or a long one";
    }
    return "";
}
