#include "harness/option_table/table.h"

#include <CLI/CLI.hpp>

namespace harness::option_table {
namespace {

/// CLI11 puts a value's name and its checks into one text: "N:INT in [1 - 1024]", "TEXT:{auto,bwrap,landlock}".
void read_type(const std::string& type, Option& option) {
    const std::size_t colon = type.find(':');
    option.value = type.substr(0, colon);
    if (option.value == "UINT" || option.value == "INT") option.value = "N";
    if (colon == std::string::npos) return;
    const std::string check = type.substr(colon + 1);
    if (check.starts_with('{')) {
        option.choices = CLI::detail::split(check.substr(1, check.size() - 2), ',');
    } else if (const std::size_t open = check.find('['); open != std::string::npos) {
        option.range = check.substr(open + 1, check.size() - open - 2);
    }
}

Option read_option(const CLI::Option& from) {
    Option option;
    if (from.get_positional()) {
        option.names = {from.get_name(true)};
    } else {
        for (const std::string& name : from.get_snames()) option.names.push_back("-" + name);
        for (const std::string& name : from.get_lnames()) option.names.push_back("--" + name);
    }
    if (from.get_type_size() != 0) read_type(from.get_type_name(), option);
    option.standard = from.get_default_str();
    option.about = from.get_description();
    option.is_required = from.get_required();
    option.is_repeated = from.get_expected_max() == CLI::detail::expected_max_vector_size;
    return option;
}

Command read_command(const CLI::App& app, const std::string& above) {
    Command command;
    command.path = above.empty() ? app.get_name() : above + " " + app.get_name();
    command.about = app.get_description();
    const CLI::App* parent = app.get_parent();
    // A footer that a command has from the one above is not its own.
    if (parent == nullptr || parent->get_footer() != app.get_footer()) command.footer = app.get_footer();
    for (const CLI::Option* option : app.get_options())
        (option->get_positional() ? command.arguments : command.options).push_back(read_option(*option));
    for (const CLI::App* below : app.get_subcommands({}))
        command.commands.push_back(read_command(*below, command.path));
    return command;
}

}  // namespace

Command read_table(const CLI::App& app) {
    return read_command(app, "");
}

std::vector<const Command*> with_all_below(const Command& command) {
    std::vector<const Command*> all{&command};
    for (const Command& below : command.commands) {
        for (const Command* one : with_all_below(below)) all.push_back(one);
    }
    return all;
}

}  // namespace harness::option_table
