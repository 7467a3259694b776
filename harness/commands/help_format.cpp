#include "harness/commands/help_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace harness {
namespace {

constexpr const char* usual = "Options";
constexpr std::size_t width = 80;

/// "-j, --jobs N"; for an argument without a name its type.
std::string left_of(const CLI::Option& option) {
    std::string type = option.get_type_name();
    type.erase(0, type.find(':') + 1);  // keeps only the choices of TEXT:{auto,bwrap,landlock}
    if (option.get_positional()) return "  " + type;
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return fmt::format("  {}{}", CLI::detail::join(names, ", "), option.get_expected_max() > 0 ? " " + type : "");
}

std::string described(const CLI::Option& option) {
    const std::string& value = option.get_default_str();
    return option.get_description() + (value.empty() ? "" : fmt::format(" (default: {})", value));
}

/// Wraps the lines of prose. The author lays out the others, such as examples.
std::string wrapped(const std::string& footer) {
    std::string text;
    std::istringstream lines(footer);
    for (std::string line; std::getline(lines, line);)
        text += line.size() > width ? help_entry("", line, 0) : line + "\n";
    return text;
}

}  // namespace

std::string help_entry(const std::string& left, const std::string& text, std::size_t column) {
    const std::string next_line = "\n" + std::string(column, ' ');
    std::string result =
        !left.empty() && left.size() + 2 > column ? left + next_line : left + std::string(column - left.size(), ' ');
    std::size_t used = column;
    std::istringstream words(text);
    for (std::string word; words >> word; used += word.size()) {
        const bool is_first = used == column;
        const bool fits = used + 1 + word.size() <= width;
        if (!is_first) result += fits ? " " : next_line;
        used = is_first || !fits ? column : used + 1;
        result += word;
    }
    return result + "\n";
}

std::string way_to(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return (parent == nullptr ? "" : way_to(*parent) + " ") + command.get_name();
}

std::string example_of(const CLI::App& command) {
    const std::string footer = command.get_footer();
    const std::size_t begin = footer.find("raygrade", footer.find("Example"));
    if (begin == std::string::npos) return "";
    return footer.substr(begin, std::min(footer.find('\n', begin), footer.find("   ", begin)) - begin);
}

std::string help_of(const CLI::App& command, const std::string& way, CLI::AppFormatMode mode) {
    constexpr std::size_t column = 25, column_of_commands = 14;
    const auto below = command.get_subcommands({});
    std::string use = way + (below.empty() ? "" : " COMMAND");
    std::string arguments, options, commands;
    int more = 0;
    std::vector<std::string> groups = command.get_groups();
    std::ranges::stable_partition(groups, [](const std::string& group) { return group == usual; });
    for (const std::string& group : groups) {
        std::string entries;
        for (const CLI::Option* option : command.get_options()) {
            const bool is_help = option == command.get_help_ptr() || option == command.get_help_all_ptr();
            if (option->get_group() != group || group.empty() || is_help) continue;
            const std::string text = help_entry(left_of(*option), described(*option), column);
            if (option->get_positional()) {
                use += (option->get_required() ? " " : " [") + option->get_type_name() +
                       (option->get_required() ? "" : "]");
                arguments += text;
            } else if (group == usual || mode == CLI::AppFormatMode::All) {
                entries += text;
            } else {
                ++more;
            }
        }
        if (!entries.empty()) options += fmt::format("\n{}:\n{}", group, entries);
    }
    std::string group;
    for (const CLI::App* each : below) {
        if (each->get_group() != group) commands += (group = each->get_group()) + ":\n";
        commands += help_entry("  " + each->get_name(), each->get_description(), column_of_commands);
    }
    std::string text = help_entry("", command.get_description(), 0) + "\nUsage: " + use + " [OPTIONS]\n";
    if (!arguments.empty()) text += "\n" + arguments;
    text += options;
    if (!commands.empty()) text += "\n" + commands;
    if (more > 0) text += fmt::format("\n`{} --help-all` shows {} more option{}.\n", way, more, more == 1 ? "" : "s");
    return command.get_footer().empty() ? text : text + "\n" + wrapped(command.get_footer());
}

}  // namespace harness
