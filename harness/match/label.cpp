#include "harness/match/label.h"

#include <re2/re2.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "harness/match/vocabulary.h"

namespace harness {
namespace {

using reference::ItemSpec;

/// A label's words in lower case, split at everything but letters, digits and "'".
class Words {
  public:
    void begin_word() { starts_.push_back(letters_.size()); }
    void add(char c) { letters_ += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

    std::size_t size() const { return starts_.size(); }
    bool empty() const { return starts_.empty(); }
    std::string_view operator[](std::size_t i) const { return joined(i, i + 1); }
    /// The words [first, last), joined without blanks.
    std::string_view joined(std::size_t first, std::size_t last) const {
        const std::size_t end = last < starts_.size() ? starts_[last] : letters_.size();
        return std::string_view(letters_).substr(starts_[first], end - starts_[first]);
    }
    std::string_view joined() const { return letters_; }

    bool formula = false;  ///< holds an operator: names in it are operands

  private:
    std::string letters_;
    std::vector<std::size_t> starts_;  ///< of each word in letters_
};

bool is_word_char(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '\'' ||
           static_cast<unsigned char>(c) >= 0x80;
}

Words split_words(std::string_view label) {
    Words words;
    bool in_word = false;
    for (std::size_t i = 0; i < label.size(); ++i) {
        const char c = label[i];
        if (is_word_char(c)) {
            if (!in_word) words.begin_word();
            words.add(c);
            in_word = true;
            continue;
        }
        constexpr std::string_view inverse = "^-1";
        if (in_word && label.substr(i).starts_with(inverse)) {  // "M^-1" is called Minv as well
            for (const char letter : std::string_view("inv")) words.add(letter);
            i += inverse.size() - 1;
            continue;
        }
        in_word = false;
        if (words.empty()) continue;  // a bullet
        const bool spaced = i > 0 && i + 1 < label.size() && label[i - 1] == ' ' && label[i + 1] == ' ';
        const bool operands = i > 0 && i + 1 < label.size() && (i < 2 || !is_word_char(label[i - 2])) &&
                              is_word_char(label[i - 1]) && (i + 2 >= label.size() || !is_word_char(label[i + 2]));
        if (c == '*' || c == '/' || c == '^' || c == '+' || (c == '-' && (spaced || operands))) words.formula = true;
    }
    static const RE2 product(R"((?i)\b(?:v?up|[a-z]\d?)\s+x\s+(?:v?up|[a-z]\d?)\b|\b(?:cross|dot|sqrt)\s*\()");
    words.formula = words.formula || RE2::PartialMatch(re2::StringPiece(label.data(), label.size()), product);
    return words;
}

bool contains(const auto& list, const auto& element) {
    return std::find(list.begin(), list.end(), element) != list.end();
}

/// Which words belong to a run whose letters, joined, are one of `names`.
std::vector<bool> covered_by(const Words& words, const Vocabulary& names) {
    constexpr std::size_t longest_run = 5;
    std::vector<bool> covered(words.size(), false);
    for (std::size_t first = 0; first < words.size(); ++first) {
        for (std::size_t last = first + 1; last <= words.size() && last - first <= longest_run; ++last) {
            if (!names.contains(words.joined(first, last))) continue;
            std::fill(covered.begin() + static_cast<std::ptrdiff_t>(first),
                      covered.begin() + static_cast<std::ptrdiff_t>(last), true);
        }
    }
    return covered;
}

bool says_no_answer(const Words& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        // "Gaussian elimination, augmented matrix:" and "before elimination" head the system itself.
        const bool heads_system = words[i] == "elimination" && (i == 0 || words[i - 1] == "gaussian" ||
                                                                words[i - 1] == "gauss" || words[i - 1] == "before");
        const bool is_before_it = words[i] == "before" && i + 1 < words.size() && words[i + 1] == "elimination";
        if (heads_system || is_before_it) continue;
        if (not_an_answer().contains(words[i])) return true;
        if (words[i] == "no" && i + 2 < words.size() && words[i + 1] == "hit" && words[i + 2] == "at") return true;
        const bool negated = words[i] == "not" || words[i] == "un" || words[i] == "non";
        if (negated && i + 1 < words.size() && words[i + 1].starts_with("normali")) return true;
    }
    return false;
}

/// Whether the label names a number that the scene gives, which is no answer: "R = 2". A vector r is no radius.
bool is_of_the_scene(const Words& words, const ItemSpec& item) {
    const bool is_vector = item.shape == reference::Shape::vector;
    return given_by_the_scene().contains(words.joined()) && !(is_vector && words.joined() == "r");
}

/// Whether the label is of an inverse: that of the view matrix is what the view matrix is not.
bool is_inverse(const Words& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].starts_with("inv")) return true;
    }
    return false;
}

bool says_little(std::string_view word) {
    return word.empty() || fillers().contains(word) || choices().contains(word);
}

/// "so we take"
bool is_choice(const Words& words) {
    bool chooses = false;
    if (words.size() < 2) return false;  // "used 3 multiplications"
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!says_little(words[i])) return false;
        chooses = chooses || choices().contains(words[i]);
    }
    return chooses;
}

LabelFit fit_words(const Words& words, const ItemSpec& item) {
    if (words.empty()) return LabelFit::none;
    if (is_choice(words)) return item.id.name == "t" ? LabelFit::exact : LabelFit::foreign;
    const Names& names = names_of(item);
    if (!is_inverse(words) && contains(covered_by(words, names.never), true)) return LabelFit::foreign;
    if (names.names.contains(words.joined())) return LabelFit::exact;
    const bool is_weak = names.weak.contains(words.joined());
    if (is_weak && !words.formula) return LabelFit::weak;
    if (words.formula) return is_weak ? LabelFit::weak : LabelFit::foreign;
    std::vector<bool> covered = covered_by(words, names.names);
    if (!contains(covered, true)) {
        return contains(covered_by(words, names.weak), true) ? LabelFit::weak : LabelFit::foreign;
    }
    for (std::size_t i = 0; i < covered.size(); ++i) covered[i] = covered[i] || says_little(words[i]);
    return contains(covered, false) ? LabelFit::named : LabelFit::exact;
}

/// "Discriminant" of "Discriminant (b^2 - 4ac)": a formula in brackets behind a name is a remark.
std::string_view without_formula(std::string_view label) {
    const std::size_t open = label.find('(');
    const std::size_t close = label.rfind(')');
    const bool is_behind = open != std::string_view::npos && open > 0 && close != std::string_view::npos &&
                           says_little(label.substr(std::min(label.find_first_not_of(' ', close + 1), label.size())));
    return is_behind && label.find_first_of("+-*/^", open) != label.npos ? label.substr(0, open) : label;
}

}  // namespace

LabelFit fit_label(std::string_view label, std::string_view above, const ItemSpec& item) {
    const Words words = split_words(without_formula(label));
    if (says_no_answer(words) || is_of_the_scene(words, item)) return LabelFit::forbidden;
    if (!words.empty()) return fit_words(words, item);
    const Words title = split_words(above);
    if (!title.empty() && title[title.size() - 1] == "of") return LabelFit::none;  // "inverse of" above the view matrix
    if (title.empty()) return LabelFit::none;
    if (says_no_answer(title)) return LabelFit::forbidden;
    const LabelFit fit = fit_words(title, item);
    if (fit == LabelFit::exact) return LabelFit::exact;
    return fit == LabelFit::named ? LabelFit::title : LabelFit::none;
}

bool says_no_answer(std::string_view text) {
    return says_no_answer(split_words(text));
}

std::vector<std::size_t> listed_items(std::string_view label, std::span<const ItemSpec> items) {
    std::vector<std::size_t> listed;
    const Words words = split_words(label);
    if (says_no_answer(words)) return {};
    const auto lists = [&](std::string_view name) {
        const auto item =
            std::ranges::find_if(items, [&](const ItemSpec& spec) { return names_of(spec).names.contains(name); });
        if (item != items.end()) listed.push_back(static_cast<std::size_t>(item - items.begin()));
        return item != items.end();
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::size_t before = listed.size();
        const std::string_view word = words[i];
        if (lists(word) || fillers().contains(word)) continue;
        bool is_run = true;  // "abc"
        for (std::size_t k = 0; k < word.size() && is_run; ++k) is_run = lists(word.substr(k, 1));
        if (is_run) continue;
        listed.resize(before);
        if (!listed.empty()) return {};  // else it stands before the list: "coefficients a, b and c"
    }
    const std::set<std::size_t> distinct(listed.begin(), listed.end());
    return listed.size() >= 2 && distinct.size() == listed.size() ? listed : std::vector<std::size_t>();
}

LabelFit fit_value(const PrintedValue& value, const ItemSpec& item, std::span<const ItemSpec> asked) {
    if (!value.label.empty() || value.after.empty()) return fit_label(value.label, value.above, item);
    const LabelFit behind = fit_label(value.after, "", item);
    if (behind == LabelFit::forbidden || behind >= LabelFit::named) return behind;
    const bool names_another = std::any_of(asked.begin(), asked.end(), [&](const ItemSpec& other) {
        return other.question == item.question && fit_label(value.after, "", other) >= LabelFit::named;
    });
    return names_another
               ? LabelFit::foreign
               : std::max(fit_label("", value.above, item), behind == LabelFit::weak ? behind : LabelFit::none);
}

}  // namespace harness
