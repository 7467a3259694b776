#include "harness/grade/own_scene_score.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>

#include "harness/mark/score/mark_transcript.h"
#include "harness/match/match.h"
#include "harness/source/scene/stated_scene.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/scene_toml.h"

namespace harness {
namespace {

/// The marking with `scene` instead of the assignment's scene; null if the scene cannot be marked.
std::shared_ptr<const Marking> marking_on(const reference::Scene<reference::Decimal>& scene, const Marking& marking) {
    try {
        reference::Assignment other = marking.assignment;
        other.scene = reference::check_scene(scene, "the scene in the source");
        return std::make_shared<const Marking>(make_marking(std::move(other)));
    } catch (const reference::AssignmentError&) {
        return nullptr;
    } catch (const std::domain_error&) {
        return nullptr;
    }
}

bool has_wrong_answer(const Score& score) {
    return std::any_of(score.questions.begin(), score.questions.end(), [](const QuestionScore& question) {
        return std::any_of(question.items.begin(), question.items.end(), [](const ItemScore& item) {
            return item.verdict == ItemVerdict::wrong || item.verdict == ItemVerdict::follow;
        });
    });
}

/// Whether the first answer, which depends only on pixel and window, belongs to the assignment.
bool took_given_pixel(const Score& score) {
    return std::any_of(score.questions.begin(), score.questions.end(), [](const QuestionScore& question) {
        return std::any_of(question.items.begin(), question.items.end(), [](const ItemScore& item) {
            return item.spec.id == reference::item::P_VCS && item.verdict == ItemVerdict::right;
        });
    });
}

std::ptrdiff_t right_answers(const Score& score) {
    std::ptrdiff_t sum = 0;
    for (const QuestionScore& question : score.questions) {
        sum += std::count_if(question.items.begin(), question.items.end(),
                             [](const ItemScore& item) { return item.verdict == ItemVerdict::right; });
    }
    return sum;
}

}  // namespace

std::optional<OwnSceneScore> score_on_own_scene(const Score& score, const std::string& output, std::string_view source,
                                                const Marking& marking, std::span<const ItemPlace> places,
                                                SceneMemo* memo) {
    if (!has_wrong_answer(score)) return std::nullopt;
    auto stated_scenes = source::stated_scenes(source, marking.assignment.scene);
    if (took_given_pixel(score)) {
        const reference::Pixel given = marking.assignment.scene.pixel;
        std::erase_if(stated_scenes, [&](const source::StatedScene& stated) { return stated.scene.pixel != given; });
    }
    if (stated_scenes.empty()) return std::nullopt;
    const Transcript transcript = read_transcript(output, last_question(marking.assignment.questions));
    const std::vector<MatchedItem> matched = match(transcript, asked_items(score), places);
    std::optional<OwnSceneScore> best;
    std::ptrdiff_t most_right = 0;
    for (const source::StatedScene& stated : stated_scenes) {
        const auto make = [&] { return marking_on(stated.scene, marking); };
        const auto there = memo ? memo->on_scene(stated.scene, make) : make();
        if (!there) continue;
        const Score own = mark_answers(matched, there->key, there->assignment);
        OwnScene scene{reference::scene_toml(stated.scene), describe(stated.parts)};
        auto explained = explained_by_scene(score, own, scene.cause, marking.assignment.rubric);
        const std::ptrdiff_t right = right_answers(own);
        if (!explained || right <= most_right) continue;
        most_right = right;
        best = OwnSceneScore{std::move(*explained), std::move(scene)};
        if (!has_wrong_answer(own)) break;
    }
    return best;
}

std::vector<AnswersOfAnother> flag_answers_of_others(std::vector<Graded>& graded, const Marking& marking) {
    constexpr std::ptrdiff_t telling = 3;
    std::vector<AnswersOfAnother> found;
    if (marking.of_student.empty()) return found;
    for (Graded& result : graded) {
        if (result.execution.printout.empty() || !has_wrong_answer(result.score)) continue;
        const Marking& own = own_marking(marking, result.submission);
        const Transcript transcript =
            read_transcript(result.execution.printout, last_question(own.assignment.questions));
        const std::vector<MatchedItem> matched = match(transcript, asked_items(result.score));
        std::ptrdiff_t most = answers_of(matched, own.key, own.assignment) + telling - 1;
        std::optional<std::string> of;  // whose scene
        const auto consider = [&](const Marking& other, const std::string& student) {
            const std::ptrdiff_t there = answers_of(matched, other.key, other.assignment);
            if (there <= most) return;
            most = there;
            of = student;
        };
        for (const auto& [student, other] : marking.of_student) consider(*other, student);
        consider(marking, "");
        if (!of) continue;
        result.findings.flags.push_back(
            {"scene_of_another", "They are right for a different scene than this student's."});
        found.push_back({result.submission.id, *of});
    }
    return found;
}

Score score_again_on(const OwnScene& scene, const Score& score, const Transcript& transcript, const Marking& marking,
                     std::span<const ItemPlace> places) {
    const auto stated = reference::parse_assignment(scene.toml, "the scene in the source");
    const auto there = marking_on(stated.scene, marking);
    if (!there) return score;
    const std::vector<MatchedItem> matched = match(transcript, asked_items(score), places);
    const Score own = mark_answers(matched, there->key, there->assignment);
    return explained_by_scene(score, own, scene.cause, marking.assignment.rubric).value_or(score);
}

}  // namespace harness
