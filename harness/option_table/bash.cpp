#include <fmt/format.h>

#include "harness/option_table/table.h"

namespace harness::option_table {
namespace {

/// What begins at a word that is neither an option's value nor an option: commands, or an argument's choices.
std::string words_of(const Command& command) {
    std::string words;
    for (const Command& below : command.commands) words += below.name() + " ";
    for (const Option& argument : command.arguments) {
        for (const std::string& choice : argument.choices) words += choice + " ";
    }
    return words;
}

std::string options_of(const Command& command) {
    std::string words;
    for (const Option& option : command.options) {
        for (const std::string& name : option.names) words += name + " ";
    }
    return words;
}

/// The cases of "command option" that take a value.
std::string value_cases(const Command& command) {
    std::string cases;
    for (const Option& option : command.options) {
        if (option.value.empty()) continue;
        std::string patterns;
        for (const std::string& name : option.names)
            patterns += (patterns.empty() ? "" : " | ") + fmt::format("'{} {}'", command.path, name);
        std::string choices;
        for (const std::string& choice : option.choices) choices += choice + " ";
        cases += fmt::format("        {})\n            choices='{}'\n            is_value=yes\n            ;;\n",
                             patterns, choices);
    }
    return cases;
}

}  // namespace

std::string bash_completion(const Command& program) {
    std::string paths;
    std::string values;
    std::string commands;
    for (const Command* command : with_all_below(program)) {
        if (command != &program) paths += (paths.empty() ? "" : " | ") + fmt::format("'{}'", command->path);
        values += value_cases(*command);
        commands += fmt::format("        '{}')\n            options='{}'\n            words='{}'\n            ;;\n",
                                command->path, options_of(*command), words_of(*command));
    }
    // Where nothing is offered, bash offers files (-o default).
    return "# Completion of raygrade for bash, generated from the program's options.\n"
           "_raygrade() {\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
           "    local command=raygrade options='' words='' choices='' is_value='' i\n"
           "    COMPREPLY=()\n"
           "    for ((i = 1; i < COMP_CWORD; i++)); do\n"
           "        case \"$command ${COMP_WORDS[i]}\" in\n"
           "        " +
           paths +
           ") command+=\" ${COMP_WORDS[i]}\" ;;\n"
           "        esac\n"
           "    done\n"
           "    # Bash takes --option=value for three words.\n"
           "    if [[ $current == = ]]; then\n"
           "        current=''\n"
           "    elif [[ $before == = ]]; then\n"
           "        before=${COMP_WORDS[COMP_CWORD - 2]}\n"
           "    fi\n"
           "    case \"$command $before\" in\n" +
           values +
           "    esac\n"
           "    case \"$command\" in\n" +
           commands +
           "    esac\n"
           "    if [[ $is_value ]]; then\n"
           "        words=$choices\n"
           "    elif [[ $current == -* ]]; then\n"
           "        words=$options\n"
           "    fi\n"
           "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
           "}\n"
           "complete -o bashdefault -o default -F _raygrade raygrade\n";
}

}  // namespace harness::option_table
