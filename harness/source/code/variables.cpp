#include "harness/source/code/variables.h"

#include <algorithm>
#include <tuple>

#include "harness/source/code/source_names.h"

namespace harness::source {
namespace {

/// Whether no type can begin with this name.
bool begins_no_type(std::string_view name) {
    return is_any_of(
        name, {"return",   "new",      "delete", "throw", "else",      "case",    "if",      "while",  "for",
               "do",       "switch",   "sizeof", "using", "namespace", "typedef", "goto",    "break",  "continue",
               "template", "operator", "struct", "class", "enum",      "public",  "private", "default"});
}

}  // namespace

/// The declarations in force at one place of the source.
struct Variables::Scopes {
    std::map<std::string_view, std::vector<std::size_t>> in_force;  ///< the innermost last
    std::vector<std::vector<std::string_view>> declared{{}};        ///< by scope, the outermost first

    void declare(std::string_view name, std::size_t at) {
        in_force[name].push_back(at);
        declared.back().push_back(name);
    }
    void close() {
        if (declared.size() == 1) return;
        for (const std::string_view name : declared.back()) in_force[name].pop_back();
        declared.pop_back();
    }
    std::size_t find(std::string_view name) const {
        const auto found = in_force.find(name);
        return found == in_force.end() || found->second.empty() ? nowhere : found->second.back();
    }
};

Variables::Variables(const std::vector<Word>& words)
    : words_(words), declares_(words.size(), false), meaning_(words.size(), nowhere) {
    find_functions();
    find_declarations();
    find_meanings();
}

/// A name that is not a part of a longer one: no member, and nothing of a namespace.
bool Variables::is_plain_name(std::size_t at) const {
    if (at >= words_.size() || !is_name(words_[at]) || words_[at].in_define) return false;
    if (at == 0) return true;
    const bool is_member = is(at - 1, ".") || is(at - 1, "->");
    return !is(at - 1, "::") && (!is_member || (at >= 2 && words_[at - 2].text == "this"));
}

/// Past the type that begins here: "const glm::vec3 &", "vector<float>". `at` itself if none does.
std::size_t Variables::past_type(std::size_t at) const {
    constexpr std::size_t longest_template = 30;
    std::size_t end = at;
    std::size_t last_name = nowhere;
    while (end < words_.size() && is_name(words_[end]) && !begins_no_type(words_[end].text)) {
        // The last of several names is the variable's.
        if (last_name != nowhere && end == last_name + 1) {
            const std::size_t after = end + 1;
            const bool goes_on = after < words_.size() && (is_name(words_[after]) || is(after, "::") ||
                                                           is(after, "<") || is(after, "&") || is(after, "*"));
            if (!goes_on) return end;
        }
        last_name = end++;
        if (is(end, "<")) {
            std::size_t close = end;
            while (close < words_.size() && close < end + longest_template && !is(close, ">") && !is(close, ";"))
                ++close;
            if (!is(close, ">")) return at;
            end = close + 1;
            if (!is(end, "::")) break;
        }
        if (is(end, "::")) {
            ++end;
            last_name = nowhere;
        } else if (is(end, "&") || is(end, "*") || is(end, "&&") || is(end, "[")) {
            break;
        }
    }
    if (last_name == nowhere) return at;
    while (is(end, "&") || is(end, "*") || is(end, "&&")) ++end;
    return end;
}

/// Marks the names that a statement or a parameter beginning here declares.
void Variables::declare_from(std::size_t begin) {
    std::size_t name = past_type(begin);
    if (name == begin || name >= words_.size()) return;
    const std::size_t parent = words_[begin].parent;
    if (is(name, "[") && words_[name].partner != nowhere && words_[begin].text == "auto") {
        for (std::size_t i = name + 1; i < words_[name].partner; ++i) declares_[i] = is_name(words_[i]);
        return;
    }
    while (is_plain_name(name)) {
        const std::size_t next = name + 1;
        const bool declares = next >= words_.size() || is(next, "=") || is(next, ";") || is(next, ",") ||
                              is(next, ")") || is(next, "(") || is(next, "{") || is(next, "[") || is(next, ":");
        if (!declares) return;
        declares_[name] = true;
        // On to the next declared name, past this one's value.
        std::size_t comma = next;
        while (comma < words_.size() && !(is(comma, ",") && words_[comma].parent == parent)) {
            if (is(comma, ";") || (is(comma, ")") && words_[comma].partner == parent)) return;
            comma = words_[comma].partner != nowhere && words_[comma].partner > comma ? words_[comma].partner + 1
                                                                                      : comma + 1;
        }
        name = comma + 1;
        while (is(name, "&") || is(name, "*")) ++name;
        if (parent != nowhere && is(parent, "(")) return;  // the next parameter has a type of its own
    }
}

void Variables::find_declarations() {
    const SourceNames names(words_);
    for (std::size_t i = 0; i < words_.size(); ++i) {
        if (words_[i].in_define || !is_name(words_[i])) continue;
        const bool begins =
            i == 0 || is(i - 1, ";") || is(i - 1, "}") || words_[i - 1].in_define ||
            (is(i - 1, "{") && names.is_block(i - 1)) || (i >= 2 && is(i - 1, "(") && words_[i - 2].text == "for") ||
            (i >= 2 && is(i - 1, ":") && is_any_of(words_[i - 2].text, {"public", "private", "protected"}));
        if (begins) declare_from(i);
    }
}

/// The name of the function or lambda whose parameters begin with the bracket at `open`; nowhere if there is none.
std::size_t Variables::name_of_function(std::size_t open) const {
    if (open == 0 || words_[open].in_define) return nowhere;
    if (is_name(words_[open - 1])) {
        const bool is_statement = is_any_of(words_[open - 1].text, {"if", "for", "while", "switch", "catch"});
        return is_statement ? nowhere : open - 1;
    }
    const std::size_t capture = is(open - 1, "]") ? words_[open - 1].partner : nowhere;
    const bool is_named = capture != nowhere && capture >= 2 && is(capture - 1, "=") && is_name(words_[capture - 2]);
    return is_named ? capture - 2 : nowhere;
}

void Variables::find_functions() {
    for (std::size_t open = 0; open < words_.size(); ++open) {
        if (!is(open, "(") || words_[open].partner == nowhere) continue;
        const std::size_t close = words_[open].partner;
        std::size_t body = close + 1;
        while (body < words_.size() && is_any_of(words_[body].text, {"const", "noexcept", "override"})) ++body;
        const std::size_t name = is(body, "{") ? name_of_function(open) : nowhere;
        if (name == nowhere) continue;
        Parameters parameters;
        std::size_t begin = open + 1;
        for (std::size_t end = begin; end <= close; ++end) {
            if (end != close && !(is(end, ",") && words_[end].parent == open)) continue;
            if (end > begin) {
                parameters.emplace_back(begin, end);
                declare_from(begin);
            }
            begin = end + 1;
        }
        parameters_of_body_[body] = {open, close};
        for (std::size_t i = open + 1; i < close; ++i) {
            if (declares_[i]) function_of_parameter_[i] = words_[name].text;
        }
        functions_.try_emplace(words_[name].text, std::move(parameters));
    }
}

/// Opens the scope of the bracket at `open`. Parameters, and what a `for` declares, are in force in the block behind
/// their brackets.
void Variables::open_scope(Scopes& scopes, std::size_t open) const {
    scopes.declared.emplace_back();
    const auto parameters = parameters_of_body_.find(open);
    std::size_t begin = nowhere, end = nowhere;
    if (parameters != parameters_of_body_.end()) {
        std::tie(begin, end) = parameters->second;
    } else if (open > 0 && is(open - 1, ")")) {
        begin = words_[open - 1].partner;
        end = open - 1;
    }
    for (std::size_t i = begin; i < end; ++i) {
        if (declares_[i]) scopes.declare(words_[i].text, i);
    }
}

void Variables::find_meanings() {
    Scopes scopes;
    for (std::size_t i = 0; i < words_.size(); ++i) {
        if (is(i, "{") && !words_[i].in_define) open_scope(scopes, i);
        if (is(i, "}") && !words_[i].in_define) scopes.close();
        if (!is_plain_name(i)) continue;
        const bool in_brackets = words_[i].parent != nowhere && is(words_[i].parent, "(");
        if (declares_[i] && !in_brackets) scopes.declare(words_[i].text, i);
        meaning_[i] = declares_[i] ? i : scopes.find(words_[i].text);
        if (meaning_[i] != nowhere) uses_[meaning_[i]].push_back(i);
    }
}

/// Past a variable with its members and indices: "M[3].x".
std::size_t Variables::past_place(std::size_t at) const {
    std::size_t end = at + 1;
    while (end < words_.size()) {
        if (is(end, "[") && words_[end].partner != nowhere) {
            end = words_[end].partner + 1;
        } else if ((is(end, ".") || is(end, "->")) && end + 1 < words_.size() && is_name(words_[end + 1]) &&
                   !is(end + 2, "(")) {
            end += 2;
        } else {
            break;
        }
    }
    return end;
}

/// ".x" of "hit.x"; empty for "hit". Without indices, and what stands behind them.
std::string Variables::members_after(std::size_t at) const {
    std::string members;
    const std::size_t end = past_place(at);
    for (std::size_t i = at + 1; i < end && !is(i, "["); ++i) {
        if (is_name(words_[i])) members += "." + std::string(words_[i].text);
    }
    return members;
}

bool Variables::is_set_by(std::size_t use) const {
    const std::size_t end = past_place(use);
    if (is(end, "=") || is(end, "+=") || is(end, "-=") || is(end, "*=") || is(end, "/=")) return true;
    if (!declares_[use]) return false;
    const std::size_t parent = words_[use].parent;
    if (parent != nowhere && is(parent, "[")) return true;  // auto [t, u] = …
    return is(use + 1, "(") || is(end, "{");
}

bool Variables::is_changeable(const Parameters& parameters, std::size_t argument) const {
    if (argument >= parameters.size()) return false;
    const auto& [begin, end] = parameters[argument];
    bool refers = false;
    for (std::size_t i = begin; i < end; ++i) {
        if (words_[i].text == "const") return false;
        refers = refers || is(i, "&") || is(i, "*") || is(i, "[");
    }
    return refers;
}

/// Whether a function may set the variable used here: it is a whole argument of one that the source defines with a
/// reference, pointer or array there, or of one that the source does not define if `known_functions` is false.
bool Variables::may_be_changed_as_argument(std::size_t use, bool known_functions) const {
    const std::size_t end = past_place(use);
    const std::size_t begin = use > 0 && is(use - 1, "&") ? use - 1 : use;
    const std::size_t open = words_[use].parent;
    if (begin == 0 || open == nowhere || open == 0 || !is(open, "(") || !is_name(words_[open - 1])) return false;
    if (!(is(begin - 1, "(") || is(begin - 1, ",")) || !(is(end, ")") || is(end, ","))) return false;
    const auto function = functions_.find(words_[open - 1].text);
    if (function == functions_.end()) return !known_functions && !begins_no_type(words_[open - 1].text);
    constexpr std::size_t most_words = 200;  // so that a call with very many arguments takes no time
    if (begin - open > most_words) return false;
    std::size_t argument = 0;
    for (std::size_t i = open + 1; i < begin; ++i) argument += is(i, ",") && words_[i].parent == open ? 1 : 0;
    return is_changeable(function->second, argument);
}

std::vector<Setting> Variables::settings_of(std::size_t at) const {
    const std::size_t declaration = meaning_[at];
    if (declaration == nowhere) return {};
    const bool is_local = words_[declaration].parent != nowhere;
    const std::string members = members_after(at);
    std::vector<Setting> settings;
    const auto add = [&](bool surely, const auto& sets) {
        for (const std::size_t use : uses_.at(declaration)) {
            if (use == at || (is_local && use > at)) continue;
            const std::string of_use = members_after(use);
            const bool is_about = members.starts_with(of_use) || of_use.starts_with(members);
            if (is_about && sets(use)) settings.push_back({use, surely});
        }
    };
    add(true, [&](std::size_t use) { return is_set_by(use); });
    const bool is_set = !settings.empty();
    add(false, [&](std::size_t use) { return !is_set_by(use) && may_be_changed_as_argument(use, is_set); });
    std::sort(settings.begin(), settings.end(), [](const Setting& a, const Setting& b) { return a.at < b.at; });
    return settings;
}

std::vector<std::size_t> Variables::calls_of_parameter(std::size_t at) const {
    const auto function = function_of_parameter_.find(meaning_[at]);
    if (function == function_of_parameter_.end()) return {};
    std::vector<std::size_t> calls;
    for (std::size_t i = 0; i < words_.size(); ++i) {
        if (!is_name(words_[i]) || words_[i].text != function->second || !is(i + 1, "(")) continue;
        // A declaration of the function, and its definition, have its type before its name.
        const bool is_declaration = i > 0 && is_name(words_[i - 1]) && !begins_no_type(words_[i - 1].text);
        if (!is_declaration) calls.push_back(i);
    }
    return calls;
}

}  // namespace harness::source
