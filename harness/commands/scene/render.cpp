#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string_view>

#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/machine/say.h"
#include "reference/render/explanation.h"

namespace harness {
namespace {

struct RenderOptions {
    std::string assignment;
    std::filesystem::path scene;              ///< a scene file instead of the assignment; empty for none
    std::filesystem::path out = "image.png";  ///< the PNG file
    std::string size;                         ///< in pixels, "640x480"; empty for the window's size
    int jobs = 1;
    bool force = false;        ///< replace an earlier picture
    bool explain = false;      ///< also print effects, work and times
    bool all_effects = false;  ///< also simulate effects that the scene does not call for
};

namespace fs = std::filesystem;
namespace render = reference::render;

constexpr int most_pixels_per_side = 1 << 20;

/// Reads a size such as "640x480".
std::optional<render::PictureSize> size_of(const std::string& text) {
    if (text.empty()) return std::nullopt;
    render::PictureSize size{};
    const char* const end = text.data() + text.size();
    const auto [after_width, width_error] = std::from_chars(text.data(), end, size.width);
    const bool has_cross = width_error == std::errc() && after_width != end && *after_width == 'x';
    const auto [after_height, height_error] = std::from_chars(has_cross ? after_width + 1 : end, end, size.height);
    const auto in_range = [](int side) { return 1 <= side && side <= most_pixels_per_side; };
    if (has_cross && height_error == std::errc() && after_height == end && in_range(size.width) &&
        in_range(size.height)) {
        return size;
    }
    throw UsageError(fmt::format("--size {} is not a size; write e.g. 640x480, with at most {} pixels per side", text,
                                 most_pixels_per_side));
}

int render_scene(const RenderOptions& options) {
    const std::optional<render::PictureSize> size = size_of(options.size);
    require_can_write({options.out, "-o", "PNG picture", "\x89PNG\r\n\x1a\n"},
                      options.force ? Earlier::replaced : Earlier::kept);
    const reference::Assignment assignment = options.scene.empty()
                                                 ? reference::load_assignment(options.assignment, assignments_folder())
                                                 : reference::load_scene(options.scene);
    const render::PreparedScene scene = render::prepare_scene(assignment, size);
    const render::Effects effects =
        options.all_effects ? render::all_effects : render::effects_of(render::decide_effects(scene));
    const render::Rendering rendering = render::render(scene, effects, options.jobs);
    write_file(options.out, render::to_png(rendering.picture));
    for (const std::string& note : assignment.notes) say("note: {}\n", note);
    for (const std::string& note : scene.notes) say("note: {}\n", note);
    if (options.explain) fmt::print("{}", render::explanation(scene, options.jobs));
    say("picture: {}\n", options.out.string());
    return all_graded;
}

void add_options(CLI::App& command, RenderOptions& options) {
    add_scene(command, options.assignment);
    command.add_option("--scene", options.scene, "A scene file instead of an assignment; see `raygrade help pictures`")
        ->type_name("FILE")
        ->excludes("--assignment");
    command.add_option("-o,--out", options.out, "The PNG file")->type_name("FILE")->capture_default_str();
    command.add_flag("--force", options.force, "Replace an earlier picture");
    command.add_option("--size", options.size, "Width and height in pixels; by default the window's")->type_name("WxH");
    add_jobs(command, options.jobs, "How many threads to use");
    command.add_flag("--explain", options.explain,
                     "Say which effects the scene needs, why the others are off, and what each costs");
    command.add_flag("--all-effects", options.all_effects,
                     "Simulate all effects, needed or not: same picture, more time");
    command.footer(
        "Examples: raygrade render --assignment a6-2021 -o 2021.png --explain\n"
        "          raygrade render --scene reference/scenes/glass.toml --size 1280x720");
}

}  // namespace

Subcommand render_command(CLI::App& app) {
    return subcommand(app, "render", "Draw the scene as its camera sees it, as PNG", add_options, render_scene);
}

}  // namespace harness
