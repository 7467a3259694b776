#include "harness/cluster/cluster.h"

#include <fmt/format.h>

#include <string_view>

#include "harness/cluster/scripts.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/text/escape.h"
#include "harness/text/shell_word.h"

namespace harness::cluster {
namespace {

namespace fs = std::filesystem;

std::string list(std::string_view name, const std::vector<std::string>& words) {
    std::string text = fmt::format("{}=(", name);
    for (const std::string& word : words) text += (text.back() == '(' ? "" : " ") + quoted(word);
    return text + ")\n";
}

std::string setting(std::string_view name, const std::string& value) {
    return fmt::format("{}={}\n", name, quoted(value));
}

/// The first lines of every script: the settings of the plan.
std::string settings(const Plan& plan) {
    return "#!/usr/bin/env bash\n# Written by `raygrade cluster`. Do not edit; run that command again.\nset -u\n" +
           setting("work", plan.work.string()) + setting("raygrade", plan.raygrade.string()) +
           setting("folder", plan.folder.string()) + setting("results", plan.results.string()) +
           list("class", plan.classes) + list("options", plan.options) + fmt::format("shards={}\n", plan.shards);
}

}  // namespace

std::string quoted(const std::string& word) {
    if (word.find_first_of("\n\r") != std::string::npos || word.find('\0') != std::string::npos) {
        throw UsageError(escape_control(word) + " has a line break, which the scripts cannot contain; rename it");
    }
    return in_shell_quotes(word);
}

void write_scripts(const Plan& plan) {
    const std::string start = settings(plan);
    const fs::path submit = plan.folder / "submit";
    const FolderUse use{"scripts of raygrade cluster", "--scripts"};
    if (look_into(plan.folder, {"submit"}, "parts", use) == Holds::earlier_results) {
        throw UsageError(
            fmt::format("{} has the scripts and parts of an earlier class. Continue it with bash {}, or name another "
                        "folder with --scripts",
                        plan.folder.string(), shell_word(submit.string())));
    }
    make_folder(plan.folder, "parts", use.option);
    make_folder(plan.folder, "logs", use.option);
    write_file(plan.folder / "shard", start + std::string(scripts::shard));
    write_file(plan.folder / "merge", start + std::string(scripts::merge));
    write_file(plan.folder / "status", start + std::string(scripts::status));
    write_file(submit, start + std::string(scripts::submit));
}

}  // namespace harness::cluster
