// Numbers next to the points of a picture, and the text next to and below the views: the legend that names the points,
// the meaning of colors and marks, and the notes.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/panel.h"

namespace harness::report::picture {

/// The names of a picture's points. A name has the same number in every view.
class Legend {
  public:
    /// The number of this name in this ink; a new name gets the next number.
    int number_of(const Name& name);

    std::string svg(double top) const;
    double height() const;

  private:
    std::vector<Name> names_;
};

/// Numbers next to their points, as SVG. Numbers at the same spot are joined: "2, 3". Each gets the first free place
/// next to its point and away from drawn lines, or farther away with a line that leads to it. No number touches another
/// number or the panel's taken boxes. A number without a free place is left out, because other views show its point
/// too.
std::string place_numbers(Panel panel, Legend& legend);

/// Says what each color and mark means, with the objects' sizes. `printed`: there are printed answers.
std::string draw_key(const DoubleScene& scene, bool with_answers, bool printed);

struct NoteLines {
    std::string svg;
    double bottom = 0;  ///< of the last line
};
/// Breaks the notes into lines; after some twenty lines, a last line says that more are left out.
NoteLines draw_notes(const std::vector<std::string>& notes, double width, double first_baseline);

}  // namespace harness::report::picture
