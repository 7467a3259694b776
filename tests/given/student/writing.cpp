#include "tests/given/student/writing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <random>
#include <vector>

#include "reference/key/answer_key.h"
#include "tests/given/student/names.h"

namespace student {
namespace {

constexpr const char* tasks_of_2021[] = {
    "Transform the pixel P_DCS = (150 100) from DCS to VCS.",
    "Obtain the three basis vectors of the VCS system, X_vcs, Y_vcs, and Z_vcs.",
    "Compute M_VCS_to_WCS, the inverse of the view matrix.",
    "Use this matrix to obtain P_WCS, the pixel's world coordinates.",
    "Obtain a unit-length vector V in the direction from the eye to the pixel.",
    "Compute the point P_s where the ray hits the sphere. If there are 2 positive roots, pick the smaller one.",
    "Get the surface normal at the hit point: N = P_s - C. Normalize this vector.",
    "Obtain a 3x3 linear system of equations for t, u, and v. 0 <= u <= 1, 0 <= v <= 1, u+v <= 1",
    "Get the surface normal of the triangle: N = (B-A) x (C-A). Normalize this vector.",
    "Chose the point with smaller t.",
};

constexpr const char* tasks_of_2024[] = {
    "Transform the pixel P_DCS = (200 150) from DCS to WCS. The ray is P = S + tV with S = P_WCS.",
    "Solve at^2 + bt + c = 0 for the sphere. If there are 2 positive roots, pick the smaller one.",
    "Obtain a 3x3 linear system of equations for t, u, and v. 0 <= u <= 1, 0 <= v <= 1, u+v <= 1",
    "Of all hits of the tube and the 2 caps of the cylinder the one with the smallest t counts.",
    "Which of the three objects does the ray hit first?",
};

constexpr const char* spelled[] = {"One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten"};

constexpr const char* roman[] = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X"};

class Hand : private Choices {
  public:
    Hand(const Program& program, std::uint64_t seed) : Choices(seed), program_(program), noise_(~seed) {}

    Writing write() {
        greet();
        std::vector<reference::Question> questions = program_.questions();
        if (one_of("order", {"handout's", "handout's", "handout's", "handout's", "shuffled"}) == "shuffled")
            std::shuffle(questions.begin(), questions.end(), noise_);
        const bool table = is("page", "table");
        if (table) text_ += "| Question | Quantity | Value |\n|---|---|---|\n";
        for (const reference::Question& question : questions) {
            question_ = question.number;
            if (!table) head(question);
            if (!table && one_of("handout's text", {"left out", "left out", "left out", "repeated"}) == "repeated")
                text_ += handout_text(question.number) + std::string("\n");
            for (const reference::ItemSpec& spec : program_.asked()) {
                if (spec.question == question.number) print(spec);
            }
            if (!table && one_of("between questions", {"nothing", "blank line", "rule"}) != "nothing")
                text_ += is("between questions", "rule") ? "--------------------\n" : "\n";
        }
        if (!table && one_of("runs", {"one", "one", "one", "one", "another pixel"}) == "another pixel") {
            text_ += "\nAnother pixel:\n";
            for (const reference::Question& question : program_.questions()) {
                head(question);
                for (const reference::ItemSpec& spec : program_.asked()) {
                    if (spec.question == question.number) print_changed(spec);
                }
            }
        }
        leave();
        finish();
        return {std::move(text_), all()};
    }

  private:
    bool is(const std::string& feature, std::string_view choice) {
        if (feature == "page") one_of("page", {"lines", "lines", "lines", "lines", "lines", "lines", "table"});
        return drawn(feature) == choice;
    }

    void greet() {
        const std::string& start =
            one_of("start", {"nothing", "nothing", "nothing", "title", "scene", "debug", "values echoed"});
        if (start == "title") text_ += "CS 770 Assignment 6, Fall 2021\nRay casting, version 1.2\n\n";
        if (start == "scene") {
            text_ +=
                fmt::format("eye = {}\nradius = {}\nW = {}, H = {}\n\n", vector(floats(program_.scene().camera.eye)),
                            number(program_.scene().spheres[0].radius), 301, 201);
        }
        if (start == "debug") text_ += "[debug] loading took 0.25 s, 3 objects\n[debug] 42 checks passed\n";
        if (start == "values echoed") text_ += "half width 1.5 half height 0.75 near 2\n";
    }

    void leave() {
        const std::string& end = one_of("end", {"nothing", "nothing", "done", "timing", "summary"});
        if (end == "done") text_ += "Done.\n";
        if (end == "timing") text_ += "Elapsed: 0.00042 seconds\n";
        if (end == "summary" && program_.has(reference::item::sphere::t))
            text_ += "Summary: sphere at distance " + number(program_.scalar(reference::item::sphere::t)) + "\n";
    }

    void finish() {
        if (one_of("line ends", {"\\n", "\\n", "\\n", "\\r\\n"}) == "\\n") return;
        std::string lines;
        for (const char c : text_) lines += c == '\n' ? "\r\n" : std::string(1, c);
        text_ = lines;
    }

    const char* handout_text(int question) const {
        const auto index = static_cast<std::size_t>(question - 1);
        const bool is_2024 = program_.questions().size() == std::size(tasks_of_2024);
        return is_2024 ? tasks_of_2024[index] : tasks_of_2021[index];
    }

    void head(const reference::Question& asked) {
        const int question = asked.number;
        const std::string& style = one_of("heading", {"Question 1:",
                                                      "Question 1:",
                                                      "Question 1",
                                                      "Q1",
                                                      "Q1.",
                                                      "1.",
                                                      "1)",
                                                      "=== Question 1 ===",
                                                      "## Question 1",
                                                      "Problem 1:",
                                                      "Question One",
                                                      "[1]",
                                                      "Answer 1:",
                                                      "Question #1 - title",
                                                      "(1)",
                                                      "Task 1 |",
                                                      "Exercise 1",
                                                      "Roman",
                                                      "A1:",
                                                      "[1/all]",
                                                      "Computing question 1 ...",
                                                      "Output for Question 1:",
                                                      "HW6.1",
                                                      "Question 1 (10 points)",
                                                      "CS770 A6 Q1"});
        std::string shown = style;
        part_ = 0;
        if (style == "Roman") {
            shown = fmt::format("{}.", roman[question - 1]);
        } else if (style == "Question One") {
            shown = fmt::format("Question {}", spelled[question - 1]);
        } else {
            shown.replace(shown.find('1'), 1, std::to_string(question));
        }
        if (style == "[1/all]") shown.replace(shown.find("all"), 3, std::to_string(program_.questions().size()));
        if (style == "Question #1 - title") shown.replace(shown.find("title"), 5, asked.title);
        text_ += shown + "\n";
    }

    std::string number(float x) {
        const std::string& format =
            one_of("number", {"%f", "%f", "%g", "%.4f", "%.8f", "%e", "%+.5f", "%10.6f", "%.9g"});
        if (format == "%g") return fmt::format("{:g}", x);
        if (format == "%.9g") return fmt::format("{:.9g}", x);
        if (format == "%.4f") return fmt::format("{:.4f}", x);
        if (format == "%.8f") return fmt::format("{:.8f}", x);
        if (format == "%e") return fmt::format("{:e}", x);
        if (format == "%+.5f") return fmt::format("{:+.5f}", x);
        if (format == "%10.6f") return fmt::format("{:10.6f}", x);
        return fmt::format("{:f}", x);
    }

    const std::string& bracket_form() {
        return one_of("brackets", {"( )", "[ ]", "{ }", "< >", "| |", "none", "none", "vec3( )"});
    }

    /// The numbers on one line, as this student writes all lists of numbers.
    std::string list(const Floats& numbers) {
        const std::string& brackets =
            one_of("brackets", {"( )", "[ ]", "{ }", "< >", "| |", "none", "none", "vec3( )"});
        const std::string& comma =
            one_of("between numbers", {", ", ", ", " ", "  ", "\t", ",", "; ", " | ", " / ", " _ ", " & ", " and "});
        std::string text;
        for (const float x : numbers) text += (text.empty() ? "" : comma) + number(x);
        if (brackets == "none") return text;
        if (brackets == "vec3( )") return fmt::format("vec{}({})", numbers.size(), text);
        return brackets.front() + text + brackets.back();
    }

    /// Three numbers on one line, with or without the components' names.
    std::string vector(const Floats& p) {
        const std::string& form = one_of("vector", {"list", "list", "list", "list", "x=", "x:", "x ", "[0]", "ijk",
                                                    "in x", "e1", "json", "Vec3", "X ="});
        const std::string x = number(p[0]), y = number(p[1]), z = number(p[2]);
        if (form == "x=") return fmt::format("x={} y={} z={}", x, y, z);
        if (form == "x:") return fmt::format("x: {}, y: {}, z: {}", x, y, z);
        if (form == "x ") return fmt::format("X {} Y {} Z {}", x, y, z);
        if (form == "[0]") return fmt::format("[0]={} [1]={} [2]={}", x, y, z);
        if (form == "json") return fmt::format("{{\"x\": {}, \"y\": {}, \"z\": {}}}", x, y, z);
        if (form == "Vec3") return fmt::format("Vec3 {{ x: {}, y: {}, z: {} }}", x, y, z);
        if (form == "X =") return fmt::format("X = {}  Y = {}  Z = {}", x, y, z);
        if (form == "ijk") return fmt::format("{} i + {} j + {} k", x, y, z);
        if (form == "in x") return fmt::format("{} in x, {} in y, {} in z", x, y, z);
        if (form == "e1") return fmt::format("x -> {}; y -> {}; z -> {}", x, y, z);
        return list(p);
    }

    std::string label(const ItemId& id) {
        static const Words kinds = {"symbols", "words", "handout's", "variables"};
        const std::string& kind =
            one_of("names", {"symbols", "symbols", "words", "handout's", "handout's", "variables"});
        std::string name =
            names_of(id).at(static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin()));
        const std::string& before =
            one_of("before a name", {"nothing", "nothing", "nothing", "- ", "* ", "the ", "  ", "> "});
        return (before == "nothing" ? "" : before) + name;
    }

    /// The label and what belongs to it, where this student writes labels.
    void line(const ItemId& id, const std::string& value) {
        std::string name = label(id);
        const std::string& remark = one_of("remark", {"none", "none", "none", "none", "(float)", "(in 3D)"});
        if (remark != "none") name += " " + remark;
        if (is("page", "table")) {
            text_ += fmt::format("| {} | {} | {} |\n", question_, name, value);
            return;
        }
        const std::string& place = one_of("label", {": ", ": ", " = ", " = ", " -> ", " is ", ":\t", " ", "above",
                                                    "above:", "behind", ": =", " ... ", " equals ", "[name] "});
        if (place == "above") {
            text_ += name + "\n" + value + "\n";
        } else if (place == "above:") {
            text_ += name + ":\n" + value + "\n";
        } else if (place == "behind") {
            text_ += value + " = " + name + "\n";
        } else if (place == ": =") {
            text_ += name + ": = " + value + "\n";
        } else if (place == "[name] ") {
            text_ += "[" + name + "] " + value + "\n";
        } else {
            text_ += name + place + value + "\n";
        }
    }

    void print(const reference::ItemSpec& spec) {
        const std::size_t begin = text_.size();
        print_item(spec);
        const auto is_of_question = [&](const reference::ItemSpec& each) { return each.question == question_; };
        const bool has_parts = std::ranges::count_if(program_.asked(), is_of_question) > 1 && text_.size() > begin;
        const std::string& form =
            one_of("parts", {"none", "none", "none", "none", "none", "a)", "A)", "(a) above", "1.1"});
        if (form == "none" || is("page", "table") || !has_parts) return;
        const char letter = static_cast<char>('a' + part_++);
        text_.insert(begin, form == "a)"          ? fmt::format("{}) ", letter)
                            : form == "A)"        ? fmt::format("{}) ", static_cast<char>(letter - 'a' + 'A'))
                            : form == "(a) above" ? fmt::format("({})\n", letter)
                                                  : fmt::format("{}.{} ", question_, part_));
    }

    void print_item(const reference::ItemSpec& spec) {
        const ItemId id = spec.id;
        if (spec.shape == reference::Shape::first_object) return verdict();
        const auto& value = program_.values().at(id);
        if (!value) return line(id, one_of("no value", {"none", "no hit", "does not exist", "n/a"}));
        if (id == reference::item::sphere::t &&
            one_of("roots", {"not printed", "not printed", "before t"}) == "before t") {
            const float b = program_.scalar(reference::item::sphere::b),
                        d = program_.scalar(reference::item::sphere::d),
                        a = program_.scalar(reference::item::sphere::a);
            const std::string far = number((-b + std::sqrt(d)) / (2 * a)), near = number((-b - std::sqrt(d)) / (2 * a));
            if (is("page", "table")) {
                text_ += fmt::format("| {0} | t1 | {1} |\n| {0} | t2 | {2} |\n", question_, near, far);
            } else {
                text_ += fmt::format("t1 = {}, t2 = {}\n", near, far);
            }
        }
        if (value->size() == 1) return scalar(id, value->front());
        if (value->size() == 3) return print_vector(id, *value);
        if (one_of("noise", {"none", "none", "none", "intermediate"}) == "intermediate")
            text_ += "debug: determinant before inverting: " + number(0.75F) + "\n";
        matrix(id, *value);
    }

    /// An item as for another pixel.
    void print_changed(const reference::ItemSpec& spec) {
        const ItemId id = spec.id;
        if (spec.shape == reference::Shape::first_object) return verdict();
        const auto& value = program_.values().at(id);
        if (!value || value->size() > 3) return;
        Floats changed = *value;
        for (float& x : changed) x = 0.75F * x + 0.125F;
        if (value->size() == 1) return line(id, number(changed.front()));
        print_vector(id, changed);
    }

    void verdict() {
        const std::string said = reference::sentence(program_.first_object());
        if (is("page", "table")) {
            text_ += fmt::format("| {} | verdict | {} |\n", question_, said);
        } else {
            text_ += one_of("verdict", {"plain", "plain", "arrow"}) == "arrow" ? "=> " + said + "\n" : said + "\n";
        }
    }

    void scalar(const ItemId& id, float x) {
        const bool has_quadratic =
            id.subject == reference::Subject::sphere || id.subject == reference::Subject::cylinder;
        if (has_quadratic && id.name != "normal" && !is("page", "table")) {
            const std::string& form = one_of("quadratic", {"lines", "lines", "lines", "one line", "equation",
                                                           "one list", "slashes", "equation, disc"});
            const bool whole =
                program_.has({id.subject, "a"}) && program_.has({id.subject, "b"}) && program_.has({id.subject, "c"});
            const auto coefficient = [&](const char* name) { return number(program_.scalar({id.subject, name})); };
            const auto sign = [&](const char* name) { return program_.scalar({id.subject, name}) < 0 ? "-" : "+"; };
            const auto size = [&](const char* name) { return size_of(program_.scalar({id.subject, name})); };
            if (whole && form != "lines" && (id.name == "b" || id.name == "c")) return;
            if (whole && form == "one line" && id.name == "a") {
                text_ += fmt::format("a = {}, b = {}, c = {}\n", x_of(x), coefficient("b"), coefficient("c"));
                return;
            }
            if (whole && form == "one list" && id.name == "a") {
                text_ += fmt::format("a b c: {} {} {}\n", x_of(x), coefficient("b"), coefficient("c"));
                return;
            }
            if (whole && form == "slashes" && id.name == "a") {
                text_ += fmt::format("abc = {}/{}/{}\n", x_of(x), coefficient("b"), coefficient("c"));
                return;
            }
            if (whole && form.starts_with("equation") && id.name == "a") {
                text_ += fmt::format("{}t^2 {} {}t {} {} = 0", x_of(x), sign("b"), size("b"), sign("c"), size("c"));
                if (is_with_disc(id)) text_ += fmt::format(", disc {}", coefficient("d"));
                text_ += "\n";
                return;
            }
            if (whole && id.name == "d" && is_with_disc(id)) return;
        }
        line(id, number(x));
    }
    /// Whether the discriminant stands behind the equation, on its line.
    bool is_with_disc(const ItemId& id) { return is("quadratic", "equation, disc") && program_.has({id.subject, "d"}); }
    std::string x_of(float x) { return number(x); }
    std::string size_of(float x) {
        std::string text = number(x < 0 ? -x : x);
        if (!text.empty() && text.front() == '+') text.erase(0, 1);
        text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
        return text;
    }

    void print_vector(const ItemId& id, const Floats& p) {
        const std::string& lines = one_of("vector on", {"one line", "one line", "one line", "one line", "one line",
                                                        "three lines", "three named lines", "element by element"});
        if (lines == "one line" || is("page", "table")) return line(id, vector(p));
        const std::string name = label(id);
        constexpr const char* axes[] = {"x", "y", "z"};
        if (lines != "element by element") text_ += name + ":\n";
        for (std::size_t i = 0; i < 3; ++i) {
            if (lines == "three lines") text_ += number(p[i]) + "\n";
            if (lines == "three named lines") text_ += fmt::format("  {}: {}\n", axes[i], number(p[i]));
            if (lines == "element by element") text_ += fmt::format("{}.{} = {}\n", name, axes[i], number(p[i]));
        }
    }

    void matrix(const ItemId& id, const Floats& m) {
        const std::size_t n = m.size() == 16 ? 4 : 3;
        const auto row = [&](std::size_t i) {
            Floats numbers;
            for (std::size_t k = 0; k < n; ++k) numbers.push_back(m[k * n + i]);
            return numbers;
        };
        const auto column = [&](std::size_t i) {
            return Floats(m.begin() + static_cast<std::ptrdiff_t>(i * n),
                          m.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
        };
        const std::string name = label(id);
        if (is("page", "table")) {
            for (std::size_t i = 0; i < n; ++i)
                text_ += fmt::format("| {} | {} row {} | {} |\n", question_, name, i + 1, list(row(i)));
            return;
        }
        const std::string& form =
            one_of("matrix", {"rows",    "rows",    "rows",   "to_string", "row 1:",      "row 0:",  "col 0:",
                              "A row 1", "r1",      "[i][j]", "(i,j)",     "with header", "flat",    "barred",
                              "nested",  "line 1:", "eq 1:",  "[0]:",      "M[0] =",      "M(1,:) ="});
        if (form == "to_string" || form == "flat" || form == "nested") {
            std::string text;
            for (std::size_t i = 0; i < n; ++i) {
                const Floats part = form == "to_string" ? column(i) : row(i);
                std::string inner;
                for (const float x : part) inner += (inner.empty() ? "" : ", ") + number(x);
                if (form == "flat") text += (i == 0 ? "" : ", ") + inner;
                if (form == "nested") text += (i == 0 ? "[" : ", [") + inner + "]";
                if (form == "to_string") text += (i == 0 ? "(" : ", (") + inner + ")";
            }
            if (form == "to_string") text = fmt::format("mat{}x{}({})", n, n, text);
            if (form == "nested") text = "[" + text + "]";
            text_ += name + (form == "flat" ? " (row by row): " : ": ") + text + "\n";
            return;
        }
        text_ += name + ":\n";
        if (form == "with header") {
            text_ += "     ";
            for (std::size_t k = 0; k < n; ++k) text_ += fmt::format("c{}        ", k);
            text_ += "\n";
        }
        for (std::size_t i = 0; i < n; ++i) {
            const std::string listed = bracket_form() == "vec3( )" ? plain(row(i)) : list(row(i));  // vec4 is a column
            if (form == "rows") text_ += "  " + listed + "\n";
            if (form == "barred") text_ += "| " + plain(row(i)) + " |\n";
            if (form == "row 1:") text_ += fmt::format("row {}: {}\n", i + 1, listed);
            if (form == "row 0:") text_ += fmt::format("row {}: {}\n", i, listed);
            if (form == "col 0:") text_ += fmt::format("col {}: {}\n", i, list(column(i)));
            if (form == "A row 1") text_ += fmt::format("{} row {}  {}\n", name, i + 1, listed);
            for (const char* word : {"line", "eq"}) {
                if (form == fmt::format("{} 1:", word)) text_ += fmt::format("{} {}: {}\n", word, i + 1, listed);
            }
            // Below the heading "[1]" nobody can tell a row "[1]:" from a heading.
            if (form == "[0]:" && is("heading", "[1]")) text_ += fmt::format("row {}: {}\n", i, listed);
            if (form == "[0]:" && !is("heading", "[1]")) text_ += fmt::format("[{}]: {}\n", i, listed);
            if (form == "M[0] =") text_ += fmt::format("{}[{}] = {}\n", short_name(id), i, listed);
            if (form == "M(1,:) =") text_ += fmt::format("{}({},:) = {}\n", short_name(id), i + 1, listed);
            if (form == "r1") text_ += fmt::format("r{} {}\n", i + 1, listed);
            if (form == "with header") text_ += fmt::format("r{}   {}\n", i, plain(row(i)));
            for (std::size_t k = 0; k < n; ++k) {
                if (form == "[i][j]")
                    text_ += fmt::format("{}[{}][{}] = {}\n", short_name(id), i, k, number(column(i)[k]));
                if (form == "(i,j)")
                    text_ += fmt::format("{}({},{}) = {}\n", short_name(id), i + 1, k + 1, number(row(i)[k]));
            }
        }
    }
    static std::string short_name(const ItemId& id) { return id == reference::item::M_VCS_to_WCS ? "M" : "A"; }
    std::string plain(const Floats& numbers) {
        std::string text;
        for (const float x : numbers) text += (text.empty() ? "" : "  ") + number(x);
        return text;
    }

    const Program& program_;
    std::mt19937_64 noise_;
    std::string text_;
    int question_ = 0;
    int part_ = 0;  ///< parts printed under the question's heading
};

}  // namespace

Writing write(const Program& program, std::uint64_t seed) {
    return Hand(program, seed).write();
}

}  // namespace student
