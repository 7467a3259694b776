#include "tests/given/student/printout.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "reference/key/answer_key.h"

namespace student {
namespace {

using reference::Shape;

constexpr int heading_styles = 8;
constexpr int label_styles = 4;

std::string heading(int style, const reference::Question& asked) {
    const int question = asked.number;
    switch (style) {
        case 0: return fmt::format("Question {}:\n", question);
        case 1: return fmt::format("Q{})\n", question);
        case 2: return fmt::format("--- Question #{} ---\n", question);
        case 3: return fmt::format("Part {}:\n", question);
        case 4: return fmt::format("{}. {}\n", question, asked.title);
        case 5: return fmt::format("QUESTION {} - {}\n", question, asked.title);
        case 6: return fmt::format("Exercise {}\n", question);
        default: return fmt::format("***** Q{} *****\n", question);
    }
}

const std::vector<std::string>& labels_of(const ItemId& id) {
    static const std::map<ItemId, std::vector<std::string>> labels = {
        {reference::item::P_VCS, {"Pixel in VCS", "P_VCS", "P_vcs", "pixel VCS"}},
        {reference::item::X_vcs, {"X_vcs", "Xvcs", "X", "X axis"}},
        {reference::item::Y_vcs, {"Y_vcs", "Yvcs", "Y", "Y axis"}},
        {reference::item::Z_vcs, {"Z_vcs", "Zvcs", "Z", "Z axis"}},
        {reference::item::M_VCS_to_WCS, {"M_VCS_to_WCS", "M", "Matrix", "inverse of the view matrix"}},
        {reference::item::P_WCS, {"Pixel in WCS", "P_WCS", "P_wcs", "pixel WCS"}},
        {reference::item::V, {"V", "ray direction", "unit vector V", "direction V"}},
        {reference::item::sphere::a, {"a", "a", "a", "coefficient a"}},
        {reference::item::sphere::b, {"b", "b", "b", "coefficient b"}},
        {reference::item::sphere::c, {"c", "c", "c", "coefficient c"}},
        {reference::item::sphere::d, {"d", "discriminant", "disc", "discriminant d"}},
        {reference::item::sphere::t, {"t", "ray parameter t", "t_sphere", "t"}},
        {reference::item::sphere::hit, {"Hit point P_s", "hit point", "P_s", "Hit"}},
        {reference::item::sphere::normal, {"Sphere normal", "normal", "N", "unit normal"}},
        {reference::item::triangle::matrix, {"Matrix A", "A", "matrix", "the matrix A"}},
        {reference::item::triangle::rhs, {"Right-hand side", "rhs", "right-hand side", "RHS"}},
        {reference::item::triangle::t, {"t", "t", "t_tri", "t"}},
        {reference::item::triangle::u, {"u", "u", "u", "u"}},
        {reference::item::triangle::v, {"v", "v", "v", "v"}},
        {reference::item::triangle::hit, {"Hit point P_t", "hit point", "P_t", "Hit"}},
        {reference::item::triangle::normal, {"Triangle normal", "normal", "N", "unit normal"}},
        {reference::item::cylinder::a, {"a", "a", "a", "coefficient a"}},
        {reference::item::cylinder::b, {"b", "b", "b", "coefficient b"}},
        {reference::item::cylinder::c, {"c", "c", "c", "coefficient c"}},
        {reference::item::cylinder::d, {"d", "discriminant", "disc", "discriminant d"}},
        {reference::item::cylinder::t, {"t", "ray parameter t", "t_cyl", "t"}},
        {reference::item::cylinder::hit, {"Hit point P_c", "hit point", "P_c", "Hit"}},
        {reference::item::cylinder::normal, {"Cylinder normal", "normal", "N", "unit normal"}},
    };
    return labels.at(id);
}

constexpr std::string_view handout_of_2021[] = {
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

constexpr std::string_view handout_of_2024[] = {
    "Transform the pixel P_DCS = (200 150) from DCS to WCS. The ray is P = S + tV with S = P_WCS",
    "Solve at^2 + bt + c = 0 for the sphere: t is the smaller of two positive roots",
    "Solve the 3 x 3 system for t, u and v with 0 <= u <= 1, 0 <= v <= 1, u + v <= 1",
    "Of all hits of the tube and the 2 caps of the cylinder the one with the smallest t counts",
    "Which of the three objects does the ray hit first?",
};

/// What the handout asks for in the question.
std::string_view handout_text(const Program& program, int question) {
    const auto index = static_cast<std::size_t>(question - 1);
    return program.questions().size() == std::size(handout_of_2024) ? handout_of_2024[index] : handout_of_2021[index];
}

class Printer {
  public:
    Printer(const Program& program, const Layout& layout, const std::function<bool(const ItemId&)>& keep)
        : program_(program), layout_(layout), keep_(keep), random_(layout.seed) {}

    std::string print() {
        std::vector<reference::Question> questions = program_.questions();
        if (layout_.shuffled) std::shuffle(questions.begin(), questions.end(), random_);
        for (const reference::Question& question : questions) print_question(question);
        if (layout_.crlf) {
            std::string lines;
            for (const char c : text_) lines += c == '\n' ? "\r\n" : std::string(1, c);
            return lines;
        }
        return text_;
    }

  private:
    bool chance(int percent) { return static_cast<int>(random_() % 100) < percent; }

    void print_question(const reference::Question& question) {
        if (layout_.colours) text_ += "\x1b[1;32m";
        text_ += heading(layout_.heading, question);
        if (layout_.colours) text_ += "\x1b[0m";
        if (layout_.question_text) text_ += std::string(handout_text(program_, question.number)) + "\n";
        for (const reference::ItemSpec& spec : program_.asked()) {
            const ItemId& id = spec.id;
            if (spec.question != question.number || !keep_(id)) continue;
            if (layout_.debug_lines && chance(20))
                text_ += fmt::format("debug: step {} of 7, tmp = {}\n", random_() % 7, number(0.125F));
            if (layout_.blank_lines && chance(30)) text_ += "\n";
            if (spec.shape == Shape::first_object)
                text_ += reference::sentence(program_.first_object()) + "\n";
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
        const bool is_point = id.name == "P_VCS" || id.name == "P_WCS" || id.name == "hit";
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
