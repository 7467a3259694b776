// Places the names of points in a crowded picture: beside their points, without overlaps.
#pragma once

#include <vector>

namespace harness::report {

struct Spot {
    double x = 0;
    double y = 0;
};

struct Box {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

/// A drawn line that a name should not hide: a step of the frontier, an interval's bar.
struct Segment {
    Spot from;
    Spot to;
};

struct Label {
    Spot point;
    double width = 0;
    double height = 0;
};

struct Placement {
    std::vector<Box> boxes;  ///< one per label, inside the area
    bool is_clear = false;   ///< no box touches another box or hides a point
};

/// Settings of the search for places.
struct PlaceSearch {
    std::vector<Box> taken = {};  ///< where something stands already
    int shuffled = 32;            ///< random starting orders, besides the seven fixed ones
    double farthest = 1e9;        ///< largest distance of a place from its point
    double price_of_drawn = 12;   ///< for each line that a label hides, in units of distance
};

/// Deterministic. If the area is too small for all labels, boxes overlap and `is_clear` is false.
Placement place_labels(const std::vector<Label>& labels, const Box& area, const std::vector<Segment>& drawn,
                       const PlaceSearch& search = {});

/// The end of a leader line: the box's nearest spot to its point.
Spot nearest_on(const Box& box, const Spot& point);

}  // namespace harness::report
