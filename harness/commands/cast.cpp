#include <CLI/CLI.hpp>
#include <iostream>

#include "harness/commands/subcommand.h"
#include "reference/kernel/queries.h"

namespace harness {
namespace {

/// Returns some_not_graded if a line was no query.
int answer_queries() {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    return reference::cast(std::cin, std::cout) == 0 ? all_graded : some_not_graded;
}

}  // namespace

Subcommand cast_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "cast", "Answer rays exactly: one JSON query a line on stdin, one JSON answer a line on stdout");
    command.footer(
        "A query: "
        "{\"origin\":[0,0,2],\"direction\":[0,0,-1],\"spheres\":[{\"center\":[1,1,0],\"radius\":2}],\"triangles\":[]}\n"
        "A triangle is its three vertices, a cylinder {\"center\":[2,0,0],\"radius\":1,\"height\":4} in \"cylinders\", "
        "with "
        "its axis along y.\n"
        "Numbers are JSON numbers or hex floats in quotes. t >= 0, edges and vertices are hits, a tangent is one in "
        "the order. A cylinder's caps are without their rims, which are the tube's.");
    return {&command, answer_queries};
}

}  // namespace harness
