// Pieces of SVG: short, deterministic, and without nan or inf.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "harness/report/picture/sketch.h"
#include "reference/stages/items.h"

namespace harness::report::picture {

/// With at most one decimal: "12.3", "12", "-0.5". A number that is not finite becomes 0.
std::string coordinate(double x);
/// "x y", in the shortest form that SVG allows.
std::string coordinates(const Spot& spot);

/// A number of the scene for people: at most four digits; "-0" becomes "0".
std::string figure(double x);

/// Readable on white and on black; the camera has the color of the surrounding text.
std::string_view colour_of(Ink ink);

/// The ink of an object of this kind; the camera's ink for subjects other than objects.
Ink ink_of(reference::Subject kind);

/// Lines of the same look become one <path>.
class Strokes {
  public:
    /// Continues the previous line with this look if the segment starts where that line ended.
    void line(const Segment& segment, Ink ink, Stroke stroke);
    void line_to_tip(const Segment& segment, Ink ink, Stroke stroke);  ///< with an arrow's head at its end
    void mark(const Spot& at, Ink ink, Mark mark);
    /// Adds a piece of path data.
    void add(const std::string& path, Ink ink, Stroke stroke);
    std::string svg() const;

  private:
    std::map<std::pair<Ink, Stroke>, std::string> paths_;
    std::map<std::pair<Ink, Stroke>, std::string> ends_;  ///< of the last line with each look
    std::map<Ink, std::string> dots_;
    std::map<Ink, std::string> marks_;
};

inline constexpr const char* font_family = "Helvetica, Arial, 'Liberation Sans', sans-serif";
inline constexpr double letter_size = 12;
inline constexpr double line_height = 15;

/// A line of text, placed at whole units; `more` has further attributes, each after a blank.
std::string text_at(double x, double y, std::string_view content, std::string_view more = "");

}  // namespace harness::report::picture
