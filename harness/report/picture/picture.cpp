#include "harness/report/picture/picture.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <mutex>
#include <optional>

#include "harness/report/picture/image_plane.h"
#include "harness/report/picture/layout.h"
#include "harness/report/picture/legend.h"
#include "harness/report/picture/panel.h"
#include "harness/report/picture/tube.h"
#include "harness/report/plot/scatter_drawing.h"
#include "harness/report/sketch/assignment_sketch.h"
#include "harness/report/sketch/printed_sketch.h"
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

void append(Sketch& sketch, Sketch&& more) {
    const auto move = [](auto& to, auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    move(sketch.balls, more.balls);
    move(sketch.tubes, more.tubes);
    move(sketch.polygons, more.polygons);
    move(sketch.lines, more.lines);
    move(sketch.arrows, more.arrows);
    move(sketch.dots, more.dots);
    move(sketch.notes, more.notes);
}

/// One view of what all pictures share.
struct BaseView {
    View view;
    std::string box;
    Panel panel;
    std::optional<Names> names;  ///< of the panel, for pictures without printed answers
};

std::string describe(const DoubleScene& scene, const std::vector<std::string>& notes) {
    const auto point = [](const Point& p) { return fmt::format("({} {} {})", figure(p.x), figure(p.y), figure(p.z)); };
    return fmt::format("The eye at {} looks at {} through an image plane at distance {}. {}", point(scene.camera.eye),
                       point(scene.camera.lookat), figure(scene.window.clip_near), fmt::join(notes, " "));
}

}  // namespace

/// Whether the names of the scene and of printed answers are placed together, or the latter around the former.
enum class Together { yes, no };

/// What all pictures share. Depends only on the assignment and, only if `with_answers`, on the key.
struct ExplainingPictures::Base {
    /// With Together::yes the scene's own names are not placed yet.
    Base(const Marking& marking, bool answers, Room room, Together names);

    bool with_answers;
    DoubleScene scene;
    RightValues right;
    Frame frame;
    ImagePlane image_plane;
    std::vector<BaseView> views;
    std::vector<std::string> notes;
    KeyLines key;
    std::string beside;    ///< image plane and key, as SVG
    Names names_in_plane;  ///< for pictures without printed answers

    /// A whole <svg> element around `body`.
    std::string page(const std::string& id_prefix, bool is_graded, const std::vector<std::string>& told,
                     const std::string& body) const;
    /// What can be drawn of one student's answers; `told` gets notes on the rest.
    PrintedSketch printed(const Graded& graded, std::vector<std::string>& told) const;
    /// Beside the views: the printed pixel, and what the marks mean.
    std::string beside_printed(const PrintedSketch& printed, Together together, std::vector<std::string>& told) const;
    std::string whole(const Graded* graded, std::vector<std::string>& told) const;
};

ExplainingPictures::Base::Base(const Marking& marking, bool answers, Room room, Together names)
    : with_answers(answers), scene(double_scene(marking.assignment)) {
    std::vector<Point> more;
    if (with_answers) {
        right = right_values(marking.key, scene);
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
        std::optional<Names> placed;
        if (names == Together::no) placed = place_names(panel.names, view.box, panel.drawn, taken_by_box(view));
        std::string box = draw_box(view, frame);
        views.push_back({std::move(view), std::move(box), std::move(panel), std::move(placed)});
    }
    image_plane = draw_image_plane(scene, right.P_VCS, image_plane_box);
    names_in_plane = place_names_in(image_plane, image_plane.names, image_plane.taken);
    key = draw_key(scene, with_answers, first_of_key);
    beside = image_plane.svg + key.svg;
}

std::string ExplainingPictures::Base::page(const std::string& id_prefix, bool is_graded,
                                           const std::vector<std::string>& told, const std::string& body) const {
    const NoteLines lines = draw_notes(told, page_width - 8, first_note);
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-labelledby=\"{0}t {0}d\" width=\"{1}\" "
               "height=\"{2}\" viewBox=\"0 0 {1} {2}\" font-family=\"{3}\" font-size=\"{4}\" "
               "fill=\"currentColor\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
               "<title id=\"{0}t\">{5}</title>\n<desc id=\"{0}d\">{6}</desc>\n",
               escape_markup(id_prefix), page_width, coordinate(lines.bottom + 8), font_family, letter_size,
               is_graded ? "The scene, and what was printed" : "The scene", escape_markup(describe(scene, told))) +
           body + lines.svg + "</svg>\n";
}

PrintedSketch ExplainingPictures::Base::printed(const Graded& graded, std::vector<std::string>& told) const {
    PrintedSketch printed = printed_sketch(graded.score, scene, with_answers ? &right : nullptr, frame);
    told.insert(told.end(), printed.sketch.notes.begin(), printed.sketch.notes.end());
    return printed;
}

std::string ExplainingPictures::Base::beside_printed(const PrintedSketch& printed, Together together,
                                                     std::vector<std::string>& told) const {
    Panel pixel;
    if (printed.P_VCS)
        pixel = draw_printed_pixel(scene, *printed.P_VCS, printed.P_VCS_name, printed.is_P_VCS_right,
                                   image_plane.window, told);
    const Sketch& sketch = printed.sketch;
    const bool any = !pixel.names.empty() || !sketch.dots.empty() || !sketch.arrows.empty();
    std::vector<Name> names = pixel.names;
    std::vector<Box> taken = names_in_plane.taken;
    if (together == Together::yes) {
        names.insert(names.begin(), image_plane.names.begin(), image_plane.names.end());
        taken = image_plane.taken;
    }
    return pixel.shapes + place_names_in(image_plane, names, taken).svg +
           (any ? draw_printed_key(with_answers, key.next) : "");
}

// Places the scene's names together with the names of this student's answers.
std::string ExplainingPictures::Base::whole(const Graded* graded, std::vector<std::string>& told) const {
    PrintedSketch own;
    if (graded != nullptr) own = printed(*graded, told);
    std::string body;
    for (const BaseView& base : views) {
        const Panel panel = draw_panel(base.view, frame, own.sketch);
        std::vector<Name> names = base.panel.names;
        names.insert(names.end(), panel.names.begin(), panel.names.end());
        std::vector<Segment> drawn = base.panel.drawn;
        drawn.insert(drawn.end(), panel.drawn.begin(), panel.drawn.end());
        body +=
            base.box + base.panel.shapes + panel.shapes +
            (panel.names.empty() && base.names ? base.names->svg
                                               : place_names(names, base.view.box, drawn, taken_by_box(base.view)).svg);
    }
    return body + beside + beside_printed(own, Together::yes, told);
}

/// A cache of drawings, by what they depend on. Students of one course often make the same mistake with the same
/// digits, and placing names takes long.
struct ExplainingPictures::Drawings {
    struct Drawing {
        std::string body;
        std::vector<std::string> told;
    };
    static constexpr std::size_t most = 256;  ///< some 4 MiB
    std::mutex mutex;
    std::map<std::string, Drawing> known;

    /// The points and vectors as printed, and which are right. A picture shows nothing else of a student.
    static std::string key_of(const Graded* graded) {
        std::string key;
        if (graded == nullptr) return key;
        for (const QuestionScore& question : graded->score.questions) {
            for (const ItemScore& item : question.items) {
                if (item.spec.shape != reference::Shape::vector) continue;
                key += fmt::format("{}.{} {} {}:{}", question.number, item.spec.name, to_string(item.verdict),
                                   item.printed.size(), item.printed);
            }
        }
        return key;
    }

    /// The result of `draw` for `key`, from the cache if it is there. `key` must also tell the kind of picture.
    template <class Draw>
    Drawing find_or(const std::string& key, Draw draw) {
        {
            const std::lock_guard lock(mutex);
            if (const auto found = known.find(key); found != known.end()) return found->second;
        }
        Drawing drawing = draw();
        const std::lock_guard lock(mutex);
        if (known.size() < most) known.emplace(key, drawing);
        return drawing;
    }
};

ExplainingPictures::ExplainingPictures(const Marking& marking, bool with_answers, const std::string& id_prefix)
    : base_(std::make_unique<const Base>(marking, with_answers, Room::for_mistakes, Together::no)),
      drawings_(std::make_unique<Drawings>()),
      id_(escape_markup(id_prefix + "scene")) {}

ExplainingPictures::~ExplainingPictures() = default;
ExplainingPictures::ExplainingPictures(ExplainingPictures&&) noexcept = default;
ExplainingPictures& ExplainingPictures::operator=(ExplainingPictures&&) noexcept = default;

std::string ExplainingPictures::shared_part() const {
    std::string svg;
    for (const BaseView& view : base_->views) svg += view.box + view.panel.shapes + view.names->svg;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"0\" height=\"0\" aria-hidden=\"true\"><defs><g id=\"{}\">\n"
        "{}</g></defs></svg>\n",
        id_, svg + base_->beside + base_->names_in_plane.svg);
}

std::string ExplainingPictures::picture(const Graded* graded, const std::string& id_prefix) const {
    const auto drawing = drawings_->find_or("own " + Drawings::key_of(graded), [&] {
        std::vector<std::string> told = base_->notes;
        PrintedSketch printed;
        if (graded != nullptr) printed = base_->printed(*graded, told);
        std::string body = fmt::format("<use href=\"#{}\"/>\n", id_);
        for (const BaseView& base : base_->views) {
            const Panel own = draw_panel(base.view, base_->frame, printed.sketch);
            std::vector<Segment> drawn = base.panel.drawn;
            drawn.insert(drawn.end(), own.drawn.begin(), own.drawn.end());
            body += own.shapes + place_names(own.names, base.view.box, drawn, base.names->taken).svg;
        }
        body += base_->beside_printed(printed, Together::no, told);
        return Drawings::Drawing{std::move(body), std::move(told)};
    });
    return base_->page(id_prefix, graded != nullptr, drawing.told, drawing.body);
}

std::string ExplainingPictures::whole_picture(const Graded* graded, const std::string& id_prefix) const {
    const auto drawing = drawings_->find_or("whole " + Drawings::key_of(graded), [&] {
        std::vector<std::string> told = base_->notes;
        std::string body = base_->whole(graded, told);
        return Drawings::Drawing{std::move(body), std::move(told)};
    });
    return base_->page(id_prefix, graded != nullptr, drawing.told, drawing.body);
}

std::string explaining_picture(const Marking& marking, const Graded* graded, bool with_answers,
                               const std::string& id_prefix) {
    const Room room = graded == nullptr ? Room::for_scene : Room::for_mistakes;
    const ExplainingPictures::Base base(marking, with_answers, room, graded == nullptr ? Together::no : Together::yes);
    std::vector<std::string> told = base.notes;
    const std::string body = base.whole(graded, told);
    return base.page(id_prefix, graded != nullptr, told, body);
}

}  // namespace harness::report
