#include "harness/source/scene/stated_numbers.h"

#include <algorithm>
#include <map>

#include "harness/source/code/source_names.h"

namespace harness::source {
namespace {

/// A range of words [begin, end).
struct Range {
    std::size_t begin, end;
};

class Finder {
  public:
    explicit Finder(const std::vector<Word>& words) : words_(words), names_(words) {}

    SourceNumbers find() {
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (words_[i].kind == TokenKind::number) {
                if (const auto number = constant({i, i + 1})) found_.literals.push_back(*number);
            } else if (is(i, "=")) {
                assignment(i);
            } else if (is_opening(i)) {
                list(i);
            } else if (words_[i].kind == TokenKind::directive) {
                define(i);
            }
        }
        for (const std::size_t open : lists_) list_of_vectors(open);
        vectors_by_component();
        return std::move(found_);
    }

  private:
    bool is(std::size_t at, std::string_view text) const { return is_symbol(words_, at, text); }
    /// Whether a list may begin here: a bracket ( or { that has a partner.
    bool is_opening(std::size_t at) const { return (is(at, "(") || is(at, "{")) && words_[at].partner != nowhere; }

    std::optional<StatedNumber> constant(Range range) const {
        if (range.begin >= range.end) return {};
        const auto value = evaluate(std::span(words_).subspan(range.begin, range.end - range.begin));
        if (!value) return {};
        const Word& last = words_[range.end - 1];
        const auto certain = [&](const Word& word) { return word.certain; };
        return StatedNumber{*value, words_[range.begin].begin, last.begin + last.text.size(), last.in_define,
                            certain(words_[range.begin]) && certain(last)};
    }

    /// The place of the next comma from `begin` on outside of brackets; else `end`.
    std::size_t element_end(std::size_t begin, std::size_t end) const {
        std::size_t at = begin;
        while (at < end && !is(at, ",") && !is(at, ";")) {
            const bool skips = (is(at, "(") || is(at, "{") || is(at, "[")) && words_[at].partner != nowhere;
            at = skips ? words_[at].partner + 1 : at + 1;
        }
        return std::min(at, end);
    }

    std::vector<Range> elements(std::size_t begin, std::size_t end) const {
        std::vector<Range> ranges;
        for (std::size_t at = begin; at < end;) {
            const std::size_t stop = element_end(at, end);
            ranges.push_back({at, stop});
            at = stop + 1;
        }
        return ranges;
    }

    void assignment(std::size_t equals) {
        const std::string name = names_.left_of(equals);
        if (name.empty()) return;
        const std::size_t parent = words_[equals].parent;
        std::size_t limit = parent == nowhere ? words_.size() : words_[parent].partner;
        limit = std::min(limit == nowhere ? words_.size() : limit, equals + 64);
        const std::size_t end = element_end(equals + 1, limit);
        if (const auto number = constant({equals + 1, end})) found_.named.push_back({name, *number});
    }

    void define(std::size_t hash) {
        std::size_t end = hash;
        while (end < words_.size() && words_[end].kind != TokenKind::line_end) ++end;
        if (end - hash < 3 || !is_name(words_[hash + 1])) return;
        const std::string name(words_[hash + 1].text);
        const Range body{hash + 2, end};
        // A macro with parameters has its bracket directly after its name.
        if (is(body.begin, "(") && words_[body.begin].begin == words_[hash + 1].begin + name.size()) return;
        if (const auto number = constant(body)) {
            found_.named.push_back({name, *number});
            return;
        }
        const std::vector<Range> parts = elements(body.begin, body.end);
        if (parts.size() == 3) add_vectors(parts, {name, {}});
        const bool one_list = is(body.end - 1, ")") || is(body.end - 1, "}");
        if (one_list && words_[body.end - 1].partner != nowhere && parts.size() == 1)
            name_of_define_[words_[body.end - 1].partner] = name;
    }

    void list(std::size_t open) {
        const std::size_t close = words_[open].partner;
        if (names_.is_block(open)) return;
        const std::vector<Range> parts = elements(open + 1, close);
        if (parts.empty()) return;
        Naming naming_of_list = names_.of_list(open);
        if (const auto found = name_of_define_.find(open); found != name_of_define_.end())
            naming_of_list.name = found->second;
        const bool vectors = add_vectors(parts, naming_of_list, open);
        if (!vectors && parts.size() > 1) lists_.push_back(open);
    }

    /// Adds the vectors whose numbers are elements of the list. Returns whether there are any.
    bool add_vectors(const std::vector<Range>& parts, const Naming& naming_of_list, std::size_t open = nowhere) {
        constexpr std::size_t longest = 48;
        std::vector<StatedNumber> numbers;  // the numbers at the start of the list
        for (const Range& part : parts) {
            if (numbers.size() > longest) break;
            const auto number = constant(part);
            if (!number) break;
            numbers.push_back(*number);
        }
        if (numbers.size() == 1 && parts.size() == 1) {
            if (!naming_of_list.name.empty()) found_.named.push_back({naming_of_list.name, numbers[0]});
            const double x = numbers[0].constant.value;
            add({{x, x, x}, numbers, {}, naming_of_list.name, naming_of_list.callee, false}, open);
            return false;
        }
        if (numbers.size() < 3) return false;
        const bool chunks = numbers.size() == parts.size() && parts.size() % 3 == 0 && parts.size() > 3;
        StatedList chunked{naming_of_list.callee, naming_of_list.name, {}};
        for (std::size_t i = 0; i + 3 <= (chunks ? numbers.size() : 3); i += 3) {
            StatedVector vector;
            for (std::size_t k = 0; k < 3; ++k) {
                vector.value.at(k) = numbers[i + k].constant.value;
                vector.numbers.push_back(numbers[i + k]);
            }
            constexpr std::size_t most_following = 3;
            for (std::size_t k = 3; !chunks && k < std::min(numbers.size(), 3 + most_following); ++k)
                vector.following.push_back(numbers[k]);
            vector.name = naming_of_list.name;
            vector.callee = naming_of_list.callee;
            vector.weak = parts.size() != 3;
            if (chunks) chunked.elements.push_back({found_.vectors.size(), {}});
            add(std::move(vector), open);
        }
        if (chunks) found_.lists.push_back(std::move(chunked));
        return true;
    }

    void add(StatedVector vector, std::size_t open) {
        if (open != nowhere) vector_at_.try_emplace(open, found_.vectors.size());
        found_.vectors.push_back(std::move(vector));
    }

    /// Adds a list with vectors among its elements, as in Camera({0, 0, 4}, vec3(0), up).
    void list_of_vectors(std::size_t open) {
        Naming naming = names_.of_list(open);
        StatedList result{naming.callee, std::move(naming.name), {}};
        bool any = false;
        for (const Range& part : elements(open + 1, words_[open].partner)) {
            ListElement element;
            element.number = constant(part);
            const std::size_t last = part.end - 1;
            if (part.end > part.begin && words_[last].partner != nowhere && words_[last].partner >= part.begin &&
                words_[last].partner - part.begin <= 4) {
                if (const auto found = vector_at_.find(words_[last].partner); found != vector_at_.end()) {
                    element.vector = found->second;
                    any = true;
                }
            }
            result.elements.push_back(std::move(element));
        }
        if (any) found_.lists.push_back(std::move(result));
    }

    /// Splits "eyeX", "eye_x", "eye.x" or "eye[0]" into the name "eye" and the component.
    static std::optional<std::pair<std::string, std::size_t>> component_of(const std::string& name) {
        std::string stem = name;
        char axis = stem.back();
        if (axis == ']' && stem.size() > 3) {
            axis = stem[stem.size() - 2];
            stem.resize(stem.size() - 3);
            if (axis < '0' || axis > '2') return {};
        } else {
            stem.pop_back();
        }
        while (!stem.empty() && (stem.back() == '_' || stem.back() == '.')) stem.pop_back();
        if (stem.empty()) return {};
        switch (axis) {
            case 'x':
            case 'X':
            case '0': return {{stem, 0}};
            case 'y':
            case 'Y':
            case '1': return {{stem, 1}};
            case 'z':
            case 'Z':
            case '2': return {{stem, 2}};
            default: return {};
        }
    }

    /// Adds vectors that are stated component by component, each component once.
    void vectors_by_component() {
        std::map<std::string, std::array<std::vector<std::size_t>, 3>> stems;
        for (std::size_t i = 0; i < found_.named.size(); ++i) {
            if (const auto component = component_of(found_.named[i].name))
                stems[component->first].at(component->second).push_back(i);
        }
        for (const auto& [stem, places] : stems) {
            const bool each_once =
                std::all_of(places.begin(), places.end(), [](const auto& p) { return p.size() == 1; });
            if (!each_once) continue;
            StatedVector vector;
            for (std::size_t k = 0; k < 3; ++k) {
                const StatedNumber& number = found_.named[places.at(k).front()].number;
                vector.value.at(k) = number.constant.value;
                vector.numbers.push_back(number);
            }
            vector.name = stem;
            found_.vectors.push_back(std::move(vector));
        }
    }

    const std::vector<Word>& words_;
    SourceNames names_;
    SourceNumbers found_;
    std::vector<std::size_t> lists_;                     ///< the opening brackets of lists that may hold vectors
    std::map<std::size_t, std::size_t> vector_at_;       ///< by opening bracket
    std::map<std::size_t, std::string> name_of_define_;  ///< #define EYE vec3(0, 0, 4), by opening bracket
};

}  // namespace

std::vector<StatedNumber> StatedList::numbers_from(std::size_t first) const {
    std::vector<StatedNumber> numbers;
    for (std::size_t i = first; i < elements.size() && elements[i].number; ++i) numbers.push_back(*elements[i].number);
    return numbers;
}

SourceNumbers stated_numbers(const std::vector<Word>& words) {
    return Finder(words).find();
}

}  // namespace harness::source
