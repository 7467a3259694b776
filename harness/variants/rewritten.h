// Submissions with another scene in their source: each rewritten, compiled, run and marked like one of its own.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "harness/grade.h"
#include "harness/timeline.h"
#include "harness/variants/scene_literals.h"
#include "harness/workshop.h"

namespace harness::variants {

/// A scene with its key, for all submissions in which the same parts were located.
struct MarkedScene {
    reference::SceneVariant scene;
    std::shared_future<Marking> marking;
};

/// `base` with another scene. Empty when there is no certified key, such as for a rubric whose tolerance is too narrow
/// for this scene.
std::optional<MarkedScene> with_key(reference::SceneVariant scene, const Marking& base);

/// A submission on one other scene.
struct SceneRun {
    const MarkedScene* scene;
    std::optional<Graded> graded;  ///< empty where a number does not fit the place where the source has it
};

/// Why nothing can be said of the program on that scene, as a clause; empty where it ran, however it ended.
std::string why_not_tried(const SceneRun& run);

/// What came of one submission.
struct Rewritten {
    std::size_t index;  ///< of the submission
    SceneLiterals literals;
    std::vector<SceneRun> runs;  ///< in the order of the scenes
};

/// The scenes for a submission of which these parts were located; they stay where they are until run_rewritten returns.
using ScenesFor = std::function<const std::vector<MarkedScene>&(std::size_t index, const PartSet& located)>;

/// Whether the submission has anything to be compared on other scenes.
bool has_right_answer(const Graded& graded);

/// Tries every submission that has a right answer; `sources` are those of `graded`. Each source is compiled and run as
/// any other and kept like it; repetitions and sanitizers are the workshop's, so the caller turns them off.
/// `conclude` is called in the order of the class. What goes wrong for one, also in `scenes_for` and `conclude`, keeps
/// no other from being tried and takes no marks: it becomes a note, and our_fault where it is raygrade's.
void run_rewritten(std::vector<Graded>& graded, const std::vector<std::string>& sources, const DecimalScene& scene,
                   const Workshop& workshop, int jobs, Timeline& timeline, const ScenesFor& scenes_for,
                   const std::function<void(Rewritten)>& conclude);

/// The parts that `scene` has otherwise than `other`, in words: "eye = (3, -2, 5), radius = 2".
std::string described(const DecimalScene& scene, const DecimalScene& other);

/// The names of the parts that the scene has and the source was not found to state.
std::vector<std::string> parts_not_found(const DecimalScene& scene, const PartSet& located);

}  // namespace harness::variants
