#include "harness/report/picture/picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "harness/report/picture/image_plane.h"
#include "harness/report/picture/legend.h"
#include "harness/report/picture/printed_sketch.h"
#include "harness/text/markup.h"
#include "reference/stages/scene_numbers.h"

namespace harness::report {

using namespace picture;

namespace {

constexpr double page_width = 560;
constexpr double top_of_legend = 542;

std::string describe(const DoubleScene& scene, const std::vector<std::string>& notes) {
    const auto point = [](const Point& p) { return fmt::format("({} {} {})", figure(p.x), figure(p.y), figure(p.z)); };
    return fmt::format("The eye at {} looks at {} through an image plane at distance {}. {}", point(scene.camera.eye),
                       point(scene.camera.lookat), figure(scene.window.clip_near), fmt::join(notes, " "));
}

}  // namespace

std::string explaining_picture(const Marking& marking, const Graded* graded, bool with_answers,
                               const std::string& id_prefix) {
    const DoubleScene scene = reference::in_double(marking.assignment.scene);
    std::optional<RightValues> right;
    if (with_answers) right = right_values(marking.key, marking.assignment);
    std::vector<std::string> of_frame;
    const Frame frame = choose_frame(scene, right ? points_of(*right, marking.key, scene) : std::vector<Point>(),
                                     graded != nullptr, of_frame);
    Sketch sketch;
    draw_given(scene, right, sketch);
    if (right) draw_right(*right, marking.key, scene, frame, sketch);
    sketch.notes.insert(sketch.notes.end(), of_frame.begin(), of_frame.end());
    if (frame.arrow != 1) sketch.notes.push_back(fmt::format("Unit vectors are drawn {} long.", figure(frame.arrow)));
    const bool printed = graded != nullptr && draw_printed(graded->score, scene, right, frame, sketch);

    std::vector<Panel> panels;
    for (const View& view : views_of(scene, frame)) panels.push_back(draw_panel(view, frame, sketch));
    panels.push_back(draw_image_plane(scene, sketch, !with_answers));
    Legend legend;
    std::string body;
    for (const Panel& panel : panels) body += panel.svg + place_numbers(panel, legend);
    const NoteLines notes =
        draw_notes(sketch.notes, page_width - 8, top_of_legend + legend.height() + 1.5 * line_height);
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"{0}t {0}d\" width=\"{1}\" "
               "height=\"{2}\" viewBox=\"0 0 {1} {2}\" font-family=\"{3}\" font-size=\"{4}\" "
               "fill=\"currentColor\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
               "<title id=\"{0}t\">{5}</title>\n<desc id=\"{0}d\">{6}</desc>\n",
               escape_markup(id_prefix), page_width, coordinate(notes.bottom + 8), font_family, letter_size,
               graded != nullptr ? "The scene and the printed answers" : "The scene",
               escape_markup(describe(scene, sketch.notes))) +
           body + draw_key(scene, with_answers, printed) + legend.svg(top_of_legend) + notes.svg + "</svg>\n";
}

}  // namespace harness::report
