#include "reference/toml/rubric.h"

#include <algorithm>
#include <cmath>

namespace reference {

double Rubric::points_of(int question) const {
    const auto found = points.find(question);
    return found == points.end() ? points_per_question : found->second;
}

std::optional<double> Rubric::tolerance_of(int question, const std::string& item) const {
    const std::string number = std::to_string(question);
    for (const std::string& key : {number + "." + item, number}) {
        if (const auto found = item_tolerance.find(key); found != item_tolerance.end()) return found->second;
    }
    return tolerance;
}

std::string_view to_string(Feedback feedback) {
    switch (feedback) {
        case Feedback::verdict: return "verdict";
        case Feedback::hint: return "hint";
        case Feedback::mistake: return "mistake";
        case Feedback::expected: return "expected";
    }
    return "";
}

Feedback feedback_at(const Rubric& rubric, std::chrono::system_clock::time_point clock) {
    if (!rubric.due || !rubric.feedback_after_due) return rubric.feedback;
    const bool is_after = is_over(*rubric.due, clock - std::chrono::minutes(rubric.grace_minutes));
    return is_after ? *rubric.feedback_after_due : rubric.feedback;
}

double largest_component(const std::vector<double>& key_value) {
    double largest = 0;
    for (const double x : key_value) largest = std::max(largest, std::abs(x));
    return largest;
}

double unit_of(const std::vector<double>& key_value) {
    return std::max(1.0, largest_component(key_value));
}

}  // namespace reference
