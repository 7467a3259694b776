#include "harness/read/words/hit_words.h"

#include <algorithm>
#include <unordered_map>

#include "harness/text/letters.h"
#include "harness/text/lower_case.h"

namespace harness {
namespace {

constexpr std::size_t longest_line = 1000;

struct MeaningRow {
    Meaning meaning;
    std::string_view words;
};

constexpr MeaningRow table[] = {
    {Meaning::sphere, "sphere spheres ball sph"},
    {Meaning::triangle, "triangle triangles tri"},
    {Meaning::cylinder, "cylinder cylinders cyl"},
    {Meaning::any_object, "object objects anything everything any both all others"},
    {Meaning::ray, "ray rays it we i they"},
    {Meaning::hit,
     "hit hits hitting intersect intersects intersected intersecting intersection intersections touch touches touched "
     "meet meets met reach reaches reached strike strikes struck root roots solution solutions hitpoint"},
    {Meaning::miss, "miss misses missed"},
    {Meaning::negation,
     "no not never nor doesnt isnt dont didnt wasnt arent cannot cant wont without false neither fails fail"},
    {Meaning::none, "none nothing null nil nullptr undefined n/a nonexistent invalid"},
    {Meaning::not_real, "complex imaginary"},
    {Meaning::discriminant, "discriminant disc delta"},
    {Meaning::negative, "negative"},
    {Meaning::exists, "exist exists existent existing defined applicable available found possible valid"},
    {Meaning::answer, "t normal normals value values point points parameter"},
    {Meaning::link,
     "real positive such true find a an the single there is are was were be been has have had does do did of to with "
     "and actually even ever really actual common this that also at which belongs than"},
    {Meaning::partial,
     "cap caps tube side sides top bottom disk disks second third other another smaller double repeated plane yet more "
     "edge inside outside entry exit body lateral"},
    {Meaning::by, "by"},
    {Meaning::first, "first"},
    {Meaning::nearest, "closest nearest smallest least lowest minimum min earliest wins winner frontmost foremost"},
    {Meaning::before, "before closer nearer earlier front less ahead beats occludes blocks hides covers obscures"},
    {Meaning::covered, "occluded blocked hidden covered obscured"},
    {Meaning::after, "after behind last later afterwards farthest"},
    {Meaning::farther, "far farther further larger greater bigger"},
    {Meaning::tie, "tie tied simultaneously same equal"},
    {Meaning::seen, "visible seen chosen see sees show shows"},
    {Meaning::condition, "if when whether unless maybe perhaps probably possibly guess think todo fixme"},
    {Meaning::contrast, "but while whereas however"},
    {Meaning::reason, "since because"},
    {Meaning::conclusion, "so thus hence therefore"},
    {Meaning::either, "or"},
    {Meaning::debug, "debug dbg trace log"},
};

const std::unordered_map<std::string_view, Meaning>& lexicon() {
    static const std::unordered_map<std::string_view, Meaning> all = [] {
        std::unordered_map<std::string_view, Meaning> meanings;
        for (auto [meaning, words] : table) {
            while (!words.empty()) {
                const std::string_view word = words.substr(0, words.find(' '));
                words.remove_prefix(std::min(words.size(), word.size() + 1));
                meanings.emplace(word, meaning);
            }
        }
        return meanings;
    }();
    return all;
}

class Splitter {
  public:
    explicit Splitter(std::string_view line) : line_(line.substr(0, longest_line)) {}

    std::vector<HitWord> run() {
        while (at_ < line_.size()) step();
        return std::move(words_);
    }

  private:
    char peek(std::size_t at) const { return at < line_.size() ? line_[at] : '\0'; }

    bool starts_number() const {
        std::size_t at = at_;
        if (peek(at) == '-' || peek(at) == '+') ++at;
        if (peek(at) == '.') ++at;
        return is_digit(peek(at));
    }

    void step() {
        if (starts_number()) return take_number();
        const char c = line_[at_];
        if (is_letter(c)) return take_word();
        if (c == ' ' || c == '\t') {
            spaced_ = spaced_ || c == '\t' || (at_ > 0 && line_[at_ - 1] == ' ');
        } else {
            signs_ += c;
        }
        ++at_;
    }

    void add(Meaning meaning, std::string text, std::size_t end) {
        words_.push_back({meaning, std::move(text), at_, end, std::move(signs_), spaced_});
        signs_.clear();
        spaced_ = false;
        at_ = end;
    }

    void take_number() {
        std::size_t end = at_ + 1;
        while (is_digit(peek(end)) || is_letter(peek(end)) || (peek(end) == '.' && is_digit(peek(end + 1))) ||
               ((peek(end) == '-' || peek(end) == '+') && peek(end - 1) == 'e'))
            ++end;
        add(Meaning::number, std::string(line_.substr(at_, end - at_)), end);
    }

    void take_word() {
        std::size_t end = at_;
        const auto is_hump = [&] {  // a word of a name in camelCase
            return end > at_ && peek(end) >= 'A' && peek(end) <= 'Z' && peek(end - 1) >= 'a' && peek(end - 1) <= 'z';
        };
        while (is_letter(peek(end)) && !is_hump()) ++end;
        while (is_digit(peek(end))) ++end;  // "t1"
        std::string text = lower_case(line_.substr(at_, end - at_));
        if (text == "n" && lower_case(line_.substr(end, 2)) == "/a") return add(Meaning::none, "n/a", end + 2);
        if (text.ends_with('n') && peek(end) == '\'' && peek(end + 1) == 't' && !is_letter(peek(end + 2)))
            return add(Meaning::negation, text, end + 2);  // "doesn't"
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

std::optional<reference::Subject> object_of(Meaning meaning) {
    switch (meaning) {
        case Meaning::sphere: return reference::Subject::sphere;
        case Meaning::triangle: return reference::Subject::triangle;
        case Meaning::cylinder: return reference::Subject::cylinder;
        default: return std::nullopt;
    }
}

Meaning meaning_of(std::string_view word) {
    const auto found = lexicon().find(word);
    return found == lexicon().end() ? Meaning::other : found->second;
}

std::vector<HitWord> hit_words(std::string_view line) {
    return Splitter(line).run();
}

bool has(HitWords words, Meaning meaning) {
    return std::ranges::find(words, meaning, &HitWord::meaning) != words.end();
}

}  // namespace harness
