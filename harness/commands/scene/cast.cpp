#include <CLI/CLI.hpp>
#include <iostream>

#include "harness/commands/options/shared_options.h"
#include "harness/commands/scene/scene_commands.h"
#include "harness/machine/errors.h"
#include "harness/machine/say.h"
#include "reference/cast/queries.h"
#include "reference/cast/scene_queries.h"

namespace harness {
namespace {

namespace cast = reference::cast;

struct CastOptions {
    std::string scene;
    bool binary = false;
    int jobs = 1;
};

/// Returns whether the input ended with a whole record.
bool answer_records(const reference::render::PreparedScene& scene, int jobs) {
    const cast::RecordsRead read = cast::answer_records(scene, std::cin, std::cout, jobs);
    if (read.left_over == 0) return true;
    say("raygrade: record {} is cut off after {} of its {} bytes, and the {} before it are answered\n", read.whole + 1,
        read.left_over, cast::ray_bytes, read.whole);
    return false;
}

/// Returns whether every query was one.
bool answer_to_scene(const CastOptions& options) {
    const reference::Assignment file = reference::load_scene(options.scene);
    const reference::render::PreparedScene scene = cast::objects_of(file);
    for (const std::string& note : file.notes) say("note: {}\n", note);
    for (const std::string& note : scene.notes) say("note: {}\n", note);
    if (options.binary) return answer_records(scene, options.jobs);
    return cast::answer_lines(scene, std::cin, std::cout, options.jobs) == 0;
}

int answer_rays(const CastOptions& options) {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    const bool all =
        options.scene.empty() ? cast::answer_queries(std::cin, std::cout, options.jobs) == 0 : answer_to_scene(options);
    if (!std::cout) throw HarnessError("stdout can't be written to, so answers are missing; is the disk full?");
    return all ? all_graded : some_not_graded;
}

void add_options(CLI::App& command, CastOptions& options) {
    CLI::Option* scene =
        command
            .add_option("--scene", options.scene,
                        "Rays at the objects and meshes of this scene file, see `raygrade help pictures`; a "
                        "query then is an origin and a direction")
            ->type_name("FILE");
    command
        .add_flag("--binary", options.binary,
                  "Rays and answers as records for programs, see `raygrade help formats`: 48 bytes in, 40 bytes out")
        ->needs(scene);
    add_jobs(command, options.jobs, "How many threads to use; changes nothing but the time");
    command.footer(
        "A query: "
        "{\"origin\":[0,0,2],\"direction\":[0,0,-1],\"spheres\":[{\"center\":[1,1,0],\"radius\":2}],\"triangles\":[]}\n"
        "A triangle is its three vertices, a cylinder {\"center\":[2,0,0],\"radius\":1,\"height\":4} in \"cylinders\", "
        "with its axis along y.\n"
        "Numbers are JSON numbers or hex floats in quotes. t >= 0, edges and vertices are hits, a tangent is one in "
        "the order. A cylinder's caps are without their rims, which are the tube's.\n"
        "With --scene an answer tells what is hit first: {\"first\":\"mesh 0\",\"face\":17,\"t\":1.5,\"u\":0.25,"
        "\"v\":0.5}, {\"first\":\"none\"}.\n"
        "--binary: a ray is 6 little-endian doubles, the origin and the direction; an answer three unsigned 32-bit "
        "numbers (0 none, 1 sphere, 2 triangle, 3 mesh, 4 cylinder, 5 invalid; its index; the face of a mesh), "
        "4 bytes (the part of a cylinder; 1 for a tie; two zeros) and the doubles t, u, v.\n"
        "Example: raygrade cast --scene reference/scenes/columns.toml < rays.jsonl > hits.jsonl");
}

}  // namespace

Subcommand cast_command(CLI::App& app) {
    return subcommand(app, "cast",
                      "Answer rays exactly: one JSON query a line on stdin, one JSON answer a line on stdout",
                      add_options, answer_rays);
}

}  // namespace harness
