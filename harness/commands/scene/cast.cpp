#include <CLI/CLI.hpp>
#include <iostream>

#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "reference/cast/queries.h"

namespace harness {
namespace {

struct CastOptions {};

int answer_rays(const CastOptions& /*options*/) {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    const long malformed = reference::cast::answer_queries(std::cin, std::cout);
    if (!std::cout) throw HarnessError("stdout can't be written to, so answers are missing; is the disk full?");
    return malformed == 0 ? all_graded : some_not_graded;
}

void add_options(CLI::App& command, CastOptions& /*options*/) {
    command.footer(
        "A query: "
        "{\"origin\":[0,0,2],\"direction\":[0,0,-1],\"spheres\":[{\"center\":[1,1,0],\"radius\":2}],\"triangles\":[]}\n"
        "A triangle is its three vertices, a cylinder {\"center\":[2,0,0],\"radius\":1,\"height\":4} in \"cylinders\", "
        "with its axis along y.\n"
        "Numbers are JSON numbers or hex floats in quotes. t >= 0, edges and vertices are hits, a tangent is one in "
        "the order. A cylinder's caps are without their rims, which are the tube's.\n"
        "Example: raygrade cast < queries.jsonl > answers.jsonl");
}

}  // namespace

Subcommand cast_command(CLI::App& app) {
    return subcommand(app, "cast",
                      "Answer rays exactly: one JSON query a line on stdin, one JSON answer a line on stdout",
                      add_options, answer_rays);
}

}  // namespace harness
