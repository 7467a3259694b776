#include "harness/read/tokens/token.h"

#include <re2/re2.h>

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
    explicit Lexer(std::string_view line)
        : line_(line), has_only_numbers_(line.find_first_not_of("0123456789.eE+- \t|[]()") == std::string_view::npos) {}

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

    /// Whether a number that fills its column ends here and the next one begins with its sign, as in
    /// "-0.59603642-0.05178358". A difference of numbers with so many decimals is hardly written without blanks.
    bool runs_into_next() const {
        constexpr int many = 4;
        if (peek() != '-' || tokens_.empty() || tokens_.back().kind != Token::Kind::number) return false;
        const bool is_direct = tokens_.back().end == at_ && tokens_.back().number.decimals >= many;
        std::size_t end = 1;
        while (is_digit(peek(end))) ++end;
        std::size_t decimals = 0;
        while (peek(end) == '.' && is_digit(peek(end + 1 + decimals))) ++decimals;
        return decimals >= many && (is_direct || begins_column(end + 1 + decimals));
    }

    /// Whether a number of `width` characters fills its column here, and the number before it stands at the end of one
    /// as wide: "-0.893997        0-0.448074".
    bool begins_column(std::size_t width) const {
        if (!has_only_numbers_ || at_ < width || tokens_.back().end != at_) return false;
        const std::size_t begin = at_ - width;
        const bool is_apart = tokens_.size() < 2 || tokens_[tokens_.size() - 2].end <= begin;
        return tokens_.back().begin > begin && is_apart;
    }

    bool starts_digits(std::size_t ahead) const {
        return is_digit(peek(ahead)) || (peek(ahead) == '.' && is_digit(peek(ahead + 1)));
    }

    /// The length of "nan", "inf" or "infinity" here, whatever its case; 0 when there is none.
    std::size_t special_length(std::size_t ahead) const {
        for (const std::string_view name :
             {"nan(ind)", "nan(snan)", "infinity", "nan", "inf", "1.#qnan", "1.#snan", "1.#ind", "1.#inf"}) {
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
        if (sign == 1 && !may_be_signed() && !runs_into_next()) return false;
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
        if (starts_glued_label(length) || (decimals >= surely_a_number && is_letter(peek(length))))
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

    /// Whether a label starts without a separator before it, as in "a=1b=-4c=2" or "t: 0.5858P_s: …": a word before '='
    /// or ':'.
    bool starts_glued_label(std::size_t ahead) const {
        constexpr std::size_t longest = 24;
        if (!is_letter(peek(ahead)) || tokens_.empty() || tokens_.back().kind != Token::Kind::equals) return false;
        std::size_t end = ahead;
        while (end - ahead < longest && is_word_char(peek(end))) ++end;
        const bool index = peek(ahead) == 'x' && is_digit(peek(ahead + 1));  // "3x3:"
        while (peek(end) == ' ') ++end;
        return !index && (peek(end) == '=' || peek(end) == ':');
    }

    bool peek_back_sign() const { return line_[tokens_.back().begin] == '-'; }

    std::size_t behind_blanks(std::size_t ahead) const {
        while (peek(ahead) == ' ') ++ahead;
        return ahead;
    }

    /// Where the exponent begins behind 'e', "x 10^" or "*10**"; 0 if there is no such sign.
    std::size_t exponent_begin(std::size_t ahead) const {
        if (peek(ahead) == 'e' || peek(ahead) == 'E') return ahead + 1;
        ahead = behind_blanks(ahead);
        if (peek(ahead) != 'x' && peek(ahead) != '*') return 0;
        ahead = behind_blanks(ahead + 1);
        if (peek(ahead) != '1' || peek(ahead + 1) != '0') return 0;
        ahead = behind_blanks(ahead + 2);
        const std::size_t signs = peek(ahead) == '^' ? 1 : peek(ahead) == '*' && peek(ahead + 1) == '*' ? 2 : 0;
        return signs == 0 ? 0 : behind_blanks(ahead + signs);
    }

    /// Moves `length` past an exponent, if there is one, and returns its value.
    int take_exponent(std::size_t& length) const {
        std::size_t end = exponent_begin(length);
        if (end == 0) return 0;
        const bool behind_ten = end > length + 1;
        const char bracket = behind_ten && peek(end) == '(' ? ')' : behind_ten && peek(end) == '{' ? '}' : '\0';
        if (bracket != '\0') ++end;
        const bool negative = peek(end) == '-';
        if (negative || peek(end) == '+') ++end;
        if (!is_digit(peek(end))) return 0;
        int exponent = 0;
        for (; is_digit(peek(end)); ++end) exponent = std::min(exponent * 10 + (peek(end) - '0'), 100000);
        if (bracket != '\0' && peek(end++) != bracket) return 0;
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
        const std::size_t letters = letters_before_number(length);
        add(Token::Kind::word, letters);
        if (letters < length) take_number();
    }

    /// The length of the letters before a number that is glued to them, as in "t1.58579"; else `length`.
    std::size_t letters_before_number(std::size_t length) const {
        if (peek(length) != '.' || !is_digit(peek(length + 1)) || !is_letter(peek())) return length;
        std::size_t letters = 0;
        while (is_letter(peek(letters))) ++letters;
        for (std::size_t i = letters; i < length; ++i) {
            if (!is_digit(peek(i))) return length;
        }
        return letters;
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

    /// Whether the '<' here opens a dot product, "<V, S - C>": two names or sums of names, and no comparison goes on
    /// behind its '>' as in "0 < u, v > 0".
    bool opens_dot_product() const {
        constexpr std::size_t longest_product = 80;
        static const RE2 pattern(R"(^<\s*[A-Za-z][\w' +\-]*,\s*[A-Za-z][\w' +\-]*>\s*(?:[^\s\w.\-]|-\s|$))");
        const std::string_view rest = line_.substr(at_, longest_product);
        return RE2::PartialMatch(re2::StringPiece(rest.data(), rest.size()), pattern);
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
        if (opens_angle_list() || opens_dot_product()) {
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
        add(Token::Kind::compare, peek(1) == '=' ? 2 : 1);
    }

    void take_equals() {
        const std::size_t length = run_length('=');
        if (length == 1 && peek(1) == '>') return add(Token::Kind::equals, 2);
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
    bool has_only_numbers_;
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
