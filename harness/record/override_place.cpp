#include "harness/record/override_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "harness/machine/errors.h"
#include "harness/mark/score/doubts_text.h"
#include "harness/text/escape.h"
#include "harness/text/points.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

constexpr std::string_view whole = "total";

std::vector<std::string> places_of(const Score& score) {
    std::vector<std::string> places{std::string(whole)};
    if (score.variants) places.emplace_back(variants_place);
    for (const QuestionScore& question : score.questions) {
        places.push_back(std::to_string(question.number));
        for (const ItemScore& item : question.items)
            places.push_back(fmt::format("{}.{}", question.number, item.spec.name));
    }
    return places;
}

}  // namespace

std::string to_string(const OverridePlace& place) {
    if (place.question == 0) return place.item.empty() ? std::string(whole) : place.item;
    return place.item.empty() ? std::to_string(place.question) : fmt::format("{}.{}", place.question, place.item);
}

std::string place_of(const Override& given) {
    return to_string(OverridePlace{given.question, given.item});
}

std::string place_in_words(std::string_view place) {
    if (place == whole) return "the whole submission";
    if (place == variants_place) return "the other scenes";
    const std::size_t dot = place.find('.');
    return fmt::format("question {}", place.substr(0, dot)) +
           (dot == std::string_view::npos ? "" : fmt::format(", {}", name_in_words(place.substr(dot + 1))));
}

std::optional<PlacePoints> points_at(const Score& score, const Override& given) {
    if (given.question == 0 && given.item.empty()) return PlacePoints{score.points, score.max_points};
    if (given.question == 0) {
        const bool known = given.item == variants_place && score.variants;
        return known ? std::optional(PlacePoints{score.variants->points, score.variants->max_points}) : std::nullopt;
    }
    for (const QuestionScore& question : score.questions) {
        if (question.number != given.question) continue;
        if (given.item.empty()) return PlacePoints{question.points, question.max_points};
        for (const ItemScore& item : question.items) {
            if (item.spec.name == given.item) return PlacePoints{item.points, item.max_points};
        }
    }
    return std::nullopt;
}

bool is_same_place(const KeptOverride& kept_override, const KeptOverride& other) {
    return kept_override.submission == other.submission && kept_override.given.question == other.given.question &&
           kept_override.given.item == other.given.item;
}

std::vector<KeptOverride> attach(const std::vector<KeptOverride>& overrides, std::vector<Graded>& graded) {
    std::map<std::string, Graded*> by_id;
    if (!overrides.empty()) {
        for (Graded& result : graded) by_id[result.submission.id] = &result;
    }
    std::vector<KeptOverride> unmatched;
    for (const KeptOverride& kept_override : overrides) {
        const auto found = by_id.find(kept_override.submission);
        if (found == by_id.end() || !points_at(found->second->score, kept_override.given))
            unmatched.push_back(kept_override);
        if (found != by_id.end()) found->second->review.overrides.push_back(kept_override.given);
    }
    return unmatched;
}

OverridePlace read_place(std::string_view text, const Graded& graded) {
    const std::vector<std::string> places = places_of(graded.score);
    if (std::find(places.begin(), places.end(), text) == places.end()) {
        throw UsageError(fmt::format("there is no item \"{}\" in this assignment; {}", escape_control(text),
                                     reference::did_you_mean(text, places)));
    }
    if (text == whole) return {};
    if (graded.execution.outcome == Outcome::not_graded) {
        throw UsageError(
            fmt::format("{} was not graded, so it has no items; use \"total\" to give points for the whole submission",
                        graded.submission.id));
    }
    if (text == variants_place) return {0, std::string(text)};
    const std::size_t dot = text.find('.');
    OverridePlace place;
    std::from_chars(text.data(), text.data() + text.size(), place.question);
    if (dot != std::string_view::npos) place.item = text.substr(dot + 1);
    return place;
}

OverridePlace read_item_place(std::string_view text, const Graded& graded) {
    const OverridePlace place = read_place(text, graded);
    if (place.question != 0 && !place.item.empty()) return place;
    std::vector<std::string> items;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (place.question == 0 || place.question == question.number)
                items.push_back(to_string(OverridePlace{question.number, std::string(item.spec.name)}));
        }
    }
    throw UsageError(fmt::format("\"{}\" is not a single item; choose {}{}", escape_control(text),
                                 items.size() == 1 ? "" : "one, such as ", items.empty() ? "6.t" : items.front()));
}

double read_override_points(std::string_view text, const PlacePoints& there) {
    constexpr double most = 1e6;
    double points = -1;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), points);
    const bool is_number = error == std::errc{} && stop == text.data() + text.size();
    if (is_number && points >= 0 && points <= most) {
        for (const double exact : {there.most, there.automatic}) {
            if (fmt::format("{}", points) == points_text(exact)) return exact;
        }
        return std::abs(points);  // no -0
    }
    throw UsageError(fmt::format("\"{}\" is not a number of points; write a number from 0 to 1000000, e.g. 2.5",
                                 escape_control(text)));
}

std::string read_line(std::string_view text, std::string_view option) {
    constexpr std::size_t longest = 2000;
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) {
        throw UsageError(fmt::format("{} is empty; write it for whoever reads the gradebook later", option));
    }
    text = text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
    if (text.size() > longest) {
        throw UsageError(fmt::format("{} has {} bytes; shorten it to at most {}", option, text.size(), longest));
    }
    std::string line = escape_control(text);
    for (char& c : line) {
        if (c == '\n' || c == '\t') c = ' ';
    }
    return line;
}

}  // namespace harness
