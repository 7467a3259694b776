#include "harness/prepare/deal.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "harness/prepare/trial_scenes.h"
#include "reference/numbers/splitmix.h"
#include "reference/toml/assignment_error.h"
#include "reference/toml/scene_toml.h"

namespace harness::prepare {
namespace {

using DecimalScene = reference::Scene<reference::Decimal>;

/// A seed per student, so that a scene does not depend on who else is in the class.
std::uint64_t seed_for(const std::string& student, std::uint64_t seed) {
    for (const char byte : student) {
        seed ^= static_cast<unsigned char>(byte);
        seed = reference::next_random_bits(seed);
    }
    return seed;
}

/// The best of some scenes that are not in `taken`, a set of scenes as TOML. Empty if there is none.
std::optional<DecimalScene> search(TrialScenes& trials, const DecimalScene& own, const std::set<std::string>& taken) {
    constexpr int most_tries = 200, enough = 20;
    std::optional<DecimalScene> best;
    std::size_t best_worth = 0;
    for (int i = 0; i < most_tries && !(best && (best_worth >= trials.own_worth() || i >= enough)); ++i) {
        DecimalScene scene = trials.changed(own);
        if (taken.contains(reference::scene_toml(scene))) continue;
        const std::optional<ShownMistakes> shown = trials.try_scene(scene);
        if (!shown || (best && worth(*shown) <= best_worth)) continue;
        best_worth = worth(*shown);
        best = std::move(scene);
    }
    return best;
}

/// The keys of a [[student]] table: those in which the student's scene differs from the assignment's.
class Changes {
  public:
    void add(std::string_view key, const auto& value, const auto& own) {
        add(key, reference::toml_value(value), reference::toml_value(own));
    }
    void add(std::string_view key, const std::string& value, const std::string& own) {
        if (value != own) text_ += fmt::format("{} = {}\n", key, value);
    }
    std::string text() && { return std::move(text_); }

  private:
    std::string text_;
};

}  // namespace

std::map<std::string, DecimalScene> deal(const reference::Assignment& assignment,
                                         const std::vector<std::string>& students, const DealOptions& options) {
    std::map<std::string, DecimalScene> scenes;
    std::set<std::string> taken{reference::scene_toml(assignment.scene)};
    for (const auto& [student, scene] : assignment.dealt) taken.insert(reference::scene_toml(scene));
    TrialScenes trials(assignment);
    for (std::size_t i = 0; i < students.size(); ++i) {
        if (options.progress) options.progress(static_cast<double>(i) / static_cast<double>(students.size()));
        if (const auto kept = assignment.dealt.find(students[i]); kept != assignment.dealt.end()) {
            scenes.insert(*kept);
            continue;
        }
        trials.begin(seed_for(students[i], options.seed));
        const auto scene = search(trials, assignment.scene, taken);
        if (!scene) {
            throw reference::AssignmentError(fmt::format(
                "{}: found no scene without borderline hits for \"{}\". Try another --seed, or start from a scene that "
                "`raygrade assignment propose` finds.",
                assignment.name, students[i]));
        }
        taken.insert(reference::scene_toml(*scene));
        scenes.emplace(students[i], *scene);
    }
    return scenes;
}

std::string student_toml(const std::string& student, const DecimalScene& scene, const DecimalScene& own) {
    Changes changes;
    changes.add("camera.eye", scene.camera.eye, own.camera.eye);
    changes.add("camera.lookat", scene.camera.lookat, own.camera.lookat);
    changes.add("camera.vup", scene.camera.vup, own.camera.vup);
    const auto pixel = [](const DecimalScene& of) { return fmt::format("[{}, {}]", of.pixel.x, of.pixel.y); };
    changes.add("window.pixel", pixel(scene), pixel(own));
    reference::for_each_kind(
        [&](reference::Subject kind, const auto& objects, const auto& own_objects) {
            if (own_objects.empty()) return;
            reference::for_each_field(
                [&](std::string_view key, const auto& value, const auto& own_value) {
                    changes.add(fmt::format("{}.{}", to_string(kind), key), value, own_value);
                },
                objects.front(), own_objects.front());
        },
        scene, own);
    // A JSON string is also a TOML string.
    return fmt::format("[[student]]\nid = {}\n{}", nlohmann::json(student).dump(), std::move(changes).text());
}

}  // namespace harness::prepare
