#include "harness/report/picture/picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "harness/report/picture/image_plane.h"
#include "harness/report/picture/key.h"
#include "harness/report/picture/layout.h"
#include "harness/report/picture/loop.h"
#include "harness/report/picture/numbers.h"
#include "harness/report/picture/printed_sketch.h"
#include "harness/report/picture/scene_sketch.h"
#include "harness/text/markup.h"

namespace harness::report {

using namespace picture;

namespace {

/// The points that the perspective view must show, and with which it fills its box.
std::vector<Point> content_of(const Sketch& sketch, const Frame& frame) {
    std::vector<Point> content;
    const auto add = [&](const Point& world) {
        if (frame.holds(world)) content.push_back(frame.inside(world));
    };
    for (const Dot& dot : sketch.dots) add(dot.at);
    for (const Polygon& polygon : sketch.polygons) {
        for (const Point& corner : polygon.corners) add(corner);
    }
    for (const Arrow& arrow : sketch.arrows) add(arrow.at + arrow.vector * frame.arrow);
    for (const Ball& ball : sketch.balls) {
        const Point around(ball.radius, ball.radius, ball.radius);
        if (!frame.holds(ball.center - around) || !frame.holds(ball.center + around)) continue;
        // A near ball looks larger than its radius.
        for (int i = 0; i < 27; ++i) {
            const Point direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            constexpr double nearer = 1.12;
            if (i != 13)
                content.push_back(
                    frame.inside(ball.center + reference::normalized(direction) * (nearer * ball.radius)));
        }
    }
    for (const Tube& tube : sketch.tubes) {
        constexpr int around = 16;
        for (int i = 0; i < 2 * around; ++i) add(on_rim(tube, i / 2 / double{around}, i % 2 == 0 ? 1 : -1));
    }
    if (content.size() < 3) {  // only a camera far from everything: show the whole frame
        for (int i = 0; i < 8; ++i)
            content.push_back({(i & 1) == 0 ? frame.half.x : -frame.half.x, (i & 2) == 0 ? frame.half.y : -frame.half.y,
                               (i & 4) == 0 ? frame.half.z : -frame.half.z});
    }
    return content;
}

void append(Sketch& sketch, const Sketch& more) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(sketch.lines, more.lines);
    add(sketch.polygons, more.polygons);
    add(sketch.arrows, more.arrows);
    add(sketch.dots, more.dots);
    add(sketch.notes, more.notes);
}

std::string describe(const DoubleScene& scene, const std::vector<std::string>& notes) {
    const auto point = [](const Point& p) { return fmt::format("({} {} {})", figure(p.x), figure(p.y), figure(p.z)); };
    return fmt::format("The eye at {} looks at {} through an image plane at distance {}. {}", point(scene.camera.eye),
                       point(scene.camera.lookat), figure(scene.window.clip_near), fmt::join(notes, " "));
}

/// One view of what all pictures share.
struct BaseView {
    View view;
    std::vector<Segment> drawn;
    std::vector<Box> taken;
};

}  // namespace

/// What all pictures share. Depends only on the assignment and, only if `with_answers`, on the key.
struct ExplainingPictures::Base {
    Base(const Marking& marking, bool answers, Room room);

    bool with_answers;
    DoubleScene scene;
    RightValues right;
    Frame frame;
    ImagePlane image_plane;
    std::vector<Box> taken_in_plane;
    std::vector<BaseView> views;
    std::vector<std::string> notes;
    Legend legend;
    Spot end_of_key;
    std::string svg;  ///< all of it

    /// A whole <svg> element with the `shared` drawing and what that student printed, if any.
    std::string page(const std::string& id_prefix, const std::string& shared, const Graded* graded) const;
    /// What can be drawn of one student's answers; `notes` gets a sentence on each that can't.
    std::string draw_printed(const Graded& graded, Legend& with_printed, std::vector<std::string>& notes) const;
};

ExplainingPictures::Base::Base(const Marking& marking, bool answers, Room room)
    : with_answers(answers), scene(double_scene(marking.assignment)) {
    std::vector<Point> more;
    if (with_answers) {
        right = right_values(marking.key, marking.assignment);
        if (right.P_WCS) more.push_back(*right.P_WCS);
        for (const auto& [kind, met] : right.objects) {
            if (met.hit && marking.key.decisions.of(kind) != "miss") more.push_back(*met.hit);
        }
        if (right.X_vcs && right.Y_vcs && right.Z_vcs) {
            for (const Point& corner : window_corners(scene, *right.X_vcs, *right.Y_vcs, *right.Z_vcs))
                more.push_back(corner);
        }
    }
    std::vector<std::string> of_frame;
    frame = choose_frame(scene, more, room, of_frame);
    Sketch sketch = given_sketch(scene, right);
    if (with_answers) append(sketch, right_sketch(right, marking.key, scene, frame));
    notes = sketch.notes;
    notes.insert(notes.end(), of_frame.begin(), of_frame.end());
    if (frame.arrow != 1) notes.push_back(fmt::format("Unit vectors are drawn {} long.", figure(frame.arrow)));

    std::vector<View> looks{perspective_view(scene, perspective_box, content_of(sketch, frame))};
    for (View& view : parallel_views(scene, frame, {side_box, other_box})) looks.push_back(std::move(view));
    for (View& view : looks) {
        Panel panel = draw_panel(view, frame, sketch);
        NumberLabels numbers = place_numbers(panel.names, legend, view.box, panel.drawn, taken_by_box(view));
        svg += draw_box(view, frame) + panel.shapes + numbers.svg;
        views.push_back({std::move(view), std::move(panel.drawn), std::move(numbers.taken)});
    }
    image_plane = draw_image_plane(scene, right.P_VCS, image_plane_box);
    const Panel& plane = image_plane.panel;
    NumberLabels numbers = place_numbers(plane.names, legend, image_plane.room, plane.drawn, {});
    taken_in_plane = std::move(numbers.taken);
    const KeyLines key = draw_key(scene, with_answers, first_of_key);
    end_of_key = key.next;
    svg += plane.shapes + numbers.svg + key.svg + legend.svg(top_of_legend);
}

std::string ExplainingPictures::Base::draw_printed(const Graded& graded, Legend& with_printed,
                                                   std::vector<std::string>& notes) const {
    const PrintedSketch printed = printed_sketch(graded.score, scene, with_answers ? &right : nullptr, frame);
    const Sketch& sketch = printed.sketch;
    notes.insert(notes.end(), sketch.notes.begin(), sketch.notes.end());
    std::string body;
    for (const BaseView& base : views) {
        Panel panel = draw_panel(base.view, frame, sketch);
        panel.drawn.insert(panel.drawn.end(), base.drawn.begin(), base.drawn.end());
        body += panel.shapes + place_numbers(panel.names, with_printed, base.view.box, panel.drawn, base.taken).svg;
    }
    Panel pixel;
    if (printed.P_VCS)
        pixel = draw_printed_pixel(scene, *printed.P_VCS, printed.P_VCS_name, printed.is_P_VCS_right,
                                   image_plane.window, notes);
    body += pixel.shapes +
            place_numbers(pixel.names, with_printed, image_plane.room, image_plane.panel.drawn, taken_in_plane).svg;
    const bool any = !pixel.names.empty() || !sketch.dots.empty() || !sketch.arrows.empty();
    if (any) body += draw_printed_key(with_answers, end_of_key);
    return body + with_printed.svg(top_of_legend, legend.size());
}

std::string ExplainingPictures::Base::page(const std::string& id_prefix, const std::string& shared,
                                           const Graded* graded) const {
    std::vector<std::string> told = notes;
    Legend names = legend;
    std::string body = shared;
    if (graded != nullptr) body += draw_printed(*graded, names, told);
    const NoteLines lines = draw_notes(told, page_width - 8, top_of_legend + names.height() + 1.5 * line_height);
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"{0}t {0}d\" width=\"{1}\" "
               "height=\"{2}\" viewBox=\"0 0 {1} {2}\" font-family=\"{3}\" font-size=\"{4}\" "
               "fill=\"currentColor\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
               "<title id=\"{0}t\">{5}</title>\n<desc id=\"{0}d\">{6}</desc>\n",
               escape_markup(id_prefix), page_width, coordinate(lines.bottom + 8), font_family, letter_size,
               graded != nullptr ? "The scene, and what was printed" : "The scene",
               escape_markup(describe(scene, told))) +
           body + lines.svg + "</svg>\n";
}

ExplainingPictures::ExplainingPictures(const Marking& marking, bool with_answers, const std::string& id_prefix)
    : base_(std::make_shared<const Base>(marking, with_answers, Room::for_mistakes)),
      id_(escape_markup(id_prefix + "scene")) {}

std::string ExplainingPictures::shared_part() const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"0\" height=\"0\" aria-hidden=\"true\"><defs><g id=\"{}\">\n"
        "{}</g></defs></svg>\n",
        id_, base_->svg);
}

std::string ExplainingPictures::picture(const Graded* graded, const std::string& id_prefix) const {
    return base_->page(id_prefix, fmt::format("<use href=\"#{}\"/>\n", id_), graded);
}

std::string ExplainingPictures::whole_picture(const Graded* graded, const std::string& id_prefix) const {
    return base_->page(id_prefix, base_->svg, graded);
}

std::string explaining_picture(const Marking& marking, const Graded* graded, bool with_answers,
                               const std::string& id_prefix) {
    if (graded != nullptr) return ExplainingPictures(marking, with_answers, id_prefix).whole_picture(graded, id_prefix);
    const ExplainingPictures::Base base(marking, with_answers, Room::for_scene);
    return base.page(id_prefix, base.svg, nullptr);
}

}  // namespace harness::report
