// What turns a source into output: one for a run of raygrade.
#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/build.h"
#include "harness/header_shelf.h"
#include "harness/limit_settings.h"
#include "harness/sandbox/sandbox.h"
#include "harness/store.h"

namespace harness {

struct Workshop {
    std::unique_ptr<const Sandbox> sandbox;
    std::string why_no_stronger;  ///< what failed in the stronger tiers that were tried; empty when none did
    BuildSettings build;
    Limits run;
    std::string toolchain{};                       ///< see toolchain_fingerprint; empty when nothing is kept
    std::unique_ptr<Store> store{};                ///< null when nothing is kept
    std::unique_ptr<const HeaderShelf> headers{};  ///< null when everything is compiled plainly
    int repetitions = 1;                           ///< how often each program is run, to see if it answers the same
    bool sanitize = false;                         ///< with a second build of each under the sanitizers
    bool fresh = false;                            ///< what is kept is not looked at, only kept anew
    std::filesystem::path cache{};                 ///< for settle()
    std::future<std::string> look{};               ///< at the compiler, still under way; valid until settle()
};

struct WorkshopOptions {
    std::string sandbox = "auto";                  ///< auto, bwrap or landlock
    bool unsafe = false;                           ///< go on with limits alone where no sandbox holds
    std::vector<std::string> limits;               ///< "run.cpu_seconds=4"
    std::optional<std::filesystem::path> cache{};  ///< where results and precompiled headers are kept; empty: nowhere
    int repetitions = 1;
    bool sanitize = false;
    bool fresh = false;  ///< run everything anew
};

/// The toolchain_fingerprint of the compiler for open_workshop: some ten thousand headers are looked at, which is worth
/// to begin before anything else. Nothing where nothing is kept, or no compiler can say what it is.
std::future<std::string> begin_look_at_compiler(const WorkshopOptions& options);

/// The same for open_workshop_by_last_look.
std::future<std::string> begin_next_look_at_compiler(const WorkshopOptions& options);

/// Tries which sandbox this machine holds and reads the limits. Throws HarnessError, AssignmentError and LimitError.
Workshop open_workshop(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits,
                       std::future<std::string> toolchain);
Workshop open_workshop(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits);

/// As open_workshop, but does not wait for the look at the compiler: it goes by what the last one found. Nothing is
/// kept before settle(), whose answer decides whether what was made until then is believed.
Workshop open_workshop_by_last_look(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits,
                                    std::future<std::string> toolchain);

/// Waits for the look at the compiler. False when it is another, or has other headers, than at the last look: then the
/// workshop is by now as it should have been, and everything made in it is to be made again.
bool settle(Workshop& workshop);

/// Under what the store keeps a run of this source: a fingerprint of everything that decides what is printed, and of
/// `variant`, which of several runs it is.
std::string execution_key(const std::string& source, const Workshop& workshop, const std::string& variant);

/// For every report of marks that were made without a sandbox; empty when there was one.
std::string sandbox_warning(Tier tier);

/// The same on stderr, before the first submission, and why a stronger sandbox than the one in use does not hold.
void tell_of_the_sandbox(const Workshop& workshop, const WorkshopOptions& options);

}  // namespace harness
