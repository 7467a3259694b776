// Man pages, in roff's man macros.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "harness/option_table/table.h"

namespace harness::option_table {
namespace {

/// Text that roff prints as it is: of `-`, `'`, `` ` ``, `^` and `~` it would make typographic signs, so that a command
/// could not be copied from the page.
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '\\': result += "\\e"; break;
            case '-': result += "\\-"; break;
            case '\'': result += "\\(aq"; break;
            case '`': result += "\\(ga"; break;
            case '^': result += "\\(ha"; break;
            case '~': result += "\\(ti"; break;
            case '.':  // at a line's start it would begin a macro
                if (result.empty() || result.back() == '\n') result += "\\&";
                result += c;
                break;
            default: result += c;
        }
    }
    return result;
}

/// Text that roff fills, in short lines as roff's own programs like them.
std::string filled(const std::string& text) {
    constexpr std::size_t most = 70;
    std::string result;
    std::string line;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > most) {
            result += roff(line) + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return result + roff(line) + "\n";
}

std::string bold(const std::string& text) {
    return "\\fB" + roff(text) + "\\fR";
}

std::string italic(const std::string& text) {
    return "\\fI" + roff(text) + "\\fR";
}

std::string with_dashes(std::string path) {
    for (char& c : path) {
        if (c == ' ') c = '-';
    }
    return path;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

std::string value_of(const Option& option) {
    return option.choices.empty() ? option.value : joined(option.choices, "|");
}

std::string as_sentence(const std::string& text) {
    return text.empty() || text.ends_with('.') ? text : text + ".";
}

std::string entry(const Option& option, const std::string& head) {
    std::string about = as_sentence(option.about);
    if (!option.range.empty()) about += " Allowed: " + option.range + ".";
    if (!option.standard.empty()) about += " Default: " + option.standard + ".";
    if (option.is_repeated && !option.is_required) about += " May be given several times.";
    return fmt::format(".TP\n{}\n{}", head, filled(about));
}

std::string options_section(const Command& command) {
    std::string text;
    for (const Option& argument : command.arguments)
        text += entry(argument, italic(argument.names.front()) +
                                    (argument.value.empty() ? "" : " (" + roff(value_of(argument)) + ")"));
    for (const Option& option : command.options) {
        std::string names;
        for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
        text += entry(option, names + (option.value.empty() ? "" : " " + italic(value_of(option))));
    }
    return ".SH OPTIONS\n" + text;
}

std::string synopsis(const Command& command) {
    std::string text = bold(command.path) + " [" + italic("OPTIONS") + "]";
    for (const Option& argument : command.arguments) {
        const std::string name = italic(argument.names.front()) + (argument.is_repeated ? "..." : "");
        text += argument.is_required ? " " + name : " [" + name + "]";
    }
    if (!command.commands.empty()) text += " " + italic("COMMAND");
    return text;
}

/// Paragraphs between blank lines. One with a line that is indented keeps its lines.
std::string paragraphs(const std::string& text) {
    std::string result;
    std::string paragraph;
    std::istringstream lines(text + "\n\n");
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty()) {
            paragraph += line + "\n";
        } else if (!paragraph.empty()) {
            const bool is_table = paragraph.starts_with(' ') || paragraph.find("\n ") != std::string::npos;
            result +=
                (result.empty() ? "" : ".PP\n") + (is_table ? ".nf\n" + roff(paragraph) + ".fi\n" : filled(paragraph));
            paragraph.clear();
        }
    }
    return result;
}

/// The examples stand at the end of a command's help, after this word.
struct Footer {
    std::string text, examples;
};

Footer split_examples(const std::string& footer) {
    for (const std::string word : {"Example: ", "Examples: "}) {
        if (const std::size_t at = footer.find(word); at != std::string::npos)
            return {footer.substr(0, at), footer.substr(at + word.size())};
    }
    return {footer, ""};
}

std::string examples_section(const std::string& examples) {
    if (examples.empty()) return "";
    std::string text = ".SH EXAMPLES\n.nf\n";
    std::istringstream lines(examples);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t start = line.find_first_not_of(' ');
        if (start != std::string::npos) text += roff(line.substr(start)) + "\n";
    }
    return text + ".fi\n";
}

std::string commands_section(const Command& command) {
    if (command.commands.empty()) return "";
    std::string text = ".SH COMMANDS\n";
    for (const Command& below : command.commands)
        text += fmt::format(".TP\n{}\n{}", bold(below.path), filled(as_sentence(below.about)));
    return text;
}

std::string see_also(const Command& command, const Command& program) {
    std::string text;
    for (const Command* other : with_all_below(program)) {
        const bool is_related = command.path == program.path || other->path == program.path ||
                                other->path.starts_with(command.path + " ") ||
                                command.path.starts_with(other->path + " ");
        if (other == &command || !is_related) continue;
        text += (text.empty() ? "" : ",\n") + bold(with_dashes(other->path)) + "(1)";
    }
    return ".SH SEE ALSO\n" + text + "\n.PP\n" + bold(with_dashes("raygrade manual")) + "(7) and " +
           bold("raygrade help") + " list the pages of the manual.\n";
}

std::string upper(std::string text) {
    for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return text;
}

std::string page(const Command& command, const Command& program, const std::string& version) {
    const std::string name = with_dashes(command.path);
    const bool is_program = &command == &program;
    // The program's text is a sentence on it, then examples of its commands; its footer is the exit status.
    const std::size_t sentence = is_program ? command.about.find("\n\n") : command.about.size();
    std::string about = command.about.substr(0, sentence);
    for (char& c : about) c = c == '\n' ? ' ' : c;
    const std::string usual = is_program ? command.about.substr(std::min(sentence, command.about.size())) : "";
    const Footer footer = is_program ? Footer{} : split_examples(command.footer);
    std::string exit_status = program.footer;
    if (const std::string word = "Exit status: "; exit_status.starts_with(word)) exit_status.erase(0, word.size());
    return ".\\\" Generated from the program's options.\n" +
           fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n", roff(upper(name)), roff(version)) +
           ".ad l\n" +  // not justified: a long list of choices has no place to stretch
           fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(about)) + ".SH SYNOPSIS\n" + synopsis(command) + "\n" +
           ".SH DESCRIPTION\n" + paragraphs(as_sentence(about) + "\n\n" + footer.text) + commands_section(command) +
           options_section(command) + ".SH EXIT STATUS\n" + paragraphs(exit_status) +
           examples_section(is_program ? usual : footer.examples) + see_also(command, program);
}

}  // namespace

std::vector<File> man_pages(const Command& program, const std::string& version) {
    std::vector<File> pages;
    for (const Command* command : with_all_below(program))
        pages.push_back({with_dashes(command->path) + ".1", page(*command, program, version)});
    return pages;
}

}  // namespace harness::option_table
