#include "harness/read/tokens/token.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>
#include <utility>

#include "harness/text/lower_case.h"

namespace harness {
namespace {

bool is_word_char(char c) {
    return is_letter(c) || is_digit(c) || c == '_';
}

/// U+FFFD, which stands for bytes that are not UTF-8.
constexpr std::string_view unreadable = "\xEF\xBF\xBD";

class Lexer {
  public:
    explicit Lexer(std::string_view line) : line_(line) {}

    std::vector<Token> run() {
        while (at_ < line_.size()) step();
        int index = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (tokens_[i].kind == Token::Kind::number && !is_bracketed_index(i)) tokens_[i].number.index = ++index;
        }
        return std::move(tokens_);
    }

  private:
    char peek(std::size_t ahead = 0) const { return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0'; }

    bool is_bracketed_index(std::size_t i) const {
        using Kind = Token::Kind;
        return i > 0 && i + 2 < tokens_.size() && tokens_[i - 1].kind == Kind::open &&
               tokens_[i + 1].kind == Kind::close && tokens_[i + 2].kind == Kind::equals;
    }

    void add(Token::Kind kind, std::size_t length) {
        tokens_.push_back({kind, at_, at_ + length, {}});
        at_ += length;
    }

    void step() {
        const char c = peek();
        if (c == ' ' || c == '\t') {
            ++at_;
        } else if (const std::size_t leader = leader_length(0); leader > 0) {
            at_ += leader;
            behind_leader_ = at_;
        } else if (line_.substr(at_).starts_with(unreadable)) {
            at_ += unreadable.size();
            behind_leader_ = at_;
        } else if (starts_number()) {
            take_number();
        } else if (is_word_char(c)) {
            take_word();
        } else {
            take_sign(c);
        }
    }

    std::size_t run_length(char c, std::size_t ahead = 0) const {
        std::size_t length = 0;
        while (peek(ahead + length) == c) ++length;
        return length;
    }

    /// The length of a leader here, the dots or low lines that fill a column: "a........1". 0 if there is none.
    std::size_t leader_length(std::size_t ahead) const {
        constexpr std::size_t fewest_dots = 3, fewest_low_lines = 4;
        const std::size_t dots = run_length('.', ahead), low_lines = run_length('_', ahead);
        return dots >= fewest_dots ? dots : low_lines >= fewest_low_lines ? low_lines : 0;
    }

    bool is_in_word() const { return at_ > 0 && at_ != behind_leader_ && is_word_char(line_[at_ - 1]); }

    /// Whether the word before ends here, as the letters of "t1.58579" do.
    bool ends_word() const {
        return !tokens_.empty() && tokens_.back().kind == Token::Kind::word && tokens_.back().end == at_;
    }

    bool starts_digits(std::size_t ahead) const {
        return is_digit(peek(ahead)) || (peek(ahead) == '.' && is_digit(peek(ahead + 1)));
    }

    /// The length of "nan", "inf" or "infinity" here, whatever its case; 0 when there is none.
    std::size_t special_length(std::size_t ahead) const {
        for (const std::string_view name : {"infinity", "nan", "inf"}) {
            const std::string_view here = line_.substr(std::min(at_ + ahead, line_.size()), name.size());
            if (lower_case(here) == name && !is_word_char(peek(ahead + name.size()))) return name.size();
        }
        return 0;
    }

    std::size_t sign_length() const { return peek() == '-' || peek() == '+' ? 1 : 0; }

    /// A '+' or '-' belongs to the number after it in "(-4" and "1 -4 2", but not in "3-2" and "(a)-2".
    bool starts_number() const {
        const std::size_t sign = sign_length();
        const bool is_bound = sign == 0 ? is_in_word() && !ends_word()
                                        : is_in_word() || (at_ > 0 && (line_[at_ - 1] == ')' || line_[at_ - 1] == ']'));
        return !is_bound && (starts_digits(sign) || special_length(sign) > 0);
    }

    void take_number() {
        const std::size_t sign = sign_length();
        const double factor = peek() == '-' ? -1 : 1;
        if (const std::size_t length = special_length(sign); length > 0) {
            const bool is_nan = lower_case(line_.substr(at_ + sign, 3)) == "nan";
            add(Token::Kind::number, sign + length);
            tokens_.back().number.value =
                factor * (is_nan ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity());
            return;
        }
        std::size_t length = sign;
        while (is_digit(peek(length))) ++length;
        std::size_t decimals = 0;
        if (peek(length) == '.' && (length == sign || !is_letter(peek(length + 1)))) {
            ++length;
            while (is_digit(peek(length + decimals))) ++decimals;
            length += decimals;
        }
        const std::size_t mantissa = length;
        const int exponent = take_exponent(length);
        PrintedNumber number = parse(line_.substr(at_ + sign, mantissa - sign), static_cast<int>(decimals), exponent);
        number.value *= factor;
        if (mantissa > sign + 1 && (peek(length) | 0x20) == 'f' && !is_word_char(peek(length + 1))) ++length;
        const bool goes_on = is_word_char(peek(length)) && !line_.substr(at_ + length).starts_with(unreadable);
        if (goes_on && decimals == 0) {  // "3x3", "2nd", "4ac": a word that begins with a digit; "6.7t" is none
            at_ += sign;
            return take_word();
        }
        add(Token::Kind::number, length);
        tokens_.back().number = number;
    }

    /// Moves `length` past an exponent, if there is one, and returns its value.
    int take_exponent(std::size_t& length) const {
        if ((peek(length) | 0x20) != 'e') return 0;
        std::size_t end = length + 1;
        const bool negative = peek(end) == '-';
        if (negative || peek(end) == '+') ++end;
        if (!is_digit(peek(end))) return 0;
        int exponent = 0;
        for (; is_digit(peek(end)); ++end) exponent = std::min(exponent * 10 + (peek(end) - '0'), 100000);
        length = end;
        return negative ? -exponent : exponent;
    }

    static PrintedNumber parse(std::string_view mantissa, int decimals, int exponent) {
        PrintedNumber number;
        const std::size_t first = mantissa.find_first_not_of("0.");
        for (const char c : mantissa.substr(std::min(first, mantissa.size())))
            number.significant += is_digit(c) ? 1 : 0;
        number.decimals = number.significant == 0 ? decimals : decimals - exponent;  // "0e9" is no less sure than "0"
        std::string text(mantissa);
        if (exponent != 0) text += "e" + std::to_string(exponent);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number.value);
        if (error == std::errc::result_out_of_range)
            number.value = exponent < 0 ? 0.0 : std::numeric_limits<double>::infinity();
        return number;
    }

    void take_word() {
        std::size_t length = 0;
        while (!line_.substr(at_ + length).starts_with(unreadable) && leader_length(length) == 0) {
            const char c = peek(length), next = peek(length + 1);
            if (is_word_char(c) || (c == '\'' && length > 0)) {
                ++length;
            } else if (c == ':' && next == ':' && is_letter(peek(length + 2))) {
                length += 2;
            } else if (c == '.' && length > 0 && is_letter(next) && !is_word_char(peek(length + 2))) {
                length += 2;  // a component: "P.x"
            } else if (c == '[' && length > 0 && is_digit(next) && peek(length + 2) == ']') {
                length += 3;  // an index: "M[0]"
            } else {
                break;
            }
        }
        if (length == 0) return add(Token::Kind::other, 1);  // the point of ".5x"
        add(Token::Kind::word, letters_before_number(length));
    }

    /// The length of the letters before a decimal number that is glued to them, as in "t1.58579"; else `length`.
    std::size_t letters_before_number(std::size_t length) const {
        if (peek(length) != '.' || !is_digit(peek(length + 1))) return length;
        std::size_t letters = length;
        while (letters > 0 && is_digit(peek(letters - 1))) --letters;
        return letters > 0 ? letters : length;
    }

    /// Whether the '<' here opens a list of numbers: up to its '>' follow numbers and signs, and no words or "=".
    bool opens_angle_list() const {
        constexpr std::size_t longest_list = 300;
        constexpr std::string_view in_number = "eEnaifNAIF";
        const std::size_t close = line_.substr(at_, longest_list).find('>', 1);
        if (close == std::string_view::npos || line_[at_ + close - 1] == '-') return false;  // "< 0 ->"
        const std::string_view inside = line_.substr(at_ + 1, close - 1);
        return inside.find_first_of("0123456789naNA") != std::string_view::npos &&
               std::ranges::all_of(inside, [&](char c) {
                   return c != '=' && c != '<' && (!is_letter(c) || in_number.find(c) != std::string_view::npos);
               });
    }

    void take_sign(char c) {
        using Kind = Token::Kind;
        const bool equal = peek(1) == '=';
        // Brackets are taken one by one: their runs are not measured.
        const std::size_t length = std::string_view("|=-+/^*>").find(c) != std::string_view::npos ? run_length(c) : 1;
        const bool arrow = (c == '-' || c == '=') && peek(length) == '>';  // "->", "==>"
        if (arrow) return add(Kind::equals, length + 1);
        switch (c) {
            case '(':
            case '[':
            case '{': return add(Kind::open, 1);
            case ')':
            case ']':
            case '}': return add(Kind::close, 1);
            case ',':
            case ';': return add(Kind::comma, 1);
            case '|': return add(Kind::bar, length);
            case ':': return add(Kind::equals, equal ? 2 : 1);
            case '~': return add(equal ? Kind::equals : Kind::other, equal ? 2 : 1);
            case '!': return add(equal ? Kind::compare : Kind::other, equal ? 2 : 1);
            case '=': return add(length <= 2 ? Kind::equals : Kind::other, length);
            case '+':
            case '/':
            case '^':
            case '*':
            case '-': return add(length == 1 ? Kind::op : Kind::other, length);
            case '<':
                if (!equal && opens_angle_list()) {
                    open_angle_ = true;
                    return add(Kind::open, 1);
                }
                if (peek(1) == '-' && !starts_digits(2)) return add(Kind::other, 2);
                return add(Kind::compare, equal ? 2 : 1);
            case '>':
                if (std::exchange(open_angle_, false)) return add(Kind::close, 1);
                return length > 1 ? add(Kind::equals, length) : add(Kind::compare, equal ? 2 : 1);
            default: return add(Kind::other, 1);
        }
    }

    std::string_view line_;
    std::size_t at_ = 0;
    std::size_t behind_leader_ = 0;
    bool open_angle_ = false;
    std::vector<Token> tokens_;
};

/// The lone minus sign before this byte, with at most a blank, a quote or a letter between.
MinusBefore minus_before(std::string_view text, std::size_t begin) {
    constexpr std::size_t most_between = 2;
    bool is_apart = false;
    for (std::size_t back = 1; back <= most_between + 1 && back <= begin; ++back) {
        const char c = text[begin - back];
        if (c == '-') {
            const char before = back == begin ? ' ' : text[begin - back - 1];
            if (before == '-' || before == '<') return MinusBefore::none;
            return is_apart ? MinusBefore::apart : MinusBefore::glued;
        }
        if (is_digit(c) || c == '+' || c == '=' || c == ':' || c == ',' || c == '>') return MinusBefore::none;
        is_apart = is_apart || c == ' ' || c == '\t';
    }
    return MinusBefore::none;
}

}  // namespace

std::vector<Token> tokenize(std::string_view line) {
    return Lexer(line).run();
}

std::vector<NumberOfLine> numbers_of_line(std::string_view line, int number) {
    std::vector<NumberOfLine> numbers;
    bool is_behind_equals = false;
    for (const Token& token : tokenize(line)) {
        if (token.kind == Token::Kind::number && token.number.index != 0) {
            numbers.push_back(
                {token.number, minus_before(line, token.begin), token.begin, token.end, is_behind_equals});
            numbers.back().number.line = number;
        }
        is_behind_equals = token.kind == Token::Kind::equals;
    }
    return numbers;
}

}  // namespace harness
