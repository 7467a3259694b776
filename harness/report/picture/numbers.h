// Numbers beside the points of a picture, and the legend that names them.
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

    /// The lines from the first number above `first`, below `top`.
    std::string svg(double top, int first = 0) const;
    double height() const;
    int size() const { return static_cast<int>(names_.size()); }

  private:
    std::vector<Name> names_;
};

/// Numbers beside their points, as SVG. Numbers of the same spot are joined: "2, 3".
struct NumberLabels {
    std::string svg;
    std::vector<Box> taken;  ///< by the numbers and their points' marks
};
/// Each number gets the first free place next to its point, if possible away from what is drawn. No number touches
/// another number or a `taken` box: without a free place it is left out, as other views show its point too.
NumberLabels place_numbers(const std::vector<Name>& names, Legend& legend, const Box& box,
                           const std::vector<Segment>& drawn, const std::vector<Box>& taken);

}  // namespace harness::report::picture
