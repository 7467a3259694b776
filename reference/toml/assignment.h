// One year's assignment: its scene and how it is marked. Read from a TOML file; the numbers stay exactly as written.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "reference/numbers/decimal.h"
#include "reference/stages/camera.h"
#include "reference/stages/items.h"
#include "reference/stages/scene.h"
#include "reference/toml/appearance.h"
#include "reference/toml/moment.h"

namespace reference {

/// How a hit at exactly t = 0 counts in marking. `either` accepts a hit and a miss, if the answers are consistent.
enum class BoundaryPolicy { positive, nonnegative, either };

/// What a hand-in loses that is so many days late or later.
struct LateStep {
    int days;      ///< started days, 1 or more
    double share;  ///< of its points, 0 to 1
};

/// What a named mistake earns. The code that names mistakes checks the names.
struct MistakePrice {
    std::string name;                 ///< "center forgotten", in American spelling whatever the file's is
    double share;                     ///< of the item's points, 0 to 1; 1 accepts the answer
    std::string place;                ///< for messages: file, line and key
    std::optional<ItemId> item = {};  ///< the only item in which it earns that; empty for every item
};

/// How much a student is told of an answer that is not right; each tells what those before it tell.
enum class Feedback {
    verdict,   ///< the verdict and the points
    hint,      ///< what can be said of the value itself: not a number, of another shape, follows or does not
    mistake,   ///< the known mistake that gives this value
    expected,  ///< the right value
};

/// How the assignment is marked. Every field is an optional key of [rubric] with the default given here.
struct Rubric {
    /// Where in its pixel a ray may start. The first makes the key, the others are accepted too.
    std::vector<PixelConvention> pixel_conventions = {PixelConvention::centre, PixelConvention::grid};
    BoundaryPolicy boundary = BoundaryPolicy::either;
    /// Credit for an answer that follows from an earlier mistake, as a share of its points, 0 to 1.
    double follow_through = 1.0;
    /// The same for an answer that is right for the scene that the student's source states in place of the
    /// assignment's.
    double wrong_scene_credit = 0.5;
    /// The most that all such answers of a submission together may earn, as a share of its points, 0 to 1. Beyond it
    /// each of them earns proportionally less.
    double follow_through_cap = 1.0;
    /// What late hand-ins lose, by days; `late_deduction` of the file is one step for every late hand-in.
    std::vector<LateStep> late;
    /// When the assignment is due, for hand-ins of which a moment is known.
    std::optional<Moment> due;
    /// So much later is still on time.
    int grace_minutes = 0;
    /// Points for answers on other scenes (`grade --variants`), in addition to those of the questions; 0 for none.
    double other_scene_points = 0;
    /// How much a student is told of an answer until the assignment is due; see feedback_at.
    Feedback feedback = Feedback::mistake;
    /// How much from then on; empty for the same. Only with `due`.
    std::optional<Feedback> feedback_after_due;
    /// Half a unit of an answer's last printed decimal is forgiven. An answer with fewer decimals than this counts as
    /// if it had this many. 0 to 9.
    int min_decimals = 2;
    /// In the order of their names. A mistake that is not listed earns nothing.
    std::vector<MistakePrice> mistakes;
    /// Points of a question by its number; questions that are not listed have points_per_question.
    std::map<int, double> points;
    /// Points of single items, by question and item name; the question's points are shared equally without them.
    std::map<int, std::map<std::string, double>> item_points;
    static constexpr double points_per_question = 10.0;

    /// How far an answer may be from the key, in the item's own unit and relative to the item's largest component where
    /// that is above 1: |given - key| <= tolerance * max(1, |key|). It widens the key's allowance and may not be
    /// narrower; without one the allowance alone counts.
    std::optional<double> tolerance;
    /// The same for a question or a single item: "6" or "6.t".
    std::map<std::string, double> item_tolerance;

    double points_of(int question) const;
    /// The most specific tolerance given: the item's, else the question's, else `tolerance`; empty for none.
    std::optional<double> tolerance_of(int question, const std::string& item) const;
};

/// "verdict"
std::string_view to_string(Feedback feedback);

/// How much a student is told at this time. Within the grace minutes a hand-in is still on time, so that
/// `feedback_after_due` begins after them.
Feedback feedback_at(const Rubric& rubric, std::chrono::system_clock::time_point clock);

/// A limit of [limits] as it was read. The code that enforces the limits checks their names.
struct LimitEntry {
    std::string name;   ///< "run.cpu_seconds"
    double value;       ///< finite
    std::string place;  ///< for messages: file, line and key
};

/// A further scene for the same program. It tells computed answers from constants that the program prints.
struct OtherScene {
    std::string name;  ///< for people
    Scene<Decimal> scene;
};

struct Assignment {
    std::string name;   ///< the file's name without ".toml"
    std::string title;  ///< for people
    Scene<Decimal> scene;
    std::vector<Question> questions = default_questions();  ///< by number; no item is asked twice
    Rubric rubric;
    std::vector<LimitEntry> limits;    ///< in the file's order
    std::vector<OtherScene> variants;  ///< in the file's order; each is complete, with what it leaves unchanged
    /// Where each student has a scene of their own: the scenes by the student's id; else empty.
    std::map<std::string, Scene<Decimal>> dealt;
    /// What is allowed in the scene but unusual: a mirrored window. Whole sentences.
    std::vector<std::string> notes;
    Appearance appearance;  ///< for pictures; nothing in marking reads it
};

/// The largest size of a component.
double largest_component(const std::vector<double>& key_value);

/// What a tolerance is relative to: the largest component of the key's value, or 1 where that is below 1.
double unit_of(const std::vector<double>& key_value);

/// The assignment can't be used. what() is a complete message: file, line, key, what is wrong and how to fix it.
class AssignmentError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
    /// About a key: its place "file:line: sphere[1].radius", its path there and what is wrong with it.
    AssignmentError(const std::string& place, std::string key, std::string problem)
        : std::runtime_error(place + ": " + problem), key_(std::move(key)), problem_(std::move(problem)) {}

    /// "sphere[1].radius"; empty if the error is about no key.
    const std::string& key() const { return key_; }
    /// "is -2, and must be above 0"; empty if the error is about no key.
    const std::string& problem() const { return problem_; }

  private:
    std::string key_;
    std::string problem_;
};

/// Reads an assignment from TOML text; `path` names it in messages. Throws AssignmentError.
Assignment parse_assignment(std::string_view toml, const std::filesystem::path& path);

/// What this student is asked, with no scenes of others. Throws AssignmentError, with similar ids, if no scene was
/// dealt to them.
Assignment of_student(const Assignment& assignment, const std::string& id);

/// Finds and reads an assignment: an existing file, or else the name of one in `directory` (with or without ".toml").
/// "file.toml@s07" is what the student s07 is asked. Throws AssignmentError; if the name does not exist, the message
/// lists the existing names.
Assignment load_assignment(const std::string& name_or_file, const std::filesystem::path& directory);

/// Reads a scene file: an assignment that may leave out window.pixel, since nothing is asked about it; its pixel is
/// then the middle one. Throws AssignmentError.
Assignment load_scene(const std::filesystem::path& file);

/// The file of an assignment before it is parsed, for callers that keep its text.
struct AssignmentFile {
    std::filesystem::path path;  ///< canonical
    std::string toml;            ///< its text, for parse_assignment
};

/// Finds the same file as load_assignment and reads its text. Throws AssignmentError likewise.
AssignmentFile read_assignment_file(const std::string& name_or_file, const std::filesystem::path& directory);

}  // namespace reference
