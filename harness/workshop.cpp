#include "harness/workshop.h"

#include <fmt/format.h>

#include <future>

#include "harness/bounded_file.h"
#include "harness/failure.h"
#include "harness/fingerprint.h"
#include "harness/names.h"
#include "harness/results_folder.h"
#include "harness/sandbox/canary.h"
#include "harness/toolchain.h"

namespace harness {
namespace {

std::optional<Tier> wanted_tier(const std::string& name) {
    if (name == "bwrap") return Tier::bwrap;
    if (name == "landlock") return Tier::landlock;
    return std::nullopt;
}

void add_words(Fingerprint& fingerprint, const std::vector<std::string>& words) {
    fingerprint.add(static_cast<std::int64_t>(words.size()));
    for (const std::string& word : words) fingerprint.add(word);
}

void add_limits(Fingerprint& fingerprint, const Limits& limits) {
    fingerprint.add(limits.cpu.count()).add(limits.wall.count());
    for (const std::uint64_t bytes :
         {limits.memory_bytes, limits.file_bytes, limits.stack_bytes, limits.output_bytes, limits.error_bytes}) {
        fingerprint.add(static_cast<std::int64_t>(bytes));
    }
    fingerprint.add(limits.processes).add(limits.open_files);
}

std::string failures(const std::vector<CanaryReport>& reports) {
    std::string text;
    for (const CanaryReport& report : reports) {
        if (report.held()) continue;
        text += fmt::format("{}{} does not hold ({})", text.empty() ? "" : ", ", to_string(report.tier),
                            printable(report.summary()));
    }
    return text;
}

std::filesystem::path file_of_last_look(const std::filesystem::path& cache) {
    return cache / "toolchain";
}

/// Empty where there was none.
std::string last_look(const std::filesystem::path& cache) {
    constexpr std::size_t length = 64;
    const BoundedFile file = read_bounded(file_of_last_look(cache), length, Links::refuse);
    return file.is_whole() && file.bytes.size() == length ? file.bytes : "";
}

/// It is no more than a guess at what the next one finds, so that it does not matter when it can't be kept.
void remember_look(const std::filesystem::path& cache, const std::string& toolchain) {
    if (last_look(cache) == toolchain) return;
    try {
        write_file(file_of_last_look(cache), toolchain);
    } catch (const HarnessError&) {
        return;
    }
}

std::future<std::string> begin_look(const WorkshopOptions& options, Pace pace) {
    const std::filesystem::path compiler = find_compiler();
    if (!options.cache || compiler.empty()) return {};
    try {
        return begin_toolchain_fingerprint(compiler, pace);
    } catch (const HarnessError&) {
        return {};  // and building says why
    }
}

/// The precompiled headers of that toolchain.
void take_headers(Workshop& workshop, const std::filesystem::path& cache, const std::string& toolchain,
                  Missing missing) {
    workshop.toolchain = toolchain;
    workshop.headers = std::make_unique<const HeaderShelf>(cache, workshop.build, toolchain, *workshop.sandbox,
                                                           ShelfBounds{}, missing);
}

Workshop without_cache(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits) {
    const StageLimits stages = read_limits(limits, options.limits);
    const auto without = options.unsafe ? WithoutSandbox::run_unsafe : WithoutSandbox::refuse;
    BuildSettings build = default_build_settings(stages.compile);
    Choice choice = choose_sandbox(wanted_tier(options.sandbox), without);
    Workshop workshop{std::move(choice.sandbox), failures(choice.reports), std::move(build), stages.run};
    workshop.repetitions = options.repetitions;
    workshop.sanitize = options.sanitize;
    workshop.fresh = options.fresh;
    return workshop;
}

}  // namespace

std::future<std::string> begin_look_at_compiler(const WorkshopOptions& options) {
    return begin_look(options, Pace::is_waited_for);
}

std::future<std::string> begin_next_look_at_compiler(const WorkshopOptions& options) {
    const bool is_first = !options.cache || last_look(*options.cache).empty();
    return begin_look(options, is_first ? Pace::is_waited_for : Pace::beside_other_work);
}

Workshop open_workshop(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits,
                       std::future<std::string> toolchain) {
    Workshop workshop = without_cache(options, limits);
    if (!toolchain.valid()) return workshop;
    take_headers(workshop, *options.cache, toolchain.get(), Missing::is_made);
    workshop.store = std::make_unique<Store>(*options.cache);
    remember_look(*options.cache, workshop.toolchain);
    return workshop;
}

Workshop open_workshop_by_last_look(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits,
                                    std::future<std::string> toolchain) {
    const std::string last = toolchain.valid() ? last_look(*options.cache) : "";
    if (last.empty()) return open_workshop(options, limits, std::move(toolchain));
    Workshop workshop = without_cache(options, limits);
    take_headers(workshop, *options.cache, last, Missing::stays_missing);
    workshop.store = std::make_unique<Store>(*options.cache);
    workshop.store->hold_back();
    workshop.cache = *options.cache;
    workshop.look = std::move(toolchain);
    return workshop;
}

bool settle(Workshop& workshop) {
    if (!workshop.look.valid()) return true;
    const std::string gone_by = workshop.toolchain;
    take_headers(workshop, workshop.cache, workshop.look.get(), Missing::is_made);
    if (workshop.toolchain == gone_by) {
        workshop.store->keep_held();
        return true;
    }
    workshop.store->forget_held();
    remember_look(workshop.cache, workshop.toolchain);
    return false;
}

Workshop open_workshop(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits) {
    return open_workshop(options, limits, begin_look_at_compiler(options));
}

std::string execution_key(const std::string& source, const Workshop& workshop, const std::string& variant) {
    // The purpose's number counts the versions of how we compile and run, as of the environment a program finds.
    Fingerprint fingerprint("raygrade/execution/1");
    fingerprint.add(workshop.toolchain).add(to_string(workshop.sandbox->tier()));
    add_words(fingerprint, workshop.build.flags);
    add_words(fingerprint, workshop.build.linker);
    add_limits(fingerprint, workshop.build.limits);
    add_limits(fingerprint, workshop.run);
    return fingerprint.add(variant).add(source).hex();
}

std::string sandbox_warning(Tier tier) {
    if (tier != Tier::unsafe) return {};
    return "Graded without a sandbox (--unsafe): a submission could have read and changed whatever the account that "
           "graded may, these reports and the answer key among it.";
}

void tell_of_the_sandbox(const Workshop& workshop, const WorkshopOptions& options) {
    if (options.unsafe && workshop.sandbox->tier() != Tier::unsafe) {
        fmt::print(stderr, "note: --unsafe changes nothing here: this machine holds {}, and programs run in it\n",
                   to_string(workshop.sandbox->tier()));
    }
    if (!workshop.why_no_stronger.empty()) {
        fmt::print(stderr, "note: programs run in {}, as {}; see `raygrade doctor`\n",
                   to_string(workshop.sandbox->tier()), workshop.why_no_stronger);
    }
    const std::string warning = sandbox_warning(workshop.sandbox->tier());
    if (!warning.empty()) fmt::print(stderr, "raygrade: warning: {}\n", warning);
}

}  // namespace harness
