// The record of one submission: how it ended, its score, and everything else that reports use.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/execution/execution.h"
#include "harness/execution/tier.h"
#include "harness/intake/submission.h"
#include "harness/mark/score/score.h"
#include "harness/record/experiment.h"
#include "harness/record/hard_scenes.h"
#include "harness/record/variants.h"

namespace harness {

/// How a submission ended. A program that ended early is still marked on its output.
enum class Outcome {
    graded,
    compile_error,
    crashed,  ///< ended by a signal, or for starting too many processes
    timed_out,
    output_limit,
    memory_limit,
    no_output,   ///< ended by itself without printing anything
    not_graded,  ///< no marks: the submission could not be read, or the machine failed
};

/// The name in reports and in grades.json.
std::string_view to_string(Outcome outcome);

/// Longer outputs and sources are not kept. They can't be shown, and the output can't be reread.
inline constexpr std::size_t longest_kept_printout = std::size_t{64} << 10U;
inline constexpr std::size_t longest_kept_source = std::size_t{64} << 10U;

/// "SIGSEGV", or "signal 40" for a signal without a name.
std::string signal_name(int signal);

/// The setting of the limit that stopped the program, e.g. "run.cpu_seconds"; empty if no limit stopped it.
std::string_view limit_name(Ended ended);

/// A finding that a person should look at. It does not change the mark.
struct Flag {
    /// "nondeterministic", "hard_coded", "other_scene", "scene_of_another", "variants_not_tried", "late_without_date",
    /// "mostly_following" or "reading_doubtful"
    std::string kind;
    std::string evidence;  ///< a sentence; empty for a doubtful reading that depends on the key
};

/// The `item`, with question 0, of an override of the points for other scenes. People write "variants" for it too.
inline constexpr std::string_view variants_place = "variants";

/// The scene that a source states instead of the assignment's. Its wrong answers belong to this scene.
struct OwnScene {
    std::string toml;   ///< the scene's tables in an assignment file
    std::string cause;  ///< "Your source sets center = (1, 1, 1) where the assignment has (1, 1, 0)"
};

/// Replaces an automatic mark. The automatic mark is still shown beside it.
struct Override {
    int question = 0;   ///< the handout's, from 1; 0 for the whole submission or for other scenes
    std::string item;   ///< e.g. "t"; empty for the whole question or submission; or variants_place
    double points = 0;  ///< 0 or more; may exceed the rubric's, e.g. for a good idea
    std::string why;    ///< the instructor's reason, never empty
    std::string by;     ///< who set it
    std::string when;   ///< in UTC, ISO 8601: 2026-11-22T09:30:00Z
};

/// A person's decision about a submission in a review.
struct Decision {
    enum class Kind { accepted, comment, points, reading };
    std::int64_t number = 0;  ///< from 1; decisions made together share a number
    Kind kind = Kind::accepted;
    std::string about;  ///< the kind of the concern that was accepted, else the item: "6.t"; empty for the whole
    std::string seen;   ///< the accepted evidence (seen_in of concerns.h); else empty
    std::string text;   ///< the comment or the reason
    std::string by;
    std::string when;                           ///< in UTC, ISO 8601
    std::optional<Override> replaced_override;  ///< the override in force before a decision on points; empty if there
                                                ///< was none
    std::optional<Reread> replaced_reread;      ///< the same for a decision on a reading
};

/// The name in the gradebook: "accepted", "comment", "override" or "reread".
std::string_view to_string(Decision::Kind kind);

/// A decision and its submission, which may no longer be in the class.
struct KeptDecision {
    std::string submission;
    Decision given;
};

/// How the submission was built and run.
struct ExecutionRecord {
    Outcome outcome = Outcome::not_graded;
    bool our_fault = false;   ///< raygrade failed, not the machine: the submission was not graded, or a note says what
                              ///< is missing
    std::string explanation;  ///< a sentence about the first stage that went wrong; empty if none did
    std::string compiler;     ///< "g++ 12.2.0 (Debian 12.2.0-14+deb12u1)"; empty if an earlier version graded it
    Tier tier = Tier::bwrap;  ///< the sandbox of its programs
    Build build;
    ProcessResult run;                   ///< without the output
    std::string printout;                ///< its output, if not too long; not in the record
    std::string printout_beginning;      ///< the output's first lines, if it is too long
    std::vector<std::string> sanitizer;  ///< findings of a sanitizer build; they cost no points
};

/// The findings about the submission besides its score.
struct Findings {
    std::vector<Flag> flags;
    std::optional<OwnScene> own_scene;            ///< empty if the answers belong to the assignment's scene
    std::optional<ExperimentReport> experiment;   ///< empty if no answer was doubtful, or with --no-experiments
    std::optional<VariantsReport> variants;       ///< with --variants; empty if not tried
    std::optional<HardScenesReport> hard_scenes;  ///< with --stress; empty if not tried
};

/// The instructor's decisions.
struct ReviewRecord {
    std::vector<Override> overrides;  ///< oldest first; final_mark decides which count
    std::vector<Decision> decisions;  ///< those in force, oldest first
};

struct Graded {
    Submission submission;  ///< with its source, if not too long; the record has no source
    ExecutionRecord execution;
    Score score;  ///< all items are missing if nothing was printed
    Findings findings;
    double late_share = 0;  ///< share of its points lost for lateness; 0 if on time
    ReviewRecord review;
};

/// "Read from line 12, as Ada says: the label is misspelled" or "Not printed, as Ada says: that is a debug line".
std::string note_of(const Reread& reread);

/// The compilers of these submissions, without repeats: "g++ 12.2.0 (…), g++ 14.2.0 (…)". A program that lacks an
/// include may compile with one and not with another.
std::string compilers_of(const std::vector<Graded>& graded);

/// Whether an item of the submission was read from the place in the reread.
bool counts(const Graded& graded, const Reread& reread);

}  // namespace harness
