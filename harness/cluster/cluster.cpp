#include "harness/cluster/cluster.h"

#include <fmt/format.h>

#include <string_view>
#include <system_error>

#include "harness/cluster/scripts.h"
#include "harness/machine/bounded_file.h"
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

/// The first words of every script: what the plan says.
std::string settings(const Plan& plan) {
    return "#!/usr/bin/env bash\n# Written by `raygrade cluster`. Write it anew rather than change it.\nset -u\n" +
           setting("work", plan.work.string()) + setting("raygrade", plan.raygrade.string()) +
           setting("folder", plan.folder.string()) + setting("results", plan.results.string()) +
           fmt::format("shards={}\n", plan.shards);
}

/// What `fingerprint` of the folder says; empty if there is none.
std::string kept_fingerprint(const fs::path& file) {
    std::error_code error;
    return fs::exists(file, error) ? read_bounded(file, 1024, Links::refuse).bytes : "";
}

void give_up_parts(const fs::path& folder) {
    // Not iterated while entries go.
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder / "parts")) old.push_back(entry.path());
    for (const fs::path& part : old) fs::remove(part);
}

}  // namespace

std::string quoted(const std::string& word) {
    if (word.find_first_of("\n\r") != std::string::npos || word.find('\0') != std::string::npos) {
        throw UsageError(escape_control(word) + ": has a line break, and no script is written with one; rename it");
    }
    return in_shell_quotes(word);
}

SlurmLimits limits_for(const Work& work, SlurmLimits asked) {
    const auto shards = static_cast<std::size_t>(work.shards);
    const auto share = static_cast<std::int64_t>((work.submissions + shards - 1) / shards);
    const std::int64_t rounds = (share + asked.cpus - 1) / asked.cpus;
    const std::chrono::milliseconds each = work.scenes * (work.compile + work.runs * work.run) + work.sanitized;
    constexpr int to_start = 10;  // reading the class, the sandbox's check, headers
    if (asked.minutes == 0) {
        asked.minutes = static_cast<int>(std::chrono::ceil<std::chrono::minutes>(rounds * each).count()) + to_start;
    }
    constexpr std::uint64_t mib = 1024 * 1024;
    constexpr std::uint64_t of_raygrade = 1024;
    if (asked.memory_mib == 0) {
        asked.memory_mib = of_raygrade + static_cast<std::uint64_t>(asked.cpus) * (work.memory_bytes / mib);
    }
    return asked;
}

std::vector<Script> slurm_scripts(const Plan& plan, const SlurmLimits& limits) {
    std::vector<std::string> partition;
    if (!limits.partition.empty()) partition.push_back("--partition=" + limits.partition);
    std::vector<std::string> asked = partition;
    asked.push_back(fmt::format("--time={}", limits.minutes));
    asked.push_back(fmt::format("--mem={}M", limits.memory_mib));
    asked.push_back(fmt::format("--cpus-per-task={}", limits.cpus));
    std::vector<std::string> options = plan.options;
    options.push_back(fmt::format("--jobs={}", limits.cpus));
    const auto script = [&](const char* name, const std::string& words, std::string_view text) {
        return Script{name, settings(plan) + words + std::string(text)};
    };
    return {script("shard", list("class", plan.classes) + list("options", options), scripts::shard),
            script("merge", list("merge_options", plan.merge_options), scripts::merge),
            script("status", "", scripts::status),
            script("submit", list("limits", asked) + list("merge_limits", partition), scripts::submit)};
}

void write_scripts(const Plan& plan, const std::vector<Script>& scripts, OldParts old_parts) {
    const fs::path kept = plan.folder / "fingerprint";
    const FolderUse use{"the scripts of a cluster", "--scripts"};
    const bool has_old = look_into(plan.folder, {"fingerprint"}, "parts", use) == Holds::earlier_results;
    if (has_old && old_parts == OldParts::keep && kept_fingerprint(kept) != plan.fingerprint) {
        throw UsageError(fmt::format(
            "{}: holds parts of a different class, assignment or options; grade all again with --again, or name "
            "another folder with --scripts",
            plan.folder.string()));
    }
    make_folder(plan.folder, "parts", use.option);
    if (has_old && old_parts == OldParts::give_up) give_up_parts(plan.folder);
    make_folder(plan.folder, "logs", use.option);
    write_file(kept, plan.fingerprint);
    for (const Script& script : scripts) write_file(plan.folder / script.name, script.text);
}

}  // namespace harness::cluster
