#include "harness/variants/rewritten/scene_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <vector>

#include "harness/build/include_block.h"
#include "harness/sandbox/host/command.h"
#include "harness/variants/rewritten/early_read.h"

namespace harness::variants {
namespace {

/// An entry of the table. The copy declares the same structure and reads the member with the literal's type, so that a
/// number is rounded once, as the compiler rounds a literal.
struct Cell {
    double as_double = 0;
    float as_float = 0;
    int as_int = 0;
};

std::string_view member_of(const source::Constant& constant) {
    if (constant.is_integer) return "as_int";
    if (constant.suffix.empty()) return "as_double";
    return constant.suffix == "f" ? "as_float" : "";
}

std::size_t cells_of(const source::SceneLiteral& literal) {
    return literal.splat ? 3 : 1;
}

/// How many cells the table has; 0 if there is none.
std::size_t table_size(const source::SceneLiterals& found) {
    std::size_t cells = 0;
    for (const source::SceneLiteral& literal : found.literals) {
        if (member_of(literal.constant).empty()) return 0;
        cells += cells_of(literal);
    }
    return cells * sizeof(Cell) <= longest_input ? cells : 0;
}

/// Defines the table, and fills it before the program's own initialisers run. It includes no header, and gives read() a
/// different name, so that a source can use that name.
std::string definition(std::size_t cells) {
    return fmt::format(
        "static struct {{ double as_double; float as_float; int as_int; }} raygrade_scene[{}]; "
        "extern \"C\" __PTRDIFF_TYPE__ raygrade_read(int, void*, __SIZE_TYPE__) __asm__(\"read\"); "
        "__attribute__((constructor(101))) static void raygrade_fill() {{ "
        "char* at = (char*)raygrade_scene; __SIZE_TYPE__ left = sizeof raygrade_scene; "
        "while (left > 0) {{ const __PTRDIFF_TYPE__ size = raygrade_read(0, at, left); if (size <= 0) break; "
        "at += size; left -= (__SIZE_TYPE__)size; }} }}",
        cells);
}

/// One or three elements of a list. The sign makes each a value like a literal, and not a variable.
std::string read_from_table(std::size_t first_cell, const source::SceneLiteral& literal) {
    std::string all;
    for (std::size_t cell = first_cell; cell < first_cell + cells_of(literal); ++cell) {
        all += all.empty() ? "" : ", ";
        all += fmt::format("(+::raygrade_scene[{}].{})", cell, member_of(literal.constant));
    }
    return all;
}

/// The value of the text that `spell` wrote for the constant; empty if the constant's type cannot represent it.
std::optional<Cell> cell_of(std::string_view number, const source::Constant& like) {
    Cell cell;
    const auto reads = [&](auto& value) {
        return std::from_chars(number.data(), number.data() + number.size(), value).ec == std::errc();
    };
    const bool fits = like.is_integer       ? reads(cell.as_int)
                      : like.suffix.empty() ? reads(cell.as_double)
                                            : reads(cell.as_float);
    return fits ? std::optional(cell) : std::nullopt;
}

}  // namespace

std::optional<std::string> with_table(std::string_view source, const source::SceneLiterals& found) {
    const std::size_t size = table_size(found);
    if (size == 0 || may_be_read_early(source, found)) return {};
    const std::vector<Directive> block = include_block(source);
    const std::size_t place = block.empty() ? 0 : block.back().end;
    const auto line = 1 + std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    std::string text;
    std::size_t at = 0, cell = 0;
    const auto copy_to = [&](std::size_t end) {
        if (at <= place && place < end) {
            text.append(source.substr(at, place - at));
            text += fmt::format("\n{}\n#line {}\n", definition(size), line);
            at = place;
        }
        text.append(source.substr(at, end - at));
    };
    for (const source::SceneLiteral& literal : found.literals) {
        copy_to(literal.begin);
        text += read_from_table(cell, literal);
        cell += cells_of(literal);
        at = literal.end;
    }
    copy_to(source.size());
    return text;
}

std::optional<std::string> table_of(const source::SceneLiterals& found, const source::DecimalScene& other) {
    if (table_size(found) == 0) return {};
    std::string table;
    for (const source::SceneLiteral& literal : found.literals) {
        const auto numbers = source::numbers_in_place(literal, other);
        if (!numbers) return {};
        for (const std::string& number : *numbers) {
            const auto cell = cell_of(number, literal.constant);
            if (!cell) return {};
            table.append(reinterpret_cast<const char*>(&*cell), sizeof *cell);
        }
    }
    return table;
}

}  // namespace harness::variants
