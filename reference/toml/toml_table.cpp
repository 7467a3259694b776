#include "reference/toml/toml_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

// With NDEBUG, toml++ 3.3 assumes what it otherwise asserts, even if it depends on the file ("[[[" begins no key); this
// would be undefined behavior. Here its assertions do nothing: it reports the error itself right after.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expr) static_cast<void>(0)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <re2/re2.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "reference/toml/assignment_error.h"
#include "reference/toml/near_names.h"

namespace reference {
namespace {

/// The bytes of `line` from the 1-based column `begin` up to `end`; toml++ counts columns in code points.
std::string_view columns(std::string_view line, std::size_t begin, std::size_t end) {
    const auto byte_of = [&](std::size_t column) {
        std::size_t at = 0;
        for (std::size_t seen = 1; at < line.size() && seen < column; ++seen) {
            ++at;
            while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U) ++at;
        }
        return at;
    };
    const std::size_t first = byte_of(begin);
    return line.substr(first, byte_of(end) - first);
}

std::string_view nth_line(std::string_view text, std::size_t number) {
    for (; number > 1; --number) text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
    return text.substr(0, text.find('\n'));
}

/// The offset of the first character beyond ASCII outside quotes and comments, where TOML allows none. toml++ 3.3 looks
/// such a character up in tables that do not cover all of Unicode, which is undefined behavior ("b = [1, \u0422").
std::optional<std::size_t> stray_character(std::string_view text) {
    // A comment, one of the four kinds of strings, or one character of ASCII.
    static const RE2 token(R"re((?s)#[^\n]*|"""(?:\\.|[^\\])*?(?:"{3,5}|\\?\z)|'''.*?(?:'{3,5}|\z)|)re"
                           R"re("(?:\\.|[^"\\\n])*"?|'[^'\n]*'?|[\x00-\x7F])re",
                           RE2::Latin1);
    re2::StringPiece rest(text.data(), text.size());
    if (text.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);  // the byte-order mark of some editors
    while (RE2::Consume(&rest, token)) {
    }
    if (rest.empty()) return std::nullopt;
    return text.size() - rest.size();
}

std::pair<std::size_t, std::size_t> line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const std::size_t line_begin = before.rfind('\n') + 1;  // 0 in the first line, as npos + 1 is
    return {1 + std::count(before.begin(), before.end(), '\n'), 1 + before.size() - line_begin};
}

}  // namespace

struct TomlDocument::Impl {
    std::string text;
    std::string path;
    toml::table root;
};

struct TomlTable::Impl {
    std::shared_ptr<const TomlDocument::Impl> document;
    const toml::table* table;
    std::string way;  ///< "camera." or "sphere[1]."; empty for the root

    [[noreturn]] void fail_at(std::size_t line, std::string_view key, const std::string& what) const {
        throw AssignmentError(place_at(line, key), fmt::format("{}{}", way, key), what);
    }

    std::string place_at(std::size_t line, std::string_view key) const {
        return fmt::format("{}:{}: {}{}", document->path, std::max<std::size_t>(line, 1), way, key);
    }

    /// The line of the key, or of its table if the key is absent.
    std::size_t line_of(std::string_view key) const {
        const toml::node* node = table->get(key);
        return node == nullptr ? table->source().begin.line : node->source().begin.line;
    }

    const toml::node& required(std::string_view key) const {
        const toml::node* node = table->get(key);
        if (node == nullptr) fail_at(table->source().begin.line, key, fmt::format("is missing; add `{} = ...`", key));
        return *node;
    }

    const toml::array& array(const toml::node& node, std::string_view key, std::size_t count,
                             std::string_view what) const {
        const toml::array* values = node.as_array();
        if (values == nullptr || values->size() != count) {
            fail_at(node.source().begin.line, key, fmt::format("must be an array of {} {}", count, what));
        }
        return *values;
    }

    Decimal decimal(const toml::node& node, std::string_view key) const {
        const toml::source_region& region = node.source();
        if (const auto* whole = node.as_integer()) return *Decimal::parse(std::to_string(whole->get()));
        if (!node.is_floating_point()) fail_at(region.begin.line, key, "must be a number");
        const std::string_view written =
            columns(nth_line(document->text, region.begin.line), region.begin.column, region.end.column);
        const std::optional<Decimal> number = Decimal::parse(written);
        if (!number)
            fail_at(region.begin.line, key,
                    fmt::format("is \"{}\", which is not a finite number; write one in decimal digits", written));
        return *number;
    }

    std::vector<Decimal> decimals(const toml::node& node, std::string_view key, std::size_t count) const {
        std::vector<Decimal> result;
        for (const toml::node& element : array(node, key, count, "numbers")) result.push_back(decimal(element, key));
        return result;
    }

    std::string string(const toml::node& node, std::string_view key) const {
        const auto* text = node.as_string();
        if (text == nullptr) fail_at(node.source().begin.line, key, "must be text in quotes");
        return text->get();
    }
};

void TomlTable::allow_only(const std::vector<std::string_view>& allowed) const {
    for (const auto& [key, node] : *impl_->table) {
        if (std::find(allowed.begin(), allowed.end(), key.str()) != allowed.end()) continue;
        const std::vector<std::string> names(allowed.begin(), allowed.end());
        impl_->fail_at(key.source().begin.line, key.str(),
                       near_names(key.str(), names).empty()
                           ? fmt::format("is not a known key; the keys are {}", fmt::join(names, ", "))
                           : fmt::format("is not a known key; {}", did_you_mean(key.str(), names)));
    }
}

bool TomlTable::has(std::string_view key) const {
    return impl_->table->contains(key);
}
bool TomlTable::is_table(std::string_view key) const {
    return impl_->required(key).is_table();
}

std::vector<std::string> TomlTable::keys() const {
    std::vector<std::string> result;
    for (const auto& [key, node] : *impl_->table) result.emplace_back(key.str());
    return result;
}

TomlTable TomlTable::table(std::string_view key) const {
    const toml::node* node = impl_->table->get(key);
    if (node == nullptr)
        impl_->fail_at(impl_->table->source().begin.line, key,
                       fmt::format("is missing; add a table [{}{}]", impl_->way, key));
    if (!node->is_table()) impl_->fail_at(node->source().begin.line, key, fmt::format("must be a table [{}]", key));
    return TomlTable(
        std::make_shared<Impl>(Impl{impl_->document, node->as_table(), fmt::format("{}{}.", impl_->way, key)}));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
    std::vector<TomlTable> result;
    const toml::node* node = impl_->table->get(key);
    if (node == nullptr) return result;
    const toml::array* elements = node->as_array();
    if (elements == nullptr) impl_->fail_at(node->source().begin.line, key, fmt::format("must be written [[{}]]", key));
    for (const toml::node& element : *elements) {
        const std::string way = fmt::format("{}{}[{}].", impl_->way, key, result.size() + 1);
        if (!element.is_table())
            impl_->fail_at(element.source().begin.line, key, fmt::format("must be written [[{}]]", key));
        result.push_back(TomlTable(std::make_shared<Impl>(Impl{impl_->document, element.as_table(), way})));
    }
    return result;
}

std::string TomlTable::string(std::string_view key) const {
    return impl_->string(impl_->required(key), key);
}

std::string TomlTable::moment_text(std::string_view key) const {
    const toml::node& node = impl_->required(key);
    if (!node.is_date_time()) return impl_->string(node, key);
    std::ostringstream text;
    text << node.as_date_time()->get();
    return text.str();
}

std::vector<std::string> TomlTable::strings(std::string_view key) const {
    const toml::node& node = impl_->required(key);
    const toml::array* elements = node.as_array();
    if (elements == nullptr) impl_->fail_at(node.source().begin.line, key, "must be an array of texts in quotes");
    std::vector<std::string> result;
    for (const toml::node& element : *elements) result.push_back(impl_->string(element, key));
    return result;
}

Decimal TomlTable::decimal(std::string_view key) const {
    return impl_->decimal(impl_->required(key), key);
}

std::vector<Decimal> TomlTable::decimals(std::string_view key, std::size_t count) const {
    return impl_->decimals(impl_->required(key), key, count);
}

std::vector<std::vector<Decimal>> TomlTable::decimal_rows(std::string_view key, std::size_t rows,
                                                          std::size_t columns) const {
    std::vector<std::vector<Decimal>> result;
    for (const toml::node& row : impl_->array(impl_->required(key), key, rows, "points")) {
        result.push_back(impl_->decimals(row, key, columns));
    }
    return result;
}

std::vector<std::vector<Decimal>> TomlTable::decimal_rows(std::string_view key, std::size_t columns) const {
    const toml::node& node = impl_->required(key);
    const toml::array* rows = node.as_array();
    if (rows == nullptr) impl_->fail_at(node.source().begin.line, key, "must be an array of arrays of numbers");
    std::vector<std::vector<Decimal>> result;
    for (const toml::node& row : *rows) result.push_back(impl_->decimals(row, key, columns));
    return result;
}

int TomlTable::integer(std::string_view key, int least, int most) const {
    const toml::node& node = impl_->required(key);
    const auto* whole = node.as_integer();
    if (whole == nullptr || whole->get() < least || whole->get() > most) {
        impl_->fail_at(node.source().begin.line, key, fmt::format("must be a whole number from {} to {}", least, most));
    }
    return static_cast<int>(whole->get());
}

double TomlTable::amount(std::string_view key, double least, double most) const {
    const double value = decimal(key).to_double();
    if (!(least <= value && value <= most)) {
        fail(key, fmt::format("must be from {} to {}", least, most));
    }
    return value;
}

bool TomlTable::boolean(std::string_view key) const {
    const toml::node& node = impl_->required(key);
    const auto* truth = node.as_boolean();
    if (truth == nullptr) impl_->fail_at(node.source().begin.line, key, "must be true or false");
    return truth->get();
}

std::string TomlTable::place(std::string_view key) const {
    return impl_->place_at(impl_->line_of(key), key);
}

void TomlTable::fail(std::string_view key, const std::string& what) const {
    impl_->fail_at(impl_->line_of(key), key, what);
}

TomlDocument::TomlDocument(std::string_view text, const std::filesystem::path& path) {
    if (const std::optional<std::size_t> stray = stray_character(text)) {
        const auto [line, column] = line_and_column(text, *stray);
        throw AssignmentError(
            fmt::format("{}:{}:{}: not valid TOML: only quoted texts and comments may have non-ASCII letters",
                        path.string(), line, column));
    }
    try {
        impl_ = std::make_shared<Impl>(Impl{std::string(text), path.string(), toml::parse(text, path.string())});
    } catch (const toml::parse_error& error) {
        const bool is_large = error.description().find("not representable in 64 bits") != std::string_view::npos;
        throw AssignmentError(fmt::format("{}:{}:{}: not valid TOML: {}{}", path.string(), error.source().begin.line,
                                          error.source().begin.column, error.description(),
                                          is_large ? "; write large numbers with an exponent, as in 1e30" : ""));
    }
}

TomlDocument::~TomlDocument() = default;

TomlTable TomlDocument::root() const {
    return TomlTable(std::make_shared<TomlTable::Impl>(TomlTable::Impl{impl_, &impl_->root, ""}));
}

}  // namespace reference
