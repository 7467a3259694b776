#include "tests/given/report/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "tests/given/report/helvetica.h"

namespace drawn {
namespace {

/// A tag, with the text that follows it up to the next tag.
struct Element {
    std::string tag;  ///< without its angle brackets
    std::string content;
};

std::vector<Element> elements_of(const std::string& svg) {
    std::vector<Element> elements;
    for (std::size_t at = svg.find('<'); at != std::string::npos;) {
        const std::size_t end = svg.find('>', at);
        const std::size_t next = svg.find('<', end);
        elements.push_back({svg.substr(at + 1, end - at - 1), svg.substr(end + 1, next - end - 1)});
        at = next;
    }
    return elements;
}

bool has_attribute(const std::string& tag, const std::string& name) {
    return tag.find(' ' + name + "=\"") != std::string::npos;
}

std::string attribute(const std::string& tag, const std::string& name) {
    const std::string start = ' ' + name + "=\"";
    const std::size_t at = tag.find(start);
    if (at == std::string::npos) return "";
    return tag.substr(at + start.size(), tag.find('"', at + start.size()) - at - start.size());
}

double number(const std::string& tag, const std::string& name) {
    return std::strtod(attribute(tag, name).c_str(), nullptr);
}

/// A number in path data ends where the next begins, even without a blank: at a minus, or at a second decimal point.
std::vector<double> numbers_of(const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == ' ' || text[at] == ',') {
            ++at;
            continue;
        }
        std::size_t end = at + (text[at] == '-' ? 1 : 0);
        bool point = false;
        for (; end < text.size(); ++end) {
            const bool digit = std::isdigit(static_cast<unsigned char>(text[end])) != 0;
            if (!digit && (text[end] != '.' || point)) break;
            point = point || !digit;
        }
        if (end == at) {
            ADD_FAILURE() << "no number: " << text;
            break;
        }
        numbers.push_back(std::strtod(text.substr(at, end - at).c_str(), nullptr));
        at = end;
    }
    return numbers;
}

class Pen {
  public:
    void command(char letter, const std::vector<double>& numbers) {
        const bool relative = std::islower(static_cast<unsigned char>(letter)) != 0;
        const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
        const std::size_t size = kind == 'A' ? 7 : kind == 'H' || kind == 'V' ? 1 : 2;
        if (kind == 'Z') return;
        if (std::string("MLHVA").find(kind) == std::string::npos || numbers.empty() || numbers.size() % size != 0) {
            ADD_FAILURE() << "a path with " << letter << " and " << numbers.size() << " numbers";
            return;
        }
        for (std::size_t i = 0; i < numbers.size(); i += size) {
            const Spot from = relative ? at_ : Spot{};
            const double x = kind == 'V' ? at_.x : from.x + numbers[i + (kind == 'A' ? size - 2 : 0)];
            const double y = kind == 'H' ? at_.y : from.y + numbers[i + size - 1];
            if (letter == 'L') lines_.push_back({at_, {x, y}});
            at_ = {x, y};
            spots_.push_back(at_);
        }
    }
    const std::vector<Spot>& spots() const { return spots_; }
    const std::vector<Line>& lines() const { return lines_; }

  private:
    Spot at_;
    std::vector<Spot> spots_;
    std::vector<Line> lines_;
};

Pen drawn_path(const std::string& data) {
    Pen pen;
    for (std::size_t at = 0; at < data.size();) {
        std::size_t end = at + 1;
        while (end < data.size() && std::isalpha(static_cast<unsigned char>(data[end])) == 0) ++end;
        pen.command(data[at], numbers_of(data.substr(at + 1, end - at - 1)));
        at = end;
    }
    return pen;
}

std::vector<Spot> spots_of_path(const std::string& data) {
    return drawn_path(data).spots();
}

/// Decodes the entities of a text.
std::string as_seen(std::string text) {
    for (const auto& [entity, character] :
         {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}}) {
        for (std::size_t at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
            text.replace(at, std::strlen(entity), character);
    }
    return text;
}

}  // namespace

std::vector<Text> texts_in(const std::string& svg) {
    std::vector<std::string> groups;  // texts inherit sizes and anchors from their group
    std::vector<Text> texts;
    for (const Element& element : elements_of(svg)) {
        if (element.tag == "g" || element.tag.starts_with("g ")) groups.push_back(element.tag);
        if (element.tag == "/g" && !groups.empty()) groups.pop_back();
        if (!element.tag.starts_with("text")) continue;
        std::string looks = element.tag + (groups.empty() ? "" : groups.back());
        const double size = has_attribute(looks, "font-size") ? number(looks, "font-size") : 12;
        const double width = helvetica_width(as_seen(element.content), size);
        const std::string anchor = attribute(looks, "text-anchor");
        const double left = number(looks, "x") - (anchor == "middle" ? 0.5 : anchor == "end" ? 1 : 0) * width;
        const double y = number(looks, "y");
        texts.push_back({element.content, left, y - 0.75 * size, left + width, y + 0.2 * size});
    }
    return texts;
}

bool has_text(const std::string& svg, const std::string& words) {
    for (const Text& text : texts_in(svg)) {
        if (text.words == words) return true;
    }
    return false;
}

bool has_name(const std::string& svg, const std::string& name) {
    return number_of(svg, name) != 0;
}

int number_of(const std::string& svg, const std::string& name) {
    for (const Text& text : texts_in(svg)) {
        const std::size_t blank = text.words.find(' ');
        if (blank != std::string::npos && text.words.find_first_not_of("0123456789") == blank &&
            text.words.substr(blank + 1) == name)
            return std::atoi(text.words.c_str());
    }
    return 0;
}

std::vector<Spot> spots_in(const std::string& svg) {
    std::vector<Spot> spots;
    for (const Element& element : elements_of(svg)) {
        const std::string& tag = element.tag;
        if (tag.starts_with("path ")) {
            for (const Spot& spot : spots_of_path(attribute(tag, "d"))) spots.push_back(spot);
        } else if (tag.starts_with("rect ")) {
            const Spot corner{number(tag, "x"), number(tag, "y")};
            spots.push_back(corner);
            spots.push_back({corner.x + number(tag, "width"), corner.y + number(tag, "height")});
        }
    }
    return spots;
}

std::vector<Spot> dots_in(const std::string& svg, const std::string& colour) {
    std::vector<Spot> result;
    for (const Element& element : elements_of(svg)) {
        const std::string& tag = element.tag;
        if (!tag.starts_with("path ") || attribute(tag, "stroke") != colour || attribute(tag, "stroke-width") != "6")
            continue;
        const std::vector<Spot> spots = spots_of_path(attribute(tag, "d"));
        for (std::size_t i = 0; i < spots.size(); i += 2) result.push_back(spots[i]);
    }
    return result;
}

std::vector<Spot> crosses_in(const std::string& svg) {
    const std::string cross = "l8 8m0-8l-8 8";
    std::vector<Spot> result;
    for (std::size_t at = svg.find(cross); at != std::string::npos; at = svg.find(cross, at + 1)) {
        const std::size_t begin = svg.rfind('M', at) + 1;
        const std::vector<double> corner = numbers_of(svg.substr(begin, at - begin));
        result.push_back({corner.at(0) + 4, corner.at(1) + 4});
    }
    return result;
}

std::vector<Line> lines_in(const std::string& svg) {
    std::vector<Line> lines;
    for (const Element& element : elements_of(svg)) {
        if (!element.tag.starts_with("path ") || !has_attribute(element.tag, "stroke")) continue;
        const std::vector<Line> more = drawn_path(attribute(element.tag, "d")).lines();
        lines.insert(lines.end(), more.begin(), more.end());
    }
    return lines;
}

bool is_under(const Line& line, const Text& text) {
    constexpr int steps = 200;
    constexpr double rounding = 0.5;  // of a text's place
    for (int i = 0; i <= steps; ++i) {
        const double x = line.from.x + (line.to.x - line.from.x) * i / steps;
        const double y = line.from.y + (line.to.y - line.from.y) * i / steps;
        if (text.left + rounding < x && x < text.right - rounding && text.top + rounding < y &&
            y < text.bottom - rounding)
            return true;
    }
    return false;
}

bool is_beside(const Text& text, const Spot& spot) {
    constexpr double beside = 27;
    return std::hypot(std::clamp(spot.x, text.left, text.right) - spot.x,
                      std::clamp(spot.y, text.top, text.bottom) - spot.y) <= beside;
}

double width_of(const std::string& svg) {
    return number(svg.substr(0, svg.find('>')), "width");
}

double height_of(const std::string& svg) {
    return number(svg.substr(0, svg.find('>')), "height");
}

}  // namespace drawn
