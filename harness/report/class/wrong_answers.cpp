#include "harness/report/class/wrong_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <tuple>

#include "harness/report/class/statistics.h"
#include "harness/report/text/sentences.h"

namespace harness::report {
namespace {

/// The numbers of "vec3(1.0, -0.50000, 2)" are 1, -0.5 and 2: a digit inside a name does not start a number.
std::string numbers_of(std::string_view printed) {
    std::string numbers;
    char before = ' ';
    while (!printed.empty()) {
        double value = 0;
        const bool continues_a_name = std::isalnum(static_cast<unsigned char>(before)) != 0 || before == '_';
        const auto [end, error] = std::from_chars(printed.data(), printed.data() + printed.size(), value);
        const bool is_digit_or_sign = std::string_view("+-.0123456789").find(printed.front()) != std::string_view::npos;
        if (!continues_a_name && is_digit_or_sign && error == std::errc()) {
            numbers += fmt::format("{:.4g} ", value == 0 ? 0.0 : value);
            before = ' ';
            printed.remove_prefix(static_cast<std::size_t>(end - printed.data()));
        } else {
            before = printed.front();
            printed.remove_prefix(1);
        }
    }
    return numbers;
}

std::string words_of(std::string_view printed) {
    std::string words;
    for (const char c : printed) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) != 0) {
            words += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
        } else if (!words.empty() && words.back() != ' ') {
            words += ' ';
        }
    }
    if (words.ends_with(' ')) words.pop_back();
    return words;
}

bool has_mistake(const ItemScore& item) {
    return item.verdict != ItemVerdict::right && item.verdict != ItemVerdict::follow;
}

bool is_missing_as_a_whole(const QuestionScore& question) {
    return question.items.size() > 1 &&
           std::all_of(question.items.begin(), question.items.end(),
                       [](const ItemScore& item) { return item.verdict == ItemVerdict::missing; });
}

bool only_follows(const QuestionScore& question) {
    return question.verdict == ItemVerdict::follow;
}

/// The item's place in its question, verdict, diagnosis and gist. A question without answers comes before all items.
using Gist = std::tuple<std::size_t, ItemVerdict, std::string, std::string>;
using Gathered = std::map<Gist, WrongAnswer>;

void gather(Gathered& gathered, const Graded& graded, const QuestionScore& question, std::size_t who) {
    if (is_missing_as_a_whole(question)) {
        const bool cut_short = was_cut_short(graded.execution.outcome);
        WrongAnswer& answer = gathered[{0, ItemVerdict::missing, "", cut_short ? "cut short" : ""}];
        answer.sentence = cut_short ? "The program ended before it printed them." : "Not found in the output.";
        answer.spec = question.items.front().spec;
        answer.verdict = ItemVerdict::missing;
        answer.whole_question = true;
        answer.who.push_back(who);
        return;
    }
    for (std::size_t i = 0; i < question.items.size(); ++i) {
        const ItemScore& item = question.items[i];
        if (!has_mistake(item)) continue;
        const bool cut_short = item.verdict == ItemVerdict::missing && was_cut_short(graded.execution.outcome);
        const std::string gist = cut_short ? "cut short" : item.diagnosis.empty() ? gist_of(item.printed) : "";
        WrongAnswer& answer = gathered[{i + 1, item.verdict, item.diagnosis, gist}];
        if (answer.who.empty()) {
            answer.spec = item.spec;
            answer.verdict = item.verdict;
            answer.diagnosis = item.diagnosis;
            answer.sentence = item_sentence(item, graded.execution.outcome);
            answer.printed = item.printed;
        }
        answer.who.push_back(who);
    }
}

/// Wrong answers without a diagnosis that only one student has become one entry per item, because a list of them is not
/// useful.
std::vector<WrongAnswer> arrange(Gathered gathered) {
    std::vector<WrongAnswer> shared;
    std::map<std::size_t, WrongAnswer> alone;
    for (auto& [gist, answer] : gathered) {
        const bool differs = answer.who.size() == 1 && answer.diagnosis.empty() && !answer.printed.empty();
        if (!differs) {
            shared.push_back(std::move(answer));
            continue;
        }
        WrongAnswer& others = alone[std::get<0>(gist)];
        if (others.who.empty()) {
            others = std::move(answer);
            continue;
        }
        others.differing = true;
        others.verdict = ItemVerdict::wrong;
        others.sentence.clear();
        others.printed.clear();
        others.who.push_back(answer.who.front());
    }
    std::stable_sort(shared.begin(), shared.end(),
                     [](const WrongAnswer& a, const WrongAnswer& b) { return a.who.size() > b.who.size(); });
    for (auto& [place, answer] : alone) {
        std::sort(answer.who.begin(), answer.who.end());
        shared.push_back(std::move(answer));
    }
    return shared;
}

}  // namespace

std::string gist_of(std::string_view printed) {
    const std::string numbers = numbers_of(printed);
    return numbers.empty() ? words_of(printed) : numbers;
}

std::vector<QuestionMistakes> mistakes_by_question(const std::vector<Graded>& graded) {
    std::map<int, Gathered> gathered;
    std::map<int, std::size_t> following;
    std::map<int, std::string> titles;
    for (std::size_t i = 0; i < graded.size(); ++i) {
        if (!has_answers(graded[i])) continue;
        for (const QuestionScore& question : graded[i].score.questions) {
            gather(gathered[question.number], graded[i], question, i);
            titles[question.number] = question.title;
            following[question.number] += only_follows(question) ? 1 : 0;
        }
    }
    std::vector<QuestionMistakes> mistakes;
    for (auto& [question, answers] : gathered)
        mistakes.push_back({question, titles[question], arrange(std::move(answers)), following[question]});
    return mistakes;
}

}  // namespace harness::report
