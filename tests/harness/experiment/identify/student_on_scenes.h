// A student's program, its printouts on the assignment's scene and on two others, and what an experiment makes of them.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/experiment/identify/identify.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/match/match.h"
#include "harness/source/scene/scene_part.h"
#include "harness/variants/generate.h"
#include "tests/given/student/program.h"
#include "tests/given/student/scenes.h"

namespace harness::experiment {

/// What a program prints, whatever the scene.
using Layout = std::function<std::string(const student::Program&)>;

struct OtherScene {
    reference::Assignment assignment;
    reference::AnswerKey key;
};

class StudentOnScenes {
  public:
    explicit StudentOnScenes(std::string_view scene) : marking_(student::scene_named(scene)) {
        source::PartSet all;
        for (const source::ScenePart part : source::all_parts()) all.insert(part);
        for (const reference::Variant& variant : variants::scenes_with_all_hit(marking_.assignment, all, 2)) {
            reference::Assignment assignment = marking_.assignment;
            assignment.scene = variant.scene;
            auto key = reference::make_key(assignment, reference::Precision::certified);
            others_.push_back(std::make_unique<OtherScene>(std::move(assignment), std::move(key)));
        }
    }

    struct Result {
        std::string printout;  ///< on the assignment's scene
        Score before;          ///< by the text alone
        ExperimentReport report;
        Score after;
    };

    /// Runs the experiment if an answer is doubtful.
    Result run(const Layout& layout, const student::Way& way = {},
               const std::optional<student::Program::Mistake>& mistake = {}) const {
        Result result;
        result.printout = layout(student::Program(marking_.assignment, way, mistake));
        const Transcript transcript = read(result.printout);
        result.before = marked(result.printout);
        result.after = result.before;
        bool is_doubtful = false;
        for (const QuestionScore& question : result.before.questions)
            is_doubtful = is_doubtful || std::ranges::any_of(question.items, may_be_settled);
        if (!is_doubtful) return result;
        std::vector<Observation> observations;
        for (const auto& other : others_) {
            const student::Program there(other->assignment, way, mistake);
            observations.push_back({read(layout(there)), other->key, other->assignment});
        }
        const std::vector<MatchedItem> matched = match(transcript, asked_items(result.before));
        result.report = identify({transcript, matched, result.before}, observations);
        result.after = score(transcript, marking_.key, marking_.assignment, result.report.places);
        note_experiment(result.after, result.report);
        return result;
    }

    /// By the text alone.
    Score marked(const std::string& printout) const { return score(read(printout), marking_.key, marking_.assignment); }

    /// As the student's program computes it on the assignment's scene.
    student::Program program(const student::Way& way = {},
                             const std::optional<student::Program::Mistake>& mistake = {}) const {
        return {marking_.assignment, way, mistake};
    }

  private:
    Transcript read(const std::string& printout) const {
        return read_transcript(printout, last_question(marking_.assignment.questions));
    }

    student::Marking marking_;
    std::vector<std::unique_ptr<OtherScene>> others_;
};

}  // namespace harness::experiment
