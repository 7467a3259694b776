#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/say.h"
#include "harness/text/listed.h"
#include "reference/key/key_formats.h"

namespace harness {

namespace {

struct ReferenceOptions {
    std::string assignment;
    std::string precision = "certified";  ///< float, double or certified
    std::string format = "text";          ///< text or json
};

reference::Precision precision_of(const std::string& name) {
    for (const auto precision :
         {reference::Precision::float_, reference::Precision::double_, reference::Precision::certified}) {
        if (reference::to_string(precision) == name) return precision;
    }
    throw std::logic_error("a precision the command line let through: " + name);
}

/// Each reason once, with the items that have another right answer for it. The JSON lists these answers.
void tell_other_answers(const reference::AnswerKey& key) {
    std::vector<std::string> reasons;
    std::map<std::string, std::vector<std::string>> items;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items) {
            for (std::size_t i = 1; i < item.answers.size(); ++i) {
                const std::string reason = reference::reason(item.answers[i], key);
                if (!items.contains(reason)) reasons.push_back(reason);
                items[reason].push_back(fmt::format("{}.{}", question.number, item.spec.name));
            }
        }
    }
    for (const std::string& reason : reasons) {
        say("note: {} {} another right answer: {}\n", listed(items[reason]), items[reason].size() == 1 ? "has" : "have",
            reason);
    }
}

int print_reference(const ReferenceOptions& options) {
    const reference::Assignment assignment = load_as_graded(options.assignment);
    const reference::AnswerKey key = reference::make_key(assignment, precision_of(options.precision));
    fmt::print("{}", options.format == "json" ? reference::to_json(key) : reference::to_text(key));
    for (const std::string& note : key.notes) say("note: {}\n", note);
    if (options.format != "json") tell_other_answers(key);
    return all_graded;
}

void add_options(CLI::App& command, ReferenceOptions& options) {
    add_scene(command, options.assignment);
    command.add_option("-p,--precision", options.precision, "The arithmetic")
        ->check(CLI::IsMember({"float", "double", "certified"}))
        ->capture_default_str();
    command.add_option("-f,--format", options.format, "text as a correct program prints it, or JSON (raygrade/key/1)")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    command.footer("Example: raygrade reference --assignment a6-edge --format json");
}

}  // namespace

Subcommand reference_command(CLI::App& app) {
    return subcommand(app, "reference", "Print the right answers, as text or as JSON", add_options, print_reference);
}

}  // namespace harness
