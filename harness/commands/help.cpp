#include <fmt/format.h>
#include <fmt/ranges.h>
#include <re2/re2.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "harness/commands/help_format.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"
#include "harness/machine/parts.h"
#include "harness/mark/diagnose/mistakes.h"
#include "harness/run/limits.h"
#include "harness/text/escape.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

constexpr const char* limits = "limits";
constexpr const char* mistakes = "mistakes";

constexpr const char* manual = "share/raygrade/manual";
constexpr const char* manual_as_html = "share/doc/raygrade/html";

/// The names of the manual's pages; empty if the manual is missing, so that the commands' help still works.
std::vector<std::string> manual_pages() {
    std::vector<std::string> names;
    try {
        for (const auto& entry : fs::directory_iterator(find_part(manual))) {
            if (entry.path().extension() == ".md") names.push_back(entry.path().stem().string());
        }
    } catch (const HarnessError&) {
        return {};
    }
    std::ranges::sort(names);
    return names;
}

/// Removes the comments, which say why the tests do not run a command.
std::string manual_page(const std::string& name) {
    constexpr std::size_t most_bytes = 1 << 20;
    std::string page = read_bounded(find_part(manual) / (name + ".md"), most_bytes, Links::follow).bytes;
    static const RE2 comment("<!--[^>]*-->\\n?");
    RE2::GlobalReplace(&page, comment, "");
    return page;
}

/// "Grade a class", from the page's first line, "# Grade a class".
std::string title_of(const std::string& page) {
    const std::string first = page.substr(0, page.find('\n'));
    return first.starts_with("# ") ? first.substr(2) : "";
}

std::string limits_text() {
    constexpr std::size_t column_of_limits = 31;
    std::string text =
        "The limits on programs and on the compiler, with their defaults.\nChange them in an assignment under "
        "[limits.run] and [limits.compile], or for\none command with --limit NAME=VALUE.\n\n";
    for (const LimitDescription& limit : describe_limits())
        text += help_entry(fmt::format("  {:<21} {:>5}", limit.name, limit.value), limit.consequence, column_of_limits);
    return text;
}

/// The named mistakes by item, in the order of the questions. Items of the default questions also have their number.
std::string mistakes_text() {
    constexpr std::size_t column_of_hints = 30;
    std::string text =
        "The named mistakes by item, with the hint that students see. An assignment can\ngive points for one under "
        "[rubric.mistakes], e.g. \"far root\" = 0.5.\n";
    const auto title = [](const reference::ItemId& id) {
        const auto& specs = reference::default_items();
        const auto asked = std::ranges::find(specs, id, &reference::ItemSpec::id);
        const std::string_view full_name = reference::item_of(id).full_name;
        return asked == specs.end() ? std::string(full_name)
                                    : fmt::format("{}.{} ({})", asked->question, asked->name, full_name);
    };
    std::vector<reference::ItemId> items;
    for (const Mistake& mistake : all_mistakes()) {
        if (std::ranges::find(items, mistake.item) == items.end()) items.push_back(mistake.item);
    }
    for (const reference::ItemId& item : items) {
        text += fmt::format("\n{}\n", title(item));
        std::vector<std::string_view> told;  // one mistake may have several stages
        for (const Mistake& each : all_mistakes()) {
            if (each.item != item || std::ranges::find(told, each.name) != told.end()) continue;
            told.push_back(each.name);
            text += help_entry(fmt::format("  {}", each.name), std::string(each.advice), column_of_hints);
        }
    }
    return text;
}

void list_topics(const CLI::App& app) {
    constexpr std::size_t column = 22;
    const auto line = [](const std::string& name, const std::string& about) {
        fmt::print("{}", help_entry("  " + name, about, column));
    };
    fmt::print("raygrade help TOPIC shows one of these topics.\n\nCommands, as with raygrade COMMAND --help:\n\n");
    for (const CLI::App* command : app.get_subcommands({})) line(command->get_name(), command->get_description());
    fmt::print("\nOther topics and pages of the manual:\n\n");
    line(limits, "The limits on programs and on the compiler");
    line(mistakes, "The named mistakes, with their hints");
    for (const std::string& name : manual_pages()) line(name, title_of(manual_page(name)));
}

/// The command that the words name from `app` on; null if there is none.
const CLI::App* find_command(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App* found = &app;
    for (const std::string& word : words) {
        const auto below = found->get_subcommands({});
        const auto next = std::ranges::find(below, word, [](const CLI::App* command) { return command->get_name(); });
        if (next == below.end()) return nullptr;
        found = *next;
    }
    return found;
}

int help(const CLI::App& app, const std::vector<std::string>& words) {
    if (words.empty()) {
        list_topics(app);
        return all_graded;
    }
    const std::string topic = fmt::format("{}", fmt::join(words, " "));
    if (const CLI::App* command = find_command(app, words)) {
        fmt::print("{}", help_of(*command, way_to(*command), CLI::AppFormatMode::Normal));
        return all_graded;
    }
    const std::vector<std::string> pages = manual_pages();
    if (topic == limits) {
        fmt::print("{}", limits_text());
    } else if (topic == mistakes) {
        fmt::print("{}", mistakes_text());
    } else if (std::ranges::find(pages, topic) != pages.end()) {
        fmt::print("{}", manual_page(topic));
    } else {
        std::vector<std::string> topics = pages;
        topics.insert(topics.end(), {limits, mistakes});
        for (const CLI::App* command : app.get_subcommands({})) topics.push_back(command->get_name());
        throw UsageError(
            fmt::format("unknown topic \"{}\"; {}", escape_control(topic), reference::did_you_mean(topic, topics)));
    }
    return all_graded;
}

}  // namespace

Subcommand help_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("help", "Show help on a command, limits, named mistakes, or a manual page");
    const auto words = std::make_shared<std::vector<std::string>>();
    const auto html = std::make_shared<bool>(false);
    command.add_option("topic", *words, "A topic; without one, list the topics")->type_name("TOPIC");
    command.add_flag("--html", *html, "Print the path of the HTML manual");
    command.footer(
        "Examples: raygrade help grade\n          raygrade help assignment check\n          raygrade help limits\n"
        "          xdg-open \"$(raygrade help --html)\"");
    return {&command, [&app, words, html] {
                if (!*html) return help(app, *words);
                fmt::print("{}\n", find_part(manual_as_html / fs::path("index.html")).string());
                return static_cast<int>(all_graded);
            }};
}

}  // namespace harness
