#include "harness/match/match.h"

#include <re2/re2.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "harness/match/misses.h"
#include "harness/match/question_match.h"
#include "harness/read/alternatives.h"

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

/// Whether the last words of the section say that what follows is printed for comparison: "Expected output:".
bool announces_expected(const Section& section) {
    static const RE2 title(
        R"((?i)\W*(?:the\s+)?(?:expected|reference|sample|desired|example)\s*(?:output|answers?|results?|values?|solution)?\W*)");
    const auto words = std::find_if(section.lines.rbegin(), section.lines.rend(),
                                    [](const PrintedLine& line) { return !line.text.empty(); });
    return words != section.lines.rend() && RE2::FullMatch(words->text, title);
}

/// Whether a value that names one item is printed again under the same name, as by another printing.
bool repeats(const std::vector<PrintedValue>& values, const std::vector<PrintedValue>& part, const Question& question,
             Fits& fits) {
    constexpr std::size_t most = 32;  // a printing has no more answers to a question
    const auto first = [most](const std::vector<PrintedValue>& all) {
        return std::span(all).first(std::min(all.size(), most));
    };
    return std::ranges::any_of(first(values), [&](const PrintedValue& value) {
        const std::string& name = value.label.empty() ? value.above : value.label;
        const bool names_one_item = 1 == std::ranges::count_if(question.items, [&](const ItemSpec& item) {
                                        return has_shape(value, item) && fits(value, item) >= LabelFit::title;
                                    });
        return names_one_item && std::ranges::any_of(first(part), [&](const PrintedValue& earlier) {
                   return name == (earlier.label.empty() ? earlier.above : earlier.label) &&
                          earlier.numbers.size() == value.numbers.size();
               });
    });
}

/// For each section whether it is printed for comparison: from an announcement to where a question is printed again.
std::vector<bool> are_expected(const std::vector<Section>& sections) {
    std::vector<bool> expected;
    std::set<int> printed;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const bool begins = i > 0 && announces_expected(sections[i - 1]);
        const bool ends =
            !printed.insert(sections[i].question).second && sections[i - 1].question != sections[i].question;
        if (begins || ends) printed = {sections[i].question};
        expected.push_back(begins || (i > 0 && expected.back() && !ends));
    }
    return expected;
}

/// The values under a question's headings. Adjacent headings such as "6a" and "6b" form one part. If the program comes
/// back to the question later, as for another pixel, that is a new part. The first part counts most and comes last; one
/// that is printed for comparison counts least. `expected` says which sections are.
void collect_parts(Question& question, const std::vector<Section>& sections, const std::vector<bool>& expected,
                   Fits& fits) {
    std::vector<std::vector<PrintedValue>> for_comparison;
    std::vector<PrintedValue>* part = nullptr;  // of the section before, if it is of the question
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const Section& section = sections[i];
        if (section.question != question.number) {
            part = nullptr;
            continue;
        }
        question.has_heading = true;
        if (section.values.empty()) continue;
        if (part == nullptr || repeats(section.values, *part, question, fits))
            part = &(expected[i] ? for_comparison : question.parts).emplace_back();
        part->insert(part->end(), section.values.begin(), section.values.end());
    }
    question.parts.insert(question.parts.end(), for_comparison.begin(), for_comparison.end());
    std::ranges::reverse(question.parts);
}

/// Whether a value names an item of the question it was printed under. Such a value cannot answer another question.
bool names_own_item(const PrintedValue& value, const Question& owner, Fits& fits) {
    return std::any_of(owner.items.begin(), owner.items.end(), [&](const ItemSpec& item) {
        return has_shape(value, item) && fits(value, item) >= LabelFit::named;
    });
}

/// The values under the question's headings that may answer another question.
std::vector<PrintedValue> left_by(const Question& question, Fits& fits) {
    std::vector<PrintedValue> left = unused_values(question.parts, question.answers);
    std::erase_if(left, [&](const PrintedValue& value) { return names_own_item(value, question, fits); });
    return left;
}

/// Answers questions without a heading, only by labels. Returns the values that are left.
std::vector<PrintedValue> answer_together(std::span<Question> questions, const std::vector<PrintedValue>& values,
                                          Fits& fits) {
    std::vector<ItemSpec> items;
    for (const Question& question : questions) items.insert(items.end(), question.items.begin(), question.items.end());
    const Answers answers = answer_question(items, {&values, 1}, Need::label, fits);
    auto first = answers.candidate_of.begin();
    for (Question& question : questions) {
        const auto last = first + std::ssize(question.items);
        question.answers = {answers.candidates, {first, last}};
        first = last;
    }
    return unused_values({&values, 1}, answers);
}

/// Questions without a heading are answered by what is printed before the first heading, or is left of the question
/// before them.
void answer_all(std::vector<Question>& questions, const std::vector<Section>& sections, Fits& fits) {
    std::vector<PrintedValue> left = sections.front().values;
    const std::vector<bool> expected = are_expected(sections);
    for (Question& question : questions) collect_parts(question, sections, expected, fits);
    for (std::size_t i = 0, end = 0; i < questions.size(); i = end) {
        end = i + 1;
        if (Question& question = questions[i]; question.has_heading) {
            question.answers = answer_question(question.items, question.parts, Need::order_or_label, fits);
            left = left_by(question, fits);
            continue;
        }
        while (end < questions.size() && !questions[end].has_heading) ++end;
        left = answer_together(std::span(questions).subspan(i, end - i), left, fits);
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

/// Marks the item as unreadable if the lines of its value, or the one below them, offer other values.
void find_alternatives(MatchedItem& item, const std::vector<Section>& sections) {
    if (!item.value || item.value->numbers.empty()) return;
    constexpr int nearby_lines = 40;
    const bool is_one_number = item.spec.shape == Shape::scalar && item.spec.id.name != "t";  // there are two roots
    for (const Section& section : sections) {
        for (const PrintedLine& line : section.lines) {
            const bool is_own = item.value->line <= line.number && line.number <= item.value->last_line;
            const bool is_below = line.number == item.value->last_line + 1;
            const bool is_several =
                (is_own && (offers_several(line.text) || (is_one_number && gives_two_numbers(line.text)))) ||
                (is_below && is_alternative(line.text));
            const bool is_other_root = item.spec.id.name == "t" && section.question == item.spec.question &&
                                       std::abs(line.number - item.value->line) <= nearby_lines &&
                                       chooses_other_root(line.text);
            item.unreadable = item.unreadable || is_several;
            if (is_several || is_other_root) item.several_line = line.number;
        }
    }
}

/// The line where another part of the question begins with at least as many values as `part`; 0 if there is none.
int line_printed_again(const Question& question, std::size_t part) {
    for (std::size_t i = 0; i < question.parts.size(); ++i) {
        const std::vector<PrintedValue>& values = question.parts[i];
        if (i != part && values.size() >= question.parts[part].size()) return values.front().line;
    }
    return 0;
}

/// Finds the sentence about the first hit: under its heading; else any sentence with "first"; else, if the program
/// prints no headings, after all values.
std::optional<PrintedFirstObject> find_first_object(const std::vector<Section>& sections, int question) {
    int last_value = 0;
    for (const Section& section : sections) {
        for (const PrintedValue& value : section.values) last_value = std::max(last_value, value.line);
    }
    const bool has_headings = sections.size() > 1;
    std::vector<PrintedLine> own, all;
    for (const Section& section : sections) {
        for (const PrintedLine& line : section.lines) {
            all.push_back(line);
            if (has_headings ? section.question == question : line.number > last_value) own.push_back(line);
        }
    }
    const auto elsewhere = read_first_object(all, FirstObjectPlace::elsewhere);
    if (elsewhere && !has_headings) return elsewhere;
    const auto first = read_first_object(own, FirstObjectPlace::own_section);
    return first ? first : elsewhere;
}

std::vector<MatchedItem> matched_items(const Question& question, const std::vector<Section>& sections, Fits& fits) {
    std::vector<MatchedItem> matched;
    for (std::size_t i = 0; i < question.items.size(); ++i) {
        MatchedItem item{question.items[i]};
        if (question.answers.candidate_of[i]) {
            const Candidate& candidate = question.answers.candidates[*question.answers.candidate_of[i]];
            item.value = candidate.value;
            item.order = candidate.order;
            item.by_order = fits(candidate.value, item.spec) < LabelFit::title;
            item.again_line = line_printed_again(question, candidate.part);
        }
        find_alternatives(item, sections);
        if (item.spec.shape == Shape::first_object) item.first_object = find_first_object(sections, question.number);
        matched.push_back(std::move(item));
    }
    if (!question.has_heading) return matched;
    take_denials(matched, question.answers.candidates, fits);
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
            for (const ItemSpec& item : question.items) result.push_back({item});
        }
        return result;
    }
    answer_all(questions, transcript.sections, fits);
    for (const Question& question : questions) {
        for (MatchedItem& item : matched_items(question, transcript.sections, fits)) result.push_back(std::move(item));
    }
    const bool has_headings = std::ranges::any_of(questions, &Question::has_heading);
    settle_misses(result, [&](int number) {
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
