// Reads the texts, marks and lines of an SVG back from the SVG alone.
#pragma once

#include <string>
#include <vector>

namespace drawn {

struct Spot {
    double x = 0;
    double y = 0;
};

struct Text {
    std::string words;
    double left = 0, top = 0, right = 0, bottom = 0;  ///< the box of its letters, by their widths in Helvetica
};

/// Every text of the picture, in document order. Entities are not decoded.
std::vector<Text> texts_in(const std::string& svg);
bool has_text(const std::string& svg, const std::string& words);
/// Whether the legend has this name.
bool has_name(const std::string& svg, const std::string& name);
/// Its number in the legend; 0 without one.
int number_of(const std::string& svg, const std::string& name);

/// Every spot that a path names, and the corners of rectangles.
std::vector<Spot> spots_in(const std::string& svg);
/// The centres of the filled marks of one colour.
std::vector<Spot> dots_in(const std::string& svg, const std::string& colour);

/// The centres of the crosses, which mark wrong printed answers.
std::vector<Spot> crosses_in(const std::string& svg);

struct Line {
    Spot from;
    Spot to;
};

/// The straight lines, without arrows' heads and crosses.
std::vector<Line> lines_in(const std::string& svg);

/// Whether a line passes through the box of a text.
bool is_under(const Line& line, const Text& text);

/// Whether a text is next to a spot.
bool is_beside(const Text& text, const Spot& spot);

double width_of(const std::string& svg);
double height_of(const std::string& svg);

}  // namespace drawn
