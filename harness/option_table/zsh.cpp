#include <fmt/format.h>

#include "harness/option_table/table.h"

namespace harness::option_table {
namespace {

/// For a text between single quotes, in which a backslash goes before each of `special`.
std::string quoted(const std::string& text, std::string_view special) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
            continue;
        }
        if (special.find(c) != std::string_view::npos) result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

constexpr std::string_view in_a_specification = "\\[]:";

/// ":NAME:action", which says what the value may be.
std::string value(const Option& option) {
    std::string action = "_files";
    if (!option.choices.empty()) {
        action = "(";
        for (const std::string& choice : option.choices) action += choice + " ";
        action.back() = ')';
    }
    return fmt::format(":{}:{}", quoted(option.value, in_a_specification), action);
}

std::string specification(const Option& option) {
    const bool takes_value = !option.value.empty();
    std::string all;
    std::string names;
    for (const std::string& name : option.names) {
        const char* joint = !takes_value ? "" : name.starts_with("--") ? "=" : "+";
        all += (all.empty() ? "" : " ") + name;
        names += (names.empty() ? "" : ",") + name + joint;
    }
    if (option.names.size() > 1) names = "{" + names + "}";
    const std::string before = option.is_repeated ? "'*'" : "'(" + all + ")'";
    return fmt::format("        {}{}'[{}]{}'", before, names, quoted(option.about, in_a_specification),
                       takes_value ? value(option) : "");
}

std::string function_name(const Command& command) {
    std::string name = "_" + command.path;
    for (char& c : name) c = c == ' ' ? '_' : c;
    return name;
}

/// A function that completes what follows the command.
std::string function(const Command& command) {
    std::string text = function_name(command) + "() {\n";
    std::string arguments;
    for (const Option& option : command.options) arguments += " \\\n" + specification(option);
    if (command.commands.empty()) {
        for (const Option& argument : command.arguments)
            arguments += fmt::format(" \\\n        '{}{}'", argument.is_repeated ? "*" : "", value(argument));
        return text + "    _arguments -s" + arguments + "\n}\n";
    }
    std::string list;
    std::string cases;
    for (const Command& below : command.commands) {
        list += fmt::format("        '{}:{}'\n", below.name(), quoted(below.about, "\\:"));
        cases += fmt::format("        {}) {} ;;\n", below.name(), function_name(below));
    }
    return text +
           "    local context state state_descr line\n"
           "    local -a commands\n"
           "    typeset -A opt_args\n"
           "    commands=(\n" +
           list +
           "    )\n"
           "    _arguments -C" +
           arguments +
           " \\\n        '1: :->command' \\\n        '*:: :->arguments'\n"
           "    case $state in\n"
           "    command) _describe -t commands command commands ;;\n"
           "    arguments)\n"
           "        case $line[1] in\n" +
           cases +
           "        esac\n"
           "        ;;\n"
           "    esac\n"
           "}\n";
}

}  // namespace

std::string zsh_completion(const Command& program) {
    std::string text = "#compdef raygrade\n# Completion of raygrade for zsh, generated from the program's options.\n";
    for (const Command* command : with_all_below(program)) text += "\n" + function(*command);
    return text +
           "\nif [ \"$funcstack[1]\" = _raygrade ]; then\n    _raygrade \"$@\"\nelse\n    compdef _raygrade "
           "raygrade\nfi\n";
}

}  // namespace harness::option_table
