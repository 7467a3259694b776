// The contents of an explaining picture, in world coordinates, before they are drawn in a view.
#pragma once

#include <string>
#include <vector>

#include "harness/report/picture/point.h"

namespace harness::report::picture {

/// The object that a drawing element belongs to. Each ink has its own color and is drawn over the earlier ones.
enum class Ink { sphere, triangle, cylinder, camera, ray, printed };

enum class Stroke {
    plain,
    thin,    ///< auxiliary lines
    dashed,  ///< a printed answer that is not right
};

enum class Mark {
    dot,
    ring,   ///< a point that the ray does not hit, or a right printed answer
    cross,  ///< a printed answer that is not right
};

struct Dot {
    Point at;
    std::string name;
    Ink ink = Ink::camera;
    Mark mark = Mark::dot;
};

struct Line {
    Point from;
    Point to;
    Ink ink = Ink::camera;
    Stroke stroke = Stroke::plain;
};

/// A vector, drawn from `at`; `vector` is scaled by the frame's `arrow`.
struct Arrow {
    Point at;
    Point vector;
    std::string name;
    Ink ink = Ink::camera;
    Stroke stroke = Stroke::plain;
};

struct Polygon {
    std::vector<Point> corners;
    Ink ink = Ink::camera;
    Stroke stroke = Stroke::plain;
};

struct Ball {
    Point center;
    double radius = 0;
};

/// A cylinder around an axis parallel to the y axis.
struct Tube {
    Point center;
    double radius = 0;
    double height = 0;  ///< from cap to cap
};

/// Names are placed in this order, so the first elements keep their names if there is too little room.
struct Sketch {
    std::vector<Ball> balls;
    std::vector<Tube> tubes;
    std::vector<Polygon> polygons;
    std::vector<Line> lines;
    std::vector<Arrow> arrows;
    std::vector<Dot> dots;
    std::vector<Dot> pixels;         ///< points of the image plane, in camera coordinates
    std::vector<std::string> notes;  ///< whole sentences, plain text
};

}  // namespace harness::report::picture
