#include "tests/given/student/unusual.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <initializer_list>
#include <random>
#include <sstream>

#include "reference/key/answer_key.h"
#include "tests/given/student/items.h"

namespace student {
namespace {

/// The line with each run of `characters` replaced by what `replace` makes of it and of the characters around it.
std::string with_runs(const std::string& line, const std::string& characters,
                      const std::function<std::string(const std::string&, char, char)>& replace) {
    std::string text;
    for (std::size_t i = 0; i < line.size();) {
        const std::size_t end = std::min(line.find_first_not_of(characters, i), line.size());
        if (end == i) {
            text += line[i++];
            continue;
        }
        text += replace(line.substr(i, end - i), i > 0 ? line[i - 1] : ' ', end < line.size() ? line[end] : ' ');
        i = end;
    }
    return text;
}

/// A printout in the second grammar.
class OddHand : private Choices {
  public:
    OddHand(const Program& program, std::uint64_t seed) : Choices(seed), program_(program) {}

    Writing write() {
        const std::string& order = one_of("items", {"handout's", "handout's", "reversed"});
        for (const reference::Question& question : program_.questions()) {
            head(question.number);
            std::vector<reference::ItemSpec> items;
            for (const reference::ItemSpec& spec : program_.asked()) {
                if (spec.question == question.number) items.push_back(spec);
            }
            if (order == "reversed") std::ranges::reverse(items);
            print_items(items);
        }
        if (one_of("end", {"nothing", "nothing", "work units"}) == "work units") text_ += "work units 42 of 42\n";
        return {std::move(text_), all()};
    }

  private:
    void head(int question) {
        const std::string& style = one_of("heading", {"Question 1", "Question 1", "Q1", "@1@", ">> one", "{1}", "-1-",
                                                      "no. 1 /", "none", "rule", "ex1", "T1/10"});
        constexpr const char* spelled[] = {"one", "two",   "three", "four", "five",
                                           "six", "seven", "eight", "nine", "ten"};
        if (style == "none") return;
        if (style == "rule") {
            text_ += "~~~~~~~~~~\n";
            return;
        }
        std::string shown = style;
        if (style == ">> one") shown.replace(3, 3, spelled[question - 1]);
        if (const auto at = shown.find('1'); at != std::string::npos) shown.replace(at, 1, std::to_string(question));
        text_ += shown + "\n";
    }

    std::string number(float x) {
        const std::string& format = one_of("number", {"%f", "%f", "%g", "%.4f", "%e", "%.9g"});
        if (format == "%g") return fmt::format("{:g}", x);
        if (format == "%.9g") return fmt::format("{:.9g}", x);
        if (format == "%.4f") return fmt::format("{:.4f}", x);
        if (format == "%e") return fmt::format("{:e}", x);
        return fmt::format("{:f}", x);
    }

    std::string label(const ItemId& id) {
        const std::string& kind = one_of("labels", {"names", "names", "invented", "none", "counted", "glued"});
        if (kind == "none") return "";
        if (kind == "counted") return fmt::format("val{}", ++counted_);
        if (kind == "invented") {
            constexpr const char* invented[] = {"zork", "blip", "quax", "mumu", "plonk", "fnord", "yarp", "gleb"};
            return invented[(id.name.size() * 7 + static_cast<std::size_t>(id.name.front())) % std::size(invented)];
        }
        return std::string(id.name);
    }

    void line(const ItemId& id, const std::string& value) {
        const std::string& between = one_of("between label and value",
                                            {" ==> ", " ~> ", " .... ", " :: ", " >> ", "\t\t", " (is) ", " | ", "~"});
        const std::string name = label(id);
        if (one_of("label's place", {"before", "before", "behind", "above"}) == "behind" && !name.empty()) {
            text_ += value + between + name + "\n";
        } else if (drawn("label's place") == "above" && !name.empty()) {
            text_ += name + between + "\n" + value + "\n";
        } else {
            text_ += (name.empty() ? "" : name + between) + value + "\n";
        }
    }

    std::string list(std::span<const float> numbers) {
        const std::string& between =
            one_of("between numbers", {", ", " ", " ~ ", " x ", " / ", " . ", " && ", "\t", " then ", "   "});
        const std::string& frame = one_of("frame", {"", "", "<>", "[[]]", "!!", "\"\""});
        std::string text = frame.substr(0, frame.size() / 2);
        for (std::size_t i = 0; i < numbers.size(); ++i) text += (i == 0 ? "" : between) + number(numbers[i]);
        return text + frame.substr(frame.size() / 2);
    }

    void print_items(const std::vector<reference::ItemSpec>& items) {
        std::vector<ItemId> beside;  // vectors that are printed side by side
        for (const reference::ItemSpec& spec : items) {
            if (spec.shape == reference::Shape::first_object) {
                verdict();
                continue;
            }
            const auto& value = program_.values().at(spec.id);
            if (!value) {
                line(spec.id, "none");
                continue;
            }
            if (one_of("intermediate results", {"none", "none", "some"}) == "some" && value->size() == 3)
                text_ += "step " + number((*value)[0] * 2 + (*value)[1]) + "\n";
            if (value->size() == 1) line(spec.id, number(value->front()));
            if (value->size() == 3) vector(spec.id, *value, beside);
            if (value->size() > 3) matrix(spec.id, *value);
        }
        if (beside.empty()) return;
        for (std::size_t i = 0; i < 3; ++i) {
            Floats row;
            for (const ItemId& id : beside) row.push_back((*program_.values().at(id))[i]);
            text_ += list(row) + "\n";
        }
    }

    void vector(const ItemId& id, const Floats& p, std::vector<ItemId>& beside) {
        const std::string& form =
            one_of("vector", {"one line", "one line", "one line", "three lines", "side by side", "indexed"});
        if (form == "one line") return line(id, list(p));
        if (form == "side by side") return beside.push_back(id);
        if (const std::string name = label(id); !name.empty()) text_ += name + "\n";
        for (std::size_t i = 0; i < 3; ++i)
            text_ += (form == "indexed" ? fmt::format("{} ", i) : std::string()) + number(p[i]) + "\n";
    }

    void matrix(const ItemId& id, const Floats& m) {
        const std::size_t n = m.size() == 16 ? 4 : 3;
        const std::string& form = one_of("matrix", {"rows", "rows", "flat", "indexed rows", "one a line"});
        Floats by_rows;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t k = 0; k < n; ++k) by_rows.push_back(m[k * n + i]);
        }
        if (form == "flat") return line(id, list(by_rows));
        if (const std::string name = label(id); !name.empty()) text_ += name + "\n";
        for (std::size_t i = 0; i < n; ++i) {
            const std::span<const float> row(by_rows.data() + i * n, n);
            if (form == "indexed rows") text_ += fmt::format("{}) ", i + 1);
            if (form != "one a line") {
                text_ += list(row) + "\n";
                continue;
            }
            for (const float x : row) text_ += number(x) + "\n";
        }
    }

    void verdict() {
        const auto object = program_.first_object().kind();
        const std::string name = object ? std::string(to_string(*object)) : "none";
        const std::string& form = one_of("verdict", {"sentence", "FIRST=[]", "winner >>", "name"});
        if (form == "FIRST=[]") text_ += "FIRST=[" + name + "]\n";
        if (form == "winner >>") text_ += "winner >> " + name + "\n";
        if (form == "name") text_ += name + "\n";
        if (form == "sentence") text_ += reference::sentence(program_.first_object()) + "\n";
    }

    const Program& program_;
    std::string text_;
    int counted_ = 0;
};

}  // namespace

std::string garbled(const Writing& writing, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto one_of = [&](std::initializer_list<const char*> list) {
        return *(list.begin() + random() % list.size());
    };
    const auto kind = random() % 5;
    std::string text;
    std::istringstream lines(writing.output);
    const std::string heading = writing.features.contains("heading") ? writing.features.at("heading") : "";
    const std::string before_number = heading.substr(0, heading.find('1'));
    for (std::string line; std::getline(lines, line);) {
        std::string changed = line;
        if (kind == 0) {
            const std::string sign = one_of({" .. ", " <-> ", " to ", " # ", " $ ", " %% ", " then ", " @ "});
            changed = with_runs(line, " ,;|/_&\t", [&](const std::string& run, char before, char after) {
                return std::isdigit(before) && (std::isdigit(after) || after == '-') ? sign : run;
            });
        } else if (kind == 1) {
            const std::string word = one_of({"foo", "qux", "zzz", "lorem"});
            const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
            changed = with_runs(line, letters,
                                [&](const std::string& run, char, char) { return run.size() > 1 ? word : run; });
        } else if (kind == 2) {
            const std::string before_it = one_of({"", "", "v", "'"}), behind = one_of({"m", "_px", "'"});
            changed = with_runs(line, "0123456789.", [&](const std::string& run, char, char) {
                return run.find('.') == std::string::npos ? run : before_it + run + behind;
            });
        } else if (kind == 3 && random() % 4 == 0) {
            text += changed + " ~ ";
            continue;
        } else if (kind == 4) {
            if (before_number.size() > 1 && changed.starts_with(before_number)) changed = "next";
        }
        text += changed + "\n";
    }
    return text;
}

Writing write_unusual(const Program& program, std::uint64_t seed) {
    return OddHand(program, seed).write();
}

}  // namespace student
