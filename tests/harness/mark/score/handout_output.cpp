#include "tests/harness/mark/score/handout_output.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"

namespace harness {

std::string handout_output(const std::map<std::string, std::string>& changed) {
    const std::pair<const char*, std::vector<std::pair<const char*, const char*>>> questions[] = {
        {"1", {{"P_VCS", "vec3(0.000000, 0.000000, -2.000000)"}}},
        {"2",
         {{"X_vcs", "vec3(1.000000, 0.000000, 0.000000)"},
          {"Y_vcs", "vec3(0.000000, 1.000000, 0.000000)"},
          {"Z_vcs", "vec3(0.000000, 0.000000, 1.000000)"}}},
        {"3",
         {{"M",
           "mat4x4((1.000000, 0.000000, 0.000000, 0.000000), (0.000000, 1.000000, 0.000000, 0.000000), "
           "(0.000000, 0.000000, 1.000000, 0.000000), (0.000000, 0.000000, 4.000000, 1.000000))"}}},
        {"4", {{"P_WCS", "vec3(0.000000, 0.000000, 2.000000)"}}},
        {"5", {{"V", "vec3(0.000000, 0.000000, -1.000000)"}}},
        {"6",
         {{"a", "1"},
          {"b", "-4"},
          {"c", "2"},
          {"d", "8"},
          {"t", "0.585786"},
          {"P_s", "vec3(0.000000, 0.000000, 1.414214)"}}},
        {"7", {{"N", "vec3(-0.500000, -0.500000, 0.707107)"}}},
        {"8",
         {{"A",
           "mat3x3((0.000000, 0.000000, 1.000000), (2.000000, 4.000000, 0.000000), (-2.000000, 4.000000, 0.000000))"},
          {"rhs", "vec3(0.000000, 2.000000, 0.000000)"},
          {"t8", "0"},
          {"u", "0.25"},
          {"v", "0.25"},
          {"P_t", "vec3(0.000000, 0.000000, 2.000000)"}}},
        {"9", {{"N9", "vec3(0.000000, 0.000000, 1.000000)"}}},
    };
    std::string text;
    for (const auto& [number, lines] : questions) {
        text += fmt::format("Question {}:\n", number);
        for (const auto& [label, value] : lines) {
            const auto other = changed.find(label);
            const std::string shown = std::string(label) == "t8" ? "t" : std::string(label) == "N9" ? "N" : label;
            if (other == changed.end() || !other->second.empty())
                text += fmt::format("{}: {}\n", shown, other == changed.end() ? value : other->second);
        }
    }
    const auto verdict = changed.find("verdict");
    return text + "Question 10:\n" + (verdict == changed.end() ? "ray hits triangle first" : verdict->second) + "\n";
}

std::string verdict_with(const std::map<std::string, std::string>& changed, const reference::ItemId& id) {
    static const student::Marking marking = student::handout_scene();
    return verdict_on(mark(handout_output(changed), marking), id);
}

std::string accepted_with(const std::map<std::string, std::string>& changed, const reference::ItemId& id) {
    static const student::Marking marking = student::handout_scene();
    return item_of(mark(handout_output(changed), marking), id).accepted_as;
}

}  // namespace harness
