// Pieces of SVG: short, deterministic, and never a number that is none.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "harness/report/label_placement.h"
#include "harness/report/picture/sketch.h"

namespace harness::report::picture {

/// At most one decimal, as "12.3", "12", "-0.5". Not finite numbers are 0.
std::string coordinate(double x);
/// "x y", as short as SVG reads it.
std::string coordinates(const Spot& spot);

/// A world number for people: at most four digits, "-0" is "0".
std::string figure(double x);

/// Readable on white and on black; what belongs to the camera has the colour of the text around.
std::string_view colour_of(Ink ink);

/// Lines of the same look become one <path>.
class Strokes {
  public:
    void line(const Segment& segment, Ink ink, Stroke stroke);
    void line_to_tip(const Segment& segment, Ink ink, Stroke stroke);  ///< with an arrow's head at its end
    void mark(const Spot& at, Ink ink, Mark mark);
    /// A piece of path data.
    void add(const std::string& path, Ink ink, Stroke stroke) { paths_[{ink, stroke}] += path; }
    std::string svg() const;

  private:
    std::map<std::pair<Ink, Stroke>, std::string> paths_;
    std::map<Ink, std::string> dots_;
    std::map<Ink, std::string> marks_;
};

/// A line of text, at whole units; `more` are further attributes, each after a blank.
std::string text_at(double x, double y, std::string_view content, std::string_view more = "");

}  // namespace harness::report::picture
