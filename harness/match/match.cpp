#include "harness/match/match.h"

#include <re2/re2.h>

#include <algorithm>
#include <set>

#include "harness/match/misses.h"
#include "harness/match/object_titles.h"
#include "harness/match/question_match.h"
#include "harness/match/without_headings.h"

namespace harness {
namespace {

using reference::ItemSpec;
using reference::Shape;

/// What was printed under the headings of one question.
struct Question {
    int number = 0;
    std::vector<ItemSpec> items;
    bool has_heading = false;
    std::vector<std::vector<PrintedValue>> parts;  ///< one part for each time the program came to the question
    Answers answers;
};

/// Items that were read from their places, in the order of all items; empty for an item that is to be matched.
using PlacedItems = std::vector<std::optional<MatchedItem>>;

/// The questions with the items to be matched. A question without any is listed too: other answers may stand under its
/// heading.
std::vector<Question> list_questions(std::span<const ItemSpec> items, const PlacedItems& placed) {
    std::vector<Question> questions;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (questions.empty() || questions.back().number != items[i].question)
            questions.push_back({items[i].question, {}, false, {}, {}});
        if (!placed[i]) questions.back().items.push_back(items[i]);
    }
    return questions;
}

/// Whether the words behind the section's last value say that what follows corrects it.
bool announces_correction(const Section& section) {
    static const RE2 words(
        R"((?i)\b(?:again|oops|correct(?:ed|ion)?|fix(?:ed)?|wrong|mistake|instead|actually|redo(?:ne)?|improved|final)\b)");
    const int last = section.values.empty() ? 0 : section.values.back().last_line;
    return std::any_of(section.lines.begin(), section.lines.end(), [&](const PrintedLine& line) {
        return line.number > last && RE2::PartialMatch(line.text, words);
    });
}

/// Whether the last words of the section say that what follows is printed for comparison: "Expected output:".
bool announces_expected(const Section& section) {
    static const RE2 title(
        R"((?i)\W*(?:the\s+)?(?:expected|reference|sample|desired|example)\s*(?:output|answers?|results?|values?|solution)?\W*)");
    const auto words = std::find_if(section.lines.rbegin(), section.lines.rend(),
                                    [](const PrintedLine& line) { return !line.text.empty(); });
    return words != section.lines.rend() && RE2::FullMatch(words->text, title);
}

/// Whether two sections one behind the other belong to one printing, as "6a" and "6b" do. An item that is printed by
/// the same name in both means another printing.
bool goes_on_in(const Section& before, const Section& section, Fits& fits) {
    if (before.question != section.question) return false;
    const auto name_of = [](const PrintedValue& value) {
        return !value.label.empty() ? value.label : !value.after.empty() ? value.after : value.above;
    };
    const auto names_one_item = [&](const PrintedValue& value) {  // not the t of two objects
        const auto items = fits.asked();
        const auto is_named = [&](const ItemSpec& item) {
            return item.question == section.question && has_shape(value, item) && fits(value, item) >= LabelFit::title;
        };
        return std::count_if(items.begin(), items.end(), is_named) == 1;
    };
    constexpr std::size_t most = 32;  // a printing has no more answers to a question
    const auto first = [&](const Section& each) {
        return std::span(each.values).first(std::min(each.values.size(), most));
    };
    for (const PrintedValue& value : first(section)) {
        if (name_of(value).empty() || !names_one_item(value)) continue;
        for (const PrintedValue& earlier : first(before)) {
            if (name_of(earlier) == name_of(value) && earlier.numbers.size() == value.numbers.size()) return false;
        }
    }
    return true;
}

/// Where a section stands when the program printed questions more than once.
struct Place {
    int rank;      ///< the first printing counts more than later ones, e.g. of another pixel, but less than corrections
    bool goes_on;  ///< with the section before it
};

std::vector<Place> places_of(const std::vector<Section>& sections, Fits& fits) {
    std::vector<Place> places;
    std::set<int> printed;  ///< in this printing
    int rank = 0, highest = 0, lowest = 0;
    constexpr int for_comparison = -1'000'000;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const bool goes_on = i > 0 && goes_on_in(sections[i - 1], sections[i], fits);
        if (!goes_on && !printed.insert(sections[i].question).second) {
            printed = {sections[i].question};
            rank = announces_correction(sections[i - 1]) ? ++highest : --lowest;
        }
        if (!goes_on && i > 0 && announces_expected(sections[i - 1])) rank = for_comparison;
        places.push_back({rank, goes_on});
    }
    return places;
}

/// The values under a question's headings. Consecutive "6a" and "6b" form one part. If the program comes back to the
/// question later, that is a new part. The part that counts most comes last.
void collect_parts(Question& question, const std::vector<Section>& sections, const std::vector<Place>& places) {
    std::vector<std::pair<int, std::vector<PrintedValue>>> parts;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (sections[i].question == question.number) {
            question.has_heading = true;
            if (!places[i].goes_on) parts.emplace_back(places[i].rank, std::vector<PrintedValue>());
            std::vector<PrintedValue>& part = parts.back().second;
            const auto objects = asks_the_same_of_several(question.items)
                                     ? titled_objects(sections[i])
                                     : std::vector<std::optional<reference::Subject>>();
            for (std::size_t k = 0; k < sections[i].values.size(); ++k) {
                part.push_back(sections[i].values[k]);
                if (!objects.empty()) part.back().object = objects[k];
            }
        }
    }
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [rank, values] : parts) question.parts.push_back(std::move(values));
}

/// Whether a value names an item of the question it was printed under. Such a value cannot answer another question.
bool names_own_item(const PrintedValue& value, const Question& owner, Fits& fits) {
    return std::any_of(owner.items.begin(), owner.items.end(), [&](const ItemSpec& item) {
        return has_shape(value, item) && fits(value, item) >= LabelFit::named;
    });
}

/// Answers the questions without a heading that follow `leader`, which has a heading. Only labelled values can answer
/// them.
void answer_behind(const Question& leader, std::span<Question> questions, Fits& fits) {
    std::vector<PrintedValue> left = unused_values(leader.parts, leader.answers);
    std::erase_if(left, [&](const PrintedValue& value) { return names_own_item(value, leader, fits); });
    for (Question& question : questions) {
        question.answers = answer_question(question.items, {&left, 1}, Need::label, fits);
        left = unused_values({&left, 1}, question.answers);
    }
}

/// Answers the questions before the first question with a heading, or all questions if there is no heading.
void answer_first(const Section& section, std::span<Question> questions, Fits& fits) {
    std::vector<std::vector<ItemSpec>> items;
    for (const Question& question : questions) items.push_back(question.items);
    std::vector<Answers> answers = answer_unheaded(items, section, fits);
    for (std::size_t i = 0; i < questions.size(); ++i) questions[i].answers = std::move(answers[i]);
}

void answer_all(std::vector<Question>& questions, const std::vector<Section>& sections, Fits& fits) {
    const std::vector<Place> places = places_of(sections, fits);
    for (Question& question : questions) {
        collect_parts(question, sections, places);
        if (question.has_heading)
            question.answers = answer_question(question.items, question.parts, Need::order_or_label, fits);
    }
    for (std::size_t i = 0; i < questions.size();) {
        std::size_t end = i;
        while (end < questions.size() && !questions[end].has_heading) ++end;
        const std::span<Question> homeless(questions.data() + i, end - i);
        if (!homeless.empty() && i == 0) answer_first(sections.front(), homeless, fits);
        if (!homeless.empty() && i > 0) answer_behind(questions[i - 1], homeless, fits);
        i = end + 1;
    }
}

/// Marks the item as unreadable if its label stands before a value of another shape.
void find_unreadable(MatchedItem& item, const Answers& answers, Fits& fits) {
    if (item.value || item.spec.shape == Shape::first_object) return;
    for (const Candidate& candidate : answers.candidates) {
        const PrintedValue& value = candidate.value;
        if (value.label.empty() || value.numbers.empty() || has_shape(value, item.spec)) continue;
        if (fits(value, item.spec) != LabelFit::exact) continue;
        item.value = value;
        item.unreadable = true;
    }
}

/// Whether the line announces the answer about the first hit, "Winner: triangle (t = 0)", "The smaller t belongs to …".
bool announces_first_object(const std::string& line) {
    static const RE2 pattern(
        R"((?i)\W*(?:(?:so|thus|hence|therefore)\W+)?(?:the\s+)?(?:winner|closest|nearest|visible|verdict|small(?:er|est)|conclusion|result|answer)\b.*)");
    return RE2::FullMatch(line, pattern);
}

/// Finds the sentence about the first hit: under its heading; else any sentence with "first"; else, if the program
/// prints no headings, after all values or where it is announced.
std::optional<PrintedFirstObject> find_first_object(const std::vector<Section>& sections, int question) {
    int last_value = 0;
    for (const Section& section : sections) {
        for (const PrintedValue& value : section.values) last_value = std::max(last_value, value.line);
    }
    std::vector<PrintedLine> own, all, last, announced;
    for (const Section& section : sections) {
        all.insert(all.end(), section.lines.begin(), section.lines.end());
        if (section.question == question) own.insert(own.end(), section.lines.begin(), section.lines.end());
        if (sections.size() > 1) continue;
        std::copy_if(section.lines.begin(), section.lines.end(), std::back_inserter(last),
                     [&](const PrintedLine& line) { return line.number > last_value; });
        std::ranges::copy_if(section.lines, std::back_inserter(announced),
                             [](const PrintedLine& line) { return announces_first_object(line.text); });
    }
    if (auto first = read_first_object(own, FirstObjectPlace::own_section)) return first;
    if (auto first = read_first_object(all, FirstObjectPlace::elsewhere)) return first;
    if (auto first = read_first_object(last, FirstObjectPlace::own_section)) return first;
    return read_first_object(announced, FirstObjectPlace::own_section);
}

std::vector<MatchedItem> matched_items(const Question& question, const std::vector<Section>& sections, Fits& fits) {
    std::vector<MatchedItem> matched;
    for (std::size_t i = 0; i < question.items.size(); ++i) {
        MatchedItem item{question.items[i], {}, MatrixOrder::unsaid, {}, false, {}};
        if (question.answers.candidate_of[i]) {
            const Candidate& candidate = question.answers.candidates[*question.answers.candidate_of[i]];
            item.value = candidate.value;
            item.order = candidate.order;
            item.by_order = fits(candidate.value, item.spec) < LabelFit::title;
        }
        if (item.spec.shape == Shape::first_object) item.first_object = find_first_object(sections, question.number);
        matched.push_back(std::move(item));
    }
    if (!question.has_heading) return matched;
    settle_misses(matched, question.answers.candidates, fits);
    for (MatchedItem& item : matched) find_unreadable(item, question.answers, fits);
    return matched;
}

/// The items that have no place, matched with the transcript.
std::vector<MatchedItem> match_others(const Transcript& transcript, std::span<const ItemSpec> items,
                                      const PlacedItems& placed) {
    Fits fits(items);
    std::vector<Question> questions = list_questions(items, placed);
    std::vector<MatchedItem> result;
    if (transcript.sections.empty()) {
        for (const Question& question : questions) {
            for (const ItemSpec& item : question.items)
                result.push_back({item, {}, MatrixOrder::unsaid, {}, false, {}});
        }
        return result;
    }
    answer_all(questions, transcript.sections, fits);
    for (const Question& question : questions) {
        for (MatchedItem& item : matched_items(question, transcript.sections, fits)) result.push_back(std::move(item));
    }
    const bool has_headings = std::ranges::any_of(questions, &Question::has_heading);
    settle_misses_between_questions(result, [&](int number) {
        return !has_headings || std::ranges::any_of(questions, [&](const Question& question) {
            return question.number == number && question.has_heading;
        });
    });
    return result;
}

}  // namespace

std::vector<MatchedItem> match(const Transcript& transcript, std::span<const ItemSpec> items,
                               std::span<const ItemPlace> places) {
    PlacedItems placed(items.size());
    if (places.empty()) return match_others(transcript, items, placed);
    std::vector<const ItemPlace*> place_of(items.size(), nullptr);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto place = std::ranges::find_if(places, [&](const ItemPlace& given) {
            return given.question == items[i].question && given.item == items[i].name;
        });
        if (place != places.end()) place_of[i] = &*place;
    }
    Transcript rest = transcript;
    const std::vector<MatchedItem> as_read = match_others(transcript, items, placed);
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (place_of[i] == nullptr || !place_of[i]->as_read) continue;
        placed[i] = as_read[i];
        placed[i]->place_note = place_of[i]->note;
        placed[i]->by_experiment = place_of[i]->by_experiment;
        take_value(rest, *placed[i], items);
    }
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (place_of[i] != nullptr && !place_of[i]->as_read) placed[i] = read_at(rest, items[i], *place_of[i], items);
    }
    std::vector<MatchedItem> matched = match_others(rest, items, placed), result;
    auto next = matched.begin();
    for (std::optional<MatchedItem>& item : placed) result.push_back(item ? std::move(*item) : std::move(*next++));
    return result;
}

}  // namespace harness
