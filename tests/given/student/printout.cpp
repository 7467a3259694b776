#include "tests/given/student/printout.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace student {
namespace {

using reference::Shape;

constexpr int heading_styles = 8;
constexpr int label_styles = 4;

std::string heading(int style, int question) {
    switch (style) {
        case 0: return fmt::format("Question {}:\n", question);
        case 1: return fmt::format("Q{})\n", question);
        case 2: return fmt::format("--- Question #{} ---\n", question);
        case 3: return fmt::format("Part {}:\n", question);
        case 4: return fmt::format("{}. {}\n", question, reference::question_title(question));
        case 5: return fmt::format("QUESTION {} - {}\n", question, reference::question_title(question));
        case 6: return fmt::format("Exercise {}\n", question);
        default: return fmt::format("***** Q{} *****\n", question);
    }
}

const std::vector<std::string>& labels_of(const ItemId& id) {
    static const std::map<ItemId, std::vector<std::string>> labels = {
        {{1, "P_VCS"}, {"Pixel in VCS", "P_VCS", "P_vcs", "pixel VCS"}},
        {{2, "X_vcs"}, {"X_vcs", "Xvcs", "X", "X axis"}},
        {{2, "Y_vcs"}, {"Y_vcs", "Yvcs", "Y", "Y axis"}},
        {{2, "Z_vcs"}, {"Z_vcs", "Zvcs", "Z", "Z axis"}},
        {{3, "M_VCS_to_WCS"}, {"M_VCS_to_WCS", "M", "Matrix", "inverse of the view matrix"}},
        {{4, "P_WCS"}, {"Pixel in WCS", "P_WCS", "P_wcs", "pixel WCS"}},
        {{5, "V"}, {"V", "ray direction", "unit vector V", "direction V"}},
        {{6, "a"}, {"a", "a", "a", "coefficient a"}},
        {{6, "b"}, {"b", "b", "b", "coefficient b"}},
        {{6, "c"}, {"c", "c", "c", "coefficient c"}},
        {{6, "d"}, {"d", "discriminant", "disc", "discriminant d"}},
        {{6, "t"}, {"t", "ray parameter t", "t_sphere", "t"}},
        {{6, "hit"}, {"Hit point P_s", "hit point", "P_s", "Hit"}},
        {{7, "normal"}, {"Sphere normal", "normal", "N", "unit normal"}},
        {{8, "matrix"}, {"Matrix A", "A", "matrix", "the matrix A"}},
        {{8, "rhs"}, {"Right-hand side", "rhs", "right-hand side", "RHS"}},
        {{8, "t"}, {"t", "t", "t_tri", "t"}},
        {{8, "u"}, {"u", "u", "u", "u"}},
        {{8, "v"}, {"v", "v", "v", "v"}},
        {{8, "hit"}, {"Hit point P_t", "hit point", "P_t", "Hit"}},
        {{9, "normal"}, {"Triangle normal", "normal", "N", "unit normal"}},
    };
    return labels.at(id);
}

constexpr std::string_view handout_text[] = {
    "Transform the pixel P_DCS = (150 100) from DCS to VCS",
    "Obtain the three basis vectors of the VCS system",
    "Compute the inverse of the view matrix",
    "Use this matrix to obtain the pixel's world coordinates",
    "Obtain a unit-length vector in the direction from the eye to the pixel",
    "Compute the point where the ray hits the sphere",
    "Get the surface normal at the hit point and normalize it",
    "Now compute the point where the ray hits the triangle",
    "Get the surface normal of the triangle and normalize it",
    "Both hit points have an associated ray distance",
};

class Printer {
  public:
    Printer(const Program& program, const Layout& layout, const std::function<bool(const ItemId&)>& keep)
        : program_(program), layout_(layout), keep_(keep), random_(layout.seed) {}

    std::string print() {
        std::vector<int> questions{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
        if (layout_.shuffled) std::shuffle(questions.begin(), questions.end(), random_);
        for (const int question : questions) print_question(question);
        if (layout_.crlf) {
            std::string lines;
            for (const char c : text_) lines += c == '\n' ? "\r\n" : std::string(1, c);
            return lines;
        }
        return text_;
    }

  private:
    bool chance(int percent) { return static_cast<int>(random_() % 100) < percent; }

    void print_question(int question) {
        if (layout_.colours) text_ += "\x1b[1;32m";
        text_ += heading(layout_.heading, question);
        if (layout_.colours) text_ += "\x1b[0m";
        if (layout_.question_text) text_ += std::string(handout_text[question - 1]) + "\n";
        for (const reference::ItemSpec& spec : reference::all_items()) {
            const ItemId id{spec.question, spec.name};
            if (spec.question != question || !keep_(id)) continue;
            if (layout_.debug_lines && chance(20))
                text_ += fmt::format("debug: step {} of 7, tmp = {}\n", random_() % 7, number(0.125F));
            if (layout_.blank_lines && chance(30)) text_ += "\n";
            if (spec.shape == Shape::verdict)
                text_ += std::string(reference::sentence(program_.verdict())) + "\n";
            else
                print_item(id, spec.shape);
        }
    }

    void print_item(const ItemId& id, Shape shape) {
        const std::string label = labels_of(id).at(static_cast<std::size_t>(layout_.labels));
        const std::optional<Floats>& value = program_.values().at(id);
        if (!value)
            text_ += label + layout_.separator + (chance(50) ? "none" : "no hit") + "\n";
        else if (shape == Shape::matrix3 || shape == Shape::matrix4)
            print_matrix(label, *value);
        else if (value->size() == 1)
            text_ += label + layout_.separator + number(value->front()) + "\n";
        else
            print_vector(id, label, *value);
    }

    void print_vector(const ItemId& id, const std::string& label, const Floats& p) {
        const std::string start = label + layout_.separator;
        const bool is_point = id.second == "P_VCS" || id.second == "P_WCS" || id.second == "hit";
        const std::string x = number(p[0]), y = number(p[1]), z = number(p[2]);
        switch (layout_.vectors) {
            case VectorLayout::to_string:
                text_ += fmt::format("{}vec3({:f}, {:f}, {:f})\n", start, p[0], p[1], p[2]);
                return;
            case VectorLayout::vec4:
                text_ += fmt::format("{}vec4({:f}, {:f}, {:f}, {:f})\n", start, p[0], p[1], p[2], is_point ? 1.0 : 0.0);
                return;
            case VectorLayout::bracketed:
                text_ += fmt::format("{}{}{}, {}, {}{}\n", start, layout_.open, x, y, z, layout_.close);
                return;
            case VectorLayout::spaced: text_ += fmt::format("{}{} {} {}\n", start, x, y, z); return;
            case VectorLayout::components: text_ += fmt::format("{}: x = {}, y = {}, z = {}\n", label, x, y, z); return;
            case VectorLayout::component_lines:
                text_ += fmt::format("{}\n  x = {}\n  y = {}\n  z = {}\n", start, x, y, z);
                return;
        }
    }

    void print_matrix(const std::string& label, const Floats& m) {
        const std::size_t n = m.size() == 16 ? 4 : 3;
        const auto entry = [&](std::size_t column, std::size_t row) { return m[column * n + row]; };
        const auto line = [&](bool by_rows, std::size_t i, std::string_view between, auto shown) {
            std::string text;
            for (std::size_t k = 0; k < n; ++k)
                text += (k == 0 ? "" : std::string(between)) + shown(by_rows ? entry(k, i) : entry(i, k));
            return text;
        };
        const auto as_number = [&](float x) { return number(x); };
        switch (layout_.matrices) {
            case MatrixLayout::to_string:
                text_ += fmt::format("{}{}mat{}x{}(", label, layout_.separator, n, n);
                for (std::size_t i = 0; i < n; ++i)
                    text_ += (i == 0 ? "(" : ", (") +
                             line(false, i, ", ", [](float x) { return fmt::format("{:f}", x); }) + ")";
                text_ += ")\n";
                return;
            case MatrixLayout::rows:
                text_ += label + ":\n";
                for (std::size_t i = 0; i < n; ++i) text_ += "  " + line(true, i, "  ", as_number) + "\n";
                return;
            case MatrixLayout::labelled_rows:
                text_ += label + ":\n";
                for (std::size_t i = 0; i < n; ++i)
                    text_ +=
                        fmt::format("row {}: {}{}{}\n", i, layout_.open, line(true, i, ", ", as_number), layout_.close);
                return;
            case MatrixLayout::labelled_columns:
                text_ += label + ":\n";
                for (std::size_t i = 0; i < n; ++i)
                    text_ += fmt::format("column {}: {}{}{}\n", i, layout_.open, line(false, i, ", ", as_number),
                                         layout_.close);
                return;
        }
    }

    std::string number(float x) const {
        switch (layout_.format) {
            case NumberFormat::fixed: return fmt::format("{:.{}f}", x, layout_.digits);
            case NumberFormat::stream: return fmt::format("{:.6g}", x);
            case NumberFormat::scientific: return fmt::format("{:.{}e}", x, layout_.digits);
        }
        return "";
    }

    const Program& program_;
    const Layout& layout_;
    const std::function<bool(const ItemId&)>& keep_;
    std::mt19937_64 random_;
    std::string text_;
};

}  // namespace

std::string Layout::describe() const {
    return fmt::format(
        "seed {}: format {} with {} digits, vectors {}, matrices {}, brackets {}{}, heading {}, labels {}, separator "
        "'{}'{}{}{}{}{}{}",
        seed, static_cast<int>(format), digits, static_cast<int>(vectors), static_cast<int>(matrices), open, close,
        heading, labels, separator, shuffled ? ", shuffled" : "", debug_lines ? ", debug lines" : "",
        blank_lines ? ", blank lines" : "", question_text ? ", question text" : "", colours ? ", colours" : "",
        crlf ? ", CRLF" : "");
}

Layout random_layout(std::uint64_t seed, int least_decimals) {
    std::mt19937_64 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
    constexpr const char* brackets[][2] = {{"(", ")"}, {"[", "]"}, {"{", "}"}, {"<", ">"}};
    constexpr const char* separators[] = {": ", " = ", " -> ", ":\t", "= "};
    Layout layout;
    layout.seed = seed;
    layout.format = static_cast<NumberFormat>(below(3));
    const int least = layout.format == NumberFormat::scientific ? std::max(5, least_decimals) : least_decimals;
    layout.digits = least + below(9 - least);
    layout.vectors = static_cast<VectorLayout>(below(6));
    layout.matrices = static_cast<MatrixLayout>(below(4));
    const auto& bracket = brackets[below(4)];
    layout.open = bracket[0];
    layout.close = bracket[1];
    layout.heading = below(heading_styles);
    layout.labels = below(label_styles);
    layout.separator = separators[below(5)];
    layout.shuffled = below(4) == 0;
    layout.debug_lines = below(3) == 0;
    layout.blank_lines = below(2) == 0;
    layout.question_text = below(4) == 0;
    layout.colours = below(5) == 0;
    layout.crlf = below(5) == 0;
    return layout;
}

std::string print(const Program& program, const Layout& layout, const std::function<bool(const ItemId&)>& keep) {
    return Printer(program, layout, keep).print();
}

std::string print(const Program& program, const Layout& layout) {
    return print(program, layout, [](const ItemId&) { return true; });
}

std::string print(const Program& program) {
    return print(program, Layout());
}

std::string with_line(std::string output, int question, const std::string& label, const std::string& value) {
    const std::size_t heading = output.find(fmt::format("Question {}:", question));
    const std::size_t line = output.find("\n" + label + ": ", heading);
    if (line == std::string::npos) throw std::invalid_argument(label);
    output.replace(line, output.find('\n', line + 1) - line, "\n" + label + ": " + value);
    return output;
}

}  // namespace student
