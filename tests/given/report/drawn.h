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
/// Whether some text is this name, or a list such as "B, C" that contains it.
bool has_name(const std::string& svg, const std::string& name);

/// Every spot that a path, circle, ellipse or rectangle names, including control points and corners. A circle or an
/// ellipse gives its centre.
std::vector<Spot> spots_in(const std::string& svg);
/// The centres of the filled marks of one colour.
std::vector<Spot> dots_in(const std::string& svg, const std::string& colour);

/// The centres of the crosses, which mark wrong printed answers.
std::vector<Spot> crosses_in(const std::string& svg);

/// A line that joins a point (`from`) to its name (`to`).
struct Leader {
    Spot from;
    Spot to;
};
std::vector<Leader> leaders_in(const std::string& svg);
/// Whether a text stands beside a spot, or a leader joins the two. Allows for rounded places and for letters narrower
/// than the picture assumes.
bool belongs(const Text& text, const Spot& spot, const std::vector<Leader>& leaders);

double width_of(const std::string& svg);
double height_of(const std::string& svg);

}  // namespace drawn
