// What is drawn in an SVG, read back from the SVG alone.
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
    double left = 0, top = 0, right = 0, bottom = 0;  ///< of its letters, by their widths in Helvetica
};

/// Every text of the picture, in its order, with entities as they are.
std::vector<Text> texts_in(const std::string& svg);
bool has_text(const std::string& svg, const std::string& words);
/// Whether a text is a name or several, joined as "B, C", with this one among them.
bool has_name(const std::string& svg, const std::string& name);

/// Every spot that a path, circle, ellipse or rectangle names, control points and corners too; of a circle or an
/// ellipse the middle.
std::vector<Spot> spots_in(const std::string& svg);
/// The middles of the filled marks of one colour.
std::vector<Spot> dots_in(const std::string& svg, const std::string& colour);

/// The middles of the crosses: what was printed and is not right.
std::vector<Spot> crosses_in(const std::string& svg);

/// The lines that join names to their points, each from its point.
struct Leader {
    Spot from;
    Spot to;
};
std::vector<Leader> leaders_in(const std::string& svg);
/// Whether a text stands beside a spot, or a leader joins the two. Places are rounded, and letters narrower than
/// thought.
bool belongs(const Text& text, const Spot& spot, const std::vector<Leader>& leaders);

double width_of(const std::string& svg);
double height_of(const std::string& svg);

}  // namespace drawn
