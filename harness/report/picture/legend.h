// Numbers beside the points of a picture, and what is written beside and below the views: the legend that names the
// points, what the colors and marks mean, and the notes.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/panel.h"

namespace harness::report::picture {

/// The names of a picture's points. A name has the same number in every view.
class Legend {
  public:
    /// Of a name in the colour of what it belongs to; a new name gets the next number.
    int number_of(const Name& name);

    std::string svg(double top) const;
    double height() const;

  private:
    std::vector<Name> names_;
};

/// Numbers beside their points, as SVG. Numbers of the same spot are joined: "2, 3". Each gets the first free place
/// next to its point, away from what is drawn if there is such a place. No number touches another or what is taken in
/// the panel: without a free place it is left out, as other views show its point too.
std::string place_numbers(const Panel& panel, Legend& legend);

/// Says what each color and mark means, with the objects' sizes. `printed`: there are printed answers.
std::string draw_key(const DoubleScene& scene, bool with_answers, bool printed);

struct NoteLines {
    std::string svg;
    double bottom = 0;  ///< of the last line
};
/// Breaks the notes into lines; after some twenty lines, a last line says that more are left out.
NoteLines draw_notes(const std::vector<std::string>& notes, double width, double first_baseline);

}  // namespace harness::report::picture
