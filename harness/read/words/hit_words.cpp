#include "harness/read/words/hit_words.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "harness/read/words/hit_words_table.h"
#include "harness/text/plain_word.h"
#include "harness/text/utf8.h"

namespace harness {
namespace {

constexpr std::size_t longest_line = 1000;
/// Shorter words are too often other words with one letter exchanged.
constexpr std::size_t shortest_misspelt = 6;

struct Lexicon {
    std::unordered_map<std::string_view, Meaning> meanings;
    std::array<std::vector<std::string_view>, 26> long_words;  ///< with their first letter

    Lexicon() {
        for (const MeaningRow& row : hit_words_table()) {
            for (std::string_view words :
                 {row.english, row.german, row.french, row.spanish, row.italian, row.portuguese, row.others})
                add(words, row.meaning);
        }
    }

  private:
    void add(std::string_view words, Meaning meaning) {
        while (!words.empty()) {
            const std::string_view word = words.substr(0, words.find(' '));
            words.remove_prefix(std::min(words.size(), word.size() + 1));
            if (meanings.try_emplace(word, meaning).second && word.size() >= shortest_misspelt)
                long_words.at(static_cast<std::size_t>(word.front() - 'a')).push_back(word);
        }
    }
};

const Lexicon& lexicon() {
    static const Lexicon all;
    return all;
}

/// Whether a misspelt word may mean this. Small words of order resemble others: "closed" is not "closer".
bool may_be_misspelt(Meaning meaning) {
    switch (meaning) {
        case Meaning::sphere:
        case Meaning::triangle:
        case Meaning::cylinder:
        case Meaning::hit:
        case Meaning::miss:
        case Meaning::none:
        case Meaning::nearest:
        case Meaning::discriminant: return true;
        default: return false;
    }
}

class Splitter {
  public:
    explicit Splitter(std::string_view line) : line_(line.substr(0, longest_line)) {}

    std::vector<HitWord> run() {
        while (at_ < line_.size()) step();
        return std::move(words_);
    }

  private:
    struct Letter {
        char plain;
        std::size_t bytes;
    };
    Letter letter_at(std::size_t at) const {
        if (at >= line_.size()) return {'\0', 0};
        const Decoded decoded = decode(line_.substr(at));
        return {plain_letter(decoded.code), decoded.bytes};
    }

    /// Whether a word of a name in camelCase starts here, in a longer name.
    bool is_hump(std::size_t at) const {
        const auto is_capital = [&](std::size_t i) { return line_[i] >= 'A' && line_[i] <= 'Z'; };
        return at > at_ && is_capital(at) && line_[at - 1] >= 'a' && line_[at - 1] <= 'z';
    }

    bool starts_number() const {
        const bool sign = line_[at_] == '-' || line_[at_] == '+';
        const auto digit = [&](std::size_t at) { return at < line_.size() && is_digit(line_[at]); };
        return digit(at_) || ((sign || line_[at_] == '.') && digit(at_ + 1)) ||
               (sign && at_ + 1 < line_.size() && line_[at_ + 1] == '.' && digit(at_ + 2));
    }

    void step() {
        if (starts_number()) return take_number();
        const Letter letter = letter_at(at_);
        if (letter.plain != '\0') return take_word();
        const char c = line_[at_];
        if (c == ' ' || c == '\t') {
            spaced_ = spaced_ || c == '\t' || (at_ > 0 && line_[at_ - 1] == ' ');
        } else {
            signs_ += c;
        }
        at_ += std::max<std::size_t>(letter.bytes, 1);
    }

    void add(Meaning meaning, std::string text, std::size_t end) {
        words_.push_back({meaning, std::move(text), at_, end, std::move(signs_), spaced_});
        signs_.clear();
        spaced_ = false;
        at_ = end;
    }

    void take_number() {
        std::size_t end = at_ + 1;
        while (end < line_.size() && (is_digit(line_[end]) || is_letter(line_[end]) ||
                                      (line_[end] == '.' && end + 1 < line_.size() && is_digit(line_[end + 1])) ||
                                      ((line_[end] == '-' || line_[end] == '+') && (line_[end - 1] == 'e'))))
            ++end;
        add(Meaning::number, std::string(line_.substr(at_, end - at_)), end);
    }

    void take_word() {
        std::string text;
        std::size_t end = at_;
        for (Letter letter = letter_at(end); letter.plain != '\0' && !is_hump(end); letter = letter_at(end)) {
            text += letter.plain;
            end += letter.bytes;
        }
        // Digits at a name's end belong to it: "t1", "root2".
        while (end < line_.size() && is_digit(line_[end])) text += line_[end++];
        if (text == "n" && (line_.substr(end, 2) == "/a" || line_.substr(end, 2) == "/A" ||
                            line_.substr(end, 3) == ".a." || line_.substr(end, 3) == ".A."))
            return add(Meaning::none, "n/a", end + (line_[end] == '/' ? 2 : 3));
        if (end < line_.size() && line_[end] == '\'') {
            const Letter next = letter_at(end + 1);
            const bool last = letter_at(end + 1 + next.bytes).plain == '\0';
            if (text == "n" || (text.ends_with("n") && next.plain == 't' && last)) {  // "n'est", "doesn't"
                const std::size_t after = text == "n" ? end + 1 : end + 2;
                return add(Meaning::negation, text, after);
            }
        }
        const Meaning meaning = meaning_of(text);
        add(meaning, std::move(text), end);
    }

    std::string_view line_;
    std::size_t at_ = 0;
    std::string signs_;
    bool spaced_ = false;
    std::vector<HitWord> words_;
};

}  // namespace

Meaning meaning_of(std::string_view word) {
    const auto found = lexicon().meanings.find(word);
    if (found != lexicon().meanings.end()) return found->second;
    if (word.size() + 1 < shortest_misspelt || word.front() < 'a' || word.front() > 'z') return Meaning::other;
    for (const std::string_view right : lexicon().long_words.at(static_cast<std::size_t>(word.front() - 'a'))) {
        const Meaning meaning = lexicon().meanings.at(right);
        if (may_be_misspelt(meaning) && is_one_letter_off(word, right)) return meaning;
    }
    return Meaning::other;
}

std::vector<HitWord> hit_words(std::string_view line) {
    return Splitter(line).run();
}

bool has(HitWords words, Meaning meaning) {
    return std::ranges::find(words, meaning, &HitWord::meaning) != words.end();
}

}  // namespace harness
