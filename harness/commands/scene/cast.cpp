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
    if (!std::cout) throw HarnessError("cannot write to stdout, so answers are missing. Is the disk full?");
    return malformed == 0 ? all_graded : some_not_graded;
}

void add_options(CLI::App& command, CastOptions& /*options*/) {
    command.footer(
        "A query is one "
        "line:\n{\"origin\":[0,0,0],\"direction\":[0,0,1],\"spheres\":[{\"center\":[1,1,5],\"radius\":2}]}"
        "\nA triangle, in \"triangles\", is an array of three vertices. A cylinder, in \"cylinders\", is "
        "{\"center\":[2,0,0],\"radius\":1,\"height\":4}; its axis is along y. Numbers are JSON numbers or hex floats "
        "in quotes. Hits have t >= 0; edges, vertices and tangents count as hits. The rims of a cylinder belong to its "
        "tube, not to its caps.\n\nExample: raygrade cast < queries.jsonl > answers.jsonl");
}

}  // namespace

Subcommand cast_command(CLI::App& app) {
    return subcommand(app, "cast", "Find exactly what rays hit: JSON lines on stdin, answers on stdout", add_options,
                      answer_rays);
}

}  // namespace harness
