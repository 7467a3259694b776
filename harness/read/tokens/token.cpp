#include "harness/read/tokens/token.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>

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
        return std::move(tokens_);
    }

  private:
    char peek(std::size_t ahead = 0) const { return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0'; }

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
        } else if (is_unreadable(at_)) {
            at_ += unreadable.size();
        } else if (starts_number()) {
            take_number();
        } else if (is_letter(c) || c == '_' || is_digit(c)) {
            take_word();
        } else {
            take_sign(c);
        }
    }

    bool is_unreadable(std::size_t at) const {
        return at < line_.size() && line_.substr(at, unreadable.size()) == unreadable;
    }

    /// The length of a leader here, the dots or low lines that fill a column: "a........1". 0 if there is none.
    std::size_t leader_length(std::size_t ahead) const {
        const char c = peek(ahead);
        if (c != '.' && c != '_') return 0;
        const std::size_t fewest = c == '.' ? 3 : 4;
        std::size_t length = 1;
        while (peek(ahead + length) == c) ++length;
        return length < fewest ? 0 : length;
    }

    /// Whether the byte before `at_` is part of a word.
    bool is_in_word() const {
        if (at_ == behind_leader_) return false;
        if (at_ == 0 || !is_word_char(line_[at_ - 1])) return false;
        return at_ < unreadable.size() || !is_unreadable(at_ - unreadable.size());
    }

    /// Whether a '+' or '-' here belongs to the number after it, as in "(-4" and "1 -4 2" but not in "3-2".
    bool may_be_signed() const { return at_ == 0 || !(is_in_word() || line_[at_ - 1] == ')' || line_[at_ - 1] == ']'); }

    bool starts_digits(std::size_t ahead) const {
        return is_digit(peek(ahead)) || (peek(ahead) == '.' && is_digit(peek(ahead + 1)));
    }

    /// The length of "nan", "inf" or "infinity" here, whatever its case; 0 when there is none.
    std::size_t special_length(std::size_t ahead) const {
        for (const std::string_view name : {"infinity", "nan", "inf"}) {
            const bool same = std::equal(
                name.begin(), name.end(),
                line_.begin() + static_cast<std::ptrdiff_t>(std::min(at_ + ahead, line_.size())),
                line_.begin() + static_cast<std::ptrdiff_t>(std::min(at_ + ahead + name.size(), line_.size())),
                [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
            if (same && !is_word_char(peek(ahead + name.size()))) return name.size();
        }
        return 0;
    }

    bool starts_number() const {
        const std::size_t sign = peek() == '-' || peek() == '+' ? 1 : 0;
        if (sign == 1 && !may_be_signed()) return false;
        if (sign == 0 && is_in_word()) return false;
        return starts_digits(sign) || special_length(sign) > 0;
    }

    void take_number() {
        const std::size_t sign = peek() == '-' || peek() == '+' ? 1 : 0;
        if (const std::size_t length = special_length(sign); length > 0) {
            // "nan", "1.#QNAN", "1.#IND" as old Windows libraries print it; else an infinity.
            const std::string_view name = line_.substr(at_ + sign, length);
            const bool nan = name.find_first_of("aAdD") != std::string_view::npos;
            const double value =
                nan ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
            add(Token::Kind::number, sign + length);
            tokens_.back().number.value = peek_back_sign() ? -value : value;
            return;
        }
        std::size_t length = sign;
        while (is_digit(peek(length))) ++length;
        int decimals = 0;
        if (peek(length) == '.' && (length == sign || !is_letter(peek(length + 1)))) {
            ++length;
            while (is_digit(peek(length))) {
                ++length;
                ++decimals;
            }
        }
        const std::size_t mantissa_end = length;
        const int exponent = take_exponent(length);
        const std::size_t digits_end = length;
        if (mantissa_end > sign + 1 && (peek(length) == 'f' || peek(length) == 'F') && !is_word_char(peek(length + 1)))
            ++length;
        constexpr int surely_a_number = 3;  // decimals: a unit follows, as in "0.586m"
        if ((decimals >= surely_a_number && is_letter(peek(length))))
            return add_number(sign, mantissa_end, digits_end, digits_end, decimals, exponent);
        if ((is_letter(peek(length)) && !is_unreadable(at_ + length)) ||
            peek(length) == '_') {  // "3x3", "2nd", "4ac": a word that begins with a digit
            at_ += sign;
            take_word();
            return;
        }
        add_number(sign, mantissa_end, digits_end, length, decimals, exponent);
    }

    void add_number(std::size_t sign, std::size_t mantissa_end, std::size_t digits_end, std::size_t length,
                    int decimals, int exponent) {
        const std::size_t begin = at_;
        add(Token::Kind::number, length);
        tokens_.back().number = parse(begin, sign, mantissa_end, digits_end, decimals, exponent);
    }

    bool peek_back_sign() const { return line_[tokens_.back().begin] == '-'; }

    /// Moves `length` past an exponent, if there is one, and returns its value.
    int take_exponent(std::size_t& length) const {
        std::size_t end = length + 1;
        if (peek(length) != 'e' && peek(length) != 'E') return 0;
        const bool negative = peek(end) == '-';
        if (negative || peek(end) == '+') ++end;
        if (!is_digit(peek(end))) return 0;
        int exponent = 0;
        for (; is_digit(peek(end)); ++end) exponent = std::min(exponent * 10 + (peek(end) - '0'), 100000);
        length = end;
        return negative ? -exponent : exponent;
    }

    PrintedNumber parse(std::size_t begin, std::size_t sign, std::size_t mantissa_end, std::size_t length, int decimals,
                        int exponent) const {
        PrintedNumber number;
        const std::string_view mantissa = line_.substr(begin + sign, mantissa_end - sign);
        bool leading = true;
        for (const char c : mantissa) {
            leading = leading && (c == '0' || c == '.');
            if (!leading && is_digit(c)) ++number.significant;
        }
        number.decimals = leading ? decimals : decimals - exponent;  // "0e9" is no less sure than "0"
        std::string text(mantissa);
        if (length > mantissa_end) text += "e" + std::to_string(exponent);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number.value);
        if (error == std::errc::result_out_of_range) {
            number.value = exponent < 0 ? 0.0 : std::numeric_limits<double>::infinity();
        }
        if (line_[begin] == '-') number.value = -number.value;
        return number;
    }

    void take_word() {
        std::size_t length = 0;
        while (true) {
            const char c = peek(length);
            if (is_unreadable(at_ + length) || leader_length(length) > 0) break;
            if (is_word_char(c) || (c == '\'' && length > 0)) {
                ++length;
            } else if (c == ':' && peek(length + 1) == ':' && is_letter(peek(length + 2))) {
                length += 2;
            } else if (c == '.' && length > 0 && is_letter(peek(length + 1)) && !is_word_char(peek(length + 2))) {
                length += 2;  // a component: "P.x"
            } else if (c == '[' && length > 0 && is_digit(peek(length + 1)) && peek(length + 2) == ']') {
                length += 3;  // an index: "M[0]"
            } else {
                break;
            }
        }
        if (length == 0) return add(Token::Kind::other, 1);  // the point of ".5x"
        add(Token::Kind::word, length);
    }

    /// Whether the '<' here opens a list of numbers: only numbers, commas and blanks follow up to its '>'.
    bool opens_angle_list() const {
        constexpr std::size_t longest_list = 300;
        constexpr std::string_view in_list = "0123456789.eE+-, \t;|naifNAIF";
        const std::size_t close = line_.substr(at_, longest_list).find('>', 1);
        if (close == std::string_view::npos || close == 1 || line_[at_ + close - 1] == '-') return false;  // "< 0 ->"
        const std::string_view inside = line_.substr(at_ + 1, close - 1);
        return inside.find_first_not_of(in_list) == std::string_view::npos &&
               inside.find_first_of("0123456789naNA") != std::string_view::npos;
    }

    std::size_t run_length(char c) const {
        std::size_t length = 1;
        while (peek(length) == c) ++length;
        return length;
    }

    void take_sign(char c) {
        switch (c) {
            case '(':
            case '[':
            case '{': return add(Token::Kind::open, 1);
            case ')':
            case ']':
            case '}': return add(Token::Kind::close, 1);
            case '<': return take_less();
            case '>': return take_greater();
            case ',':
            case ';': return add(Token::Kind::comma, 1);
            case '|': return add(Token::Kind::bar, run_length('|'));
            case '=': return take_equals();
            case ':': return add(Token::Kind::equals, peek(1) == '=' ? 2 : 1);
            case '~': return add(peek(1) == '=' ? Token::Kind::equals : Token::Kind::other, peek(1) == '=' ? 2 : 1);
            case '!': return add(peek(1) == '=' ? Token::Kind::compare : Token::Kind::other, peek(1) == '=' ? 2 : 1);
            case '+':
            case '/':
            case '^':
            case '*': return take_operator(c);
            case '-': return take_minus();
            default: return add(Token::Kind::other, 1);
        }
    }

    void take_less() {
        if (peek(1) == '=') return add(Token::Kind::compare, 2);
        if (opens_angle_list()) {
            open_angle_ = true;
            return add(Token::Kind::open, 1);
        }
        if (peek(1) == '-' && !starts_digits(2)) return add(Token::Kind::other, 2);
        add(Token::Kind::compare, 1);
    }

    void take_greater() {
        if (open_angle_) {
            open_angle_ = false;
            return add(Token::Kind::close, 1);
        }
        if (peek(1) == '>') return add(Token::Kind::equals, run_length('>'));
        add(Token::Kind::compare, peek(1) == '=' ? 2 : 1);
    }

    void take_equals() {
        const std::size_t length = run_length('=');
        if (peek(length) == '>') return add(Token::Kind::equals, length + 1);  // "=>", "==>"
        add(length <= 2 ? Token::Kind::equals : Token::Kind::other, length);
    }

    void take_operator(char c) {
        const std::size_t length = run_length(c);
        add(length == 1 ? Token::Kind::op : Token::Kind::other, length);
    }

    void take_minus() {
        const std::size_t length = run_length('-');
        if (peek(length) == '>') return add(Token::Kind::equals, length + 1);
        add(length == 1 ? Token::Kind::op : Token::Kind::other, length);
    }

    std::string_view line_;
    std::size_t at_ = 0;
    std::size_t behind_leader_ = 0;
    bool open_angle_ = false;
    std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokenize(std::string_view line) {
    return Lexer(line).run();
}

}  // namespace harness
