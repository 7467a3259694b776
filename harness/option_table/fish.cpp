#include <fmt/format.h>

#include "harness/option_table/table.h"

namespace harness::option_table {
namespace {

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result + "'";
}

std::string choices_of(const Option& option) {
    std::string choices;
    for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : " ") + choice;
    return choices;
}

std::string lines_of(const Command& command) {
    const std::string start = "complete -c raygrade -n " + quoted("__raygrade_at " + command.path);
    std::string text;
    for (const Option& option : command.options) {
        text += start;
        for (const std::string& name : option.names)
            text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        if (!option.choices.empty()) {
            text += " -x -a " + quoted(choices_of(option));
        } else if (!option.value.empty()) {
            text += " -r";
        }
        text += " -d " + quoted(option.about) + "\n";
    }
    for (const Command& below : command.commands)
        text += start + " -f -a " + below.name() + " -d " + quoted(below.about) + "\n";
    for (const Option& argument : command.arguments) {
        if (!argument.choices.empty()) text += start + " -f -a " + quoted(choices_of(argument)) + "\n";
    }
    return text;
}

}  // namespace

std::string fish_completion(const Command& program) {
    std::string paths;
    std::string lines;
    for (const Command* command : with_all_below(program)) {
        paths += " " + quoted(command->path);
        lines += lines_of(*command);
    }
    return "# Completion of raygrade for fish, generated from the program's options.\n"
           "# Whether the words before the cursor name this command.\n"
           "function __raygrade_at\n"
           "    set -l command raygrade\n"
           "    for word in (commandline -opc)[2..-1]\n"
           "        if contains -- \"$command $word\"" +
           paths +
           "\n            set command \"$command $word\"\n"
           "        end\n"
           "    end\n"
           "    test \"$command\" = \"$argv\"\n"
           "end\n" +
           lines;
}

}  // namespace harness::option_table
