#include "harness/experiment/identify/verdict.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "harness/match/label.h"
#include "harness/read/first_object.h"

namespace harness::experiment {
namespace {

using reference::FirstObject;
using reference::Subject;

using WordsOfObjects = std::map<Subject, std::set<std::string>>;

/// In lower case, without short words.
std::set<std::string> words_of(std::string_view text) {
    std::set<std::string> words;
    std::string word;
    for (const char c : std::string(text) + ' ') {
        if (is_letter(c)) {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        } else {
            constexpr std::size_t shortest = 3;
            if (word.size() >= shortest) words.insert(word);
            word.clear();
        }
    }
    return words;
}

/// The words that are printed with the items of one object and with no other item.
WordsOfObjects words_of_objects(const Slots& slots, const Claims& claims, const PrintedWords& words) {
    std::map<std::string, std::set<Subject>> used_with;
    for (const auto& [id, claim] : claims.all()) {
        const auto use = [&, subject = id.subject](std::string_view text) {
            for (const std::string& word : words_of(text)) used_with[word].insert(subject);
        };
        for (const std::size_t slot : claim.candidate.slots) {
            const int line = slots.numbers[slot].place.line;
            for (const LineOnScenes& on_scenes : slots.lines) {
                if (on_scenes.own.number == line || on_scenes.own.number + 1 == line) use(on_scenes.own.text);
            }
            if (const PrintedValue* value = words.value_at(slot)) use(value->above);
        }
    }
    WordsOfObjects objects;
    for (const auto& [word, subjects] : used_with) {
        const bool is_of_object = std::ranges::count(reference::objects, *subjects.begin()) > 0;
        if (subjects.size() == 1 && is_of_object) objects[*subjects.begin()].insert(word);
    }
    return objects;
}

std::optional<FirstObject> said_first(const PrintedLine& line, const WordsOfObjects& objects) {
    if (const auto first = read_first_object({line}, FirstObjectPlace::own_section)) return first->object;
    std::optional<Subject> said;
    for (const std::string& word : words_of(line.text)) {
        for (const auto& [object, words] : objects) {
            if (!words.contains(word)) continue;
            if (said && *said != object) return std::nullopt;
            said = object;
        }
    }
    return said ? std::optional(FirstObject(*said)) : std::nullopt;
}

/// The first object on each scene; empty if it is the same on all scenes.
std::vector<FirstObject> first_on_scenes(const reference::ItemSpec& item, std::span<const Observation> others) {
    std::vector<FirstObject> first;
    for (const Observation& other : others) {
        const reference::Answer& answer = reference::asked_item(other.key, item.id)->answers.front();
        first.push_back(std::get<FirstObject>(answer.value));
    }
    return std::ranges::count(first, first.front()) == std::ssize(first) ? std::vector<FirstObject>() : first;
}

}  // namespace

std::optional<ItemPlace> find_verdict(const reference::ItemSpec& item, const Slots& slots,
                                      std::span<const Observation> others, const Claims& claims,
                                      const PrintedWords& words) {
    const std::vector<FirstObject> truths = first_on_scenes(item, others);
    if (truths.empty()) return std::nullopt;
    const WordsOfObjects objects = words_of_objects(slots, claims, words);
    for (const bool in_own_section : {true, false}) {
        std::optional<ItemPlace> found;
        std::optional<bool> is_found_right;
        for (const LineOnScenes& line : slots.lines) {
            if (!line.words_change || (line.question == item.question) != in_own_section) continue;
            const auto own = said_first(line.own, objects);
            if (!own || says_no_answer(line.own.text)) continue;
            bool is_said = true, is_right = true;
            for (std::size_t scene = 0; scene < others.size(); ++scene) {
                const auto said = said_first(line.lines[scene], objects);
                is_said = is_said && said;
                is_right = is_right && said == truths[scene];
            }
            if (!is_said) continue;
            if (is_found_right && *is_found_right != is_right) return std::nullopt;
            is_found_right = is_right;
            found.emplace();
            found->first_line = found->last_line = line.own.number;
            found->first_object = own;
        }
        if (found) return found;
    }
    return std::nullopt;
}

}  // namespace harness::experiment
