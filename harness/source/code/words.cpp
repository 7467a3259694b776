#include "harness/source/code/words.h"

#include <algorithm>
#include <set>
#include <string>

namespace harness::source {
namespace {

/// Whether the text between #if and #endif is compiled.
enum class Part { compiled, left_out, unsure };

char closing_of(char open) {
    switch (open) {
        case '(': return ')';
        case '[': return ']';
        case '{': return '}';
        default: return '\0';
    }
}

class Reader {
  public:
    explicit Reader(std::string_view source) : source_(source), tokens_(lex_cpp(source)) {}

    std::vector<Word> read() {
        while (at_ < tokens_.size()) {
            const Token& token = tokens_[at_];
            if (token.kind == TokenKind::directive) {
                directive();
            } else {
                if (!is_space(token.kind) && part() != Part::left_out) add(token);
                ++at_;
            }
        }
        return std::move(words_);
    }

  private:
    static bool is_space(TokenKind kind) {
        return kind == TokenKind::blank || kind == TokenKind::comment || kind == TokenKind::line_end;
    }
    std::string_view text(const Token& token) const { return source_.substr(token.begin, token.end - token.begin); }
    Part part() const { return parts_.empty() ? Part::compiled : parts_.back(); }

    void add(const Token& token) {
        Word word{token.kind, text(token), token.begin};
        word.in_define = in_define_;
        word.certain = part() == Part::compiled;
        const std::size_t index = words_.size();
        const bool bracket = token.kind == TokenKind::symbol && word.text.size() == 1;
        if (bracket && open_.size() > barrier_ && word.text[0] == closing_of(words_[open_.back()].text[0])) {
            word.partner = open_.back();
            words_[open_.back()].partner = index;
            open_.pop_back();
        }
        if (open_.size() > barrier_) word.parent = open_.back();
        words_.push_back(word);
        if (bracket && closing_of(word.text[0]) != '\0') open_.push_back(index);
    }

    /// The words of the line from the directive's name on, without spaces. Moves to the line's end.
    std::vector<Token> rest_of_line() {
        std::vector<Token> rest;
        for (; at_ < tokens_.size() && tokens_[at_].kind != TokenKind::line_end; ++at_) {
            if (!is_space(tokens_[at_].kind)) rest.push_back(tokens_[at_]);
        }
        return rest;
    }

    void directive() {
        const Token hash = tokens_[at_++];
        const std::vector<Token> line = rest_of_line();
        if (line.empty()) return;
        const std::string_view what = text(line[0]);
        if (what == "if" || what == "ifdef" || what == "ifndef") {
            parts_.push_back(part() == Part::left_out ? Part::left_out : condition(line));
        } else if (what == "else" || what == "elif" || what == "endif") {
            if (parts_.empty()) return;
            const Part before = parts_.back();
            parts_.pop_back();
            if (what != "endif") parts_.push_back(other_part(before, what));
        } else if (what == "define" && part() != Part::left_out && line.size() > 1) {
            define(hash, line);
        }
    }

    Part other_part(Part before, std::string_view what) const {
        if (part() == Part::left_out) return Part::left_out;
        if (what == "elif" || before == Part::unsure || part() == Part::unsure) return Part::unsure;
        return before == Part::compiled ? Part::left_out : Part::compiled;
    }

    Part condition(const std::vector<Token>& line) const {
        const Part around = part();
        if (line.size() != 2) return Part::unsure;
        const std::string_view what = text(line[0]);
        const std::string word(text(line[1]));
        if (what == "if") {
            if (word == "0") return Part::left_out;
            return word == "1" ? around : Part::unsure;
        }
        if (!defined_.contains(word)) return Part::unsure;
        return what == "ifdef" ? around : Part::left_out;
    }

    void define(const Token& hash, const std::vector<Token>& line) {
        if (part() == Part::compiled) defined_.emplace(text(line[1]));
        in_define_ = true;
        const std::size_t outside = barrier_;
        const std::size_t open = open_.size();
        barrier_ = open;
        add(hash);
        for (std::size_t i = 1; i < line.size(); ++i) add(line[i]);
        Word end{TokenKind::line_end, {}, line.back().end};
        end.in_define = true;
        end.certain = part() == Part::compiled;
        words_.push_back(end);
        open_.resize(open);
        barrier_ = outside;
        in_define_ = false;
    }

    std::string_view source_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    std::vector<Word> words_;
    std::vector<std::size_t> open_;  ///< brackets that are still open
    std::size_t barrier_ = 0;        ///< how many of them can't close inside the current #define
    std::vector<Part> parts_;        ///< one for each #if around this place
    std::set<std::string, std::less<>> defined_;
    bool in_define_ = false;
};

}  // namespace

std::vector<Word> words_of(std::string_view source) {
    return Reader(source).read();
}

bool is_any_of(std::string_view text, std::initializer_list<std::string_view> list) {
    return std::find(list.begin(), list.end(), text) != list.end();
}

bool is_name(const Word& word) {
    return word.kind == TokenKind::name;
}

bool is_symbol(const std::vector<Word>& words, std::size_t at, std::string_view text) {
    return at < words.size() && words[at].kind == TokenKind::symbol && words[at].text == text;
}

}  // namespace harness::source
