// Runs submissions on other scenes: each source is rewritten to state the scene, then compiled, run and marked like any
// submission.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/grade/scene_memo.h"
#include "harness/record/graded.h"
#include "harness/record/marking.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"
#include "harness/source/scene/scene_literals.h"

namespace harness::variants {

/// A scene with its key. All submissions in which the same parts were located share it.
struct MarkedScene {
    reference::Variant scene;
    std::shared_ptr<const Marking> marking;
    std::shared_ptr<SceneMemo> memo;  ///< of scenes in sources
};

/// Makes the marking of `base` for each of these scenes. Empty if a scene has no certified key, e.g. because the
/// rubric's tolerance is too narrow for it.
std::vector<std::optional<MarkedScene>> with_keys(const std::vector<reference::Variant>& scenes, const Marking& base);

/// A submission on one other scene.
struct SceneRun {
    const MarkedScene* scene;
    std::optional<Graded> graded;  ///< empty if a number does not fit its place in the source
};

/// A clause that says why the program was not run on that scene; empty if it ran, however it ended.
std::string why_not_tried(const SceneRun& run);

/// The runs of one submission.
struct Rewritten {
    std::size_t index;  ///< the submission's place in the class
    source::SceneLiterals literals;
    std::vector<SceneRun> runs;  ///< in the order of the scenes
};

/// Returns the scenes for a submission in which the parts `located` were found. The reference must stay valid until
/// run_rewritten returns.
using ScenesFor = std::function<const std::vector<MarkedScene>&(std::size_t index, const source::PartSet& located)>;

/// Whether the submission has a right answer, so that there is something to compare on other scenes.
bool has_right_answer(const Graded& graded);

/// Which submissions are tried on which scenes, and how the runs are used.
struct Trial {
    ScenesFor scenes_for;
    std::function<void(Rewritten)> conclude;
    std::function<bool(const Graded&)> concerns = has_right_answer;
};

/// Tries every submission that a trial concerns; `sources` are those of `graded`, and `marking` is that of the class. A
/// source is compiled once for all its scenes where that does what compiling it for each does (scene_table.h); else it
/// is rewritten, compiled, run and cached for each scene like any other. The runner's repetitions and sanitizers apply
/// here too, so the caller turns them off. Each trial is concluded in the order of the class, before the next trial of
/// the same submission. A failure for one submission, also in `scenes_for` and `conclude`, does not stop the others and
/// changes no marks. The submission gets a note, and our_fault if the fault is raygrade's.
void run_rewritten(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                   const Runner& runner, int jobs, Timeline& timeline, const std::vector<Trial>& trials);

/// The parts in which `scene` differs from `other`, in words: "eye = (3, -2, 5), radius = 2".
std::string described(const source::DecimalScene& scene, const source::DecimalScene& other);

/// The names of the parts of the scene that were not located in the source.
std::vector<std::string> parts_not_found(const source::DecimalScene& scene, const source::PartSet& located);

}  // namespace harness::variants
