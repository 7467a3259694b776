// The commands of the program with their options and texts, as data: what man pages and completions are made from.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace harness::option_table {

/// An option, or an argument that is known by its place.
struct Option {
    std::vector<std::string> names;    ///< "-a", "--assignment"; an argument has one name without dashes
    std::string value;                 ///< what stands for its value, "FILE"; empty for a flag
    std::vector<std::string> choices;  ///< the only values there are; empty if others are allowed
    std::string range;                 ///< "1 - 1024"; empty if not bounded
    std::string standard;              ///< the value without the option; empty for none
    std::string about;
    bool is_required = false;
    bool is_repeated = false;  ///< may be given several times
};

struct Command {
    std::string path;  ///< "raygrade assignment check"
    std::string about;
    std::string footer;  ///< empty if it has none of its own
    std::vector<Option> options;
    std::vector<Option> arguments;
    std::vector<Command> commands;  ///< those below it

    std::string name() const { return path.substr(path.rfind(' ') + 1); }
};

/// The table of `app` and of all below it.
Command read_table(const CLI::App& app);

/// The command and all below it, each before those below it.
std::vector<const Command*> with_all_below(const Command& command);

/// A file that is generated.
struct File {
    std::string name;  ///< "raygrade-assignment-check.1"
    std::string text;
};

/// A page for each command. `version` is "raygrade 0.7.0".
std::vector<File> man_pages(const Command& program, const std::string& version);

// What completes the program's command line in a shell, as a script that the shell reads.
std::string bash_completion(const Command& program);
std::string zsh_completion(const Command& program);
std::string fish_completion(const Command& program);

}  // namespace harness::option_table
