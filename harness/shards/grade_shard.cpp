#include "harness/shards/grade_shard.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "harness/gradebook/record.h"
#include "harness/machine/errors.h"
#include "harness/machine/fingerprint.h"
#include "harness/machine/fresh_file.h"
#include "harness/run/runner.h"
#include "harness/shards/part.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// A fingerprint of the submissions. It does not depend on the folder in which a machine has the class.
std::string fingerprint_of(const std::vector<Submission>& submissions) {
    Fingerprint fingerprint("raygrade/class/1");
    for (const Submission& submission : submissions) {
        Graded graded;
        graded.submission = submission;
        graded.submission.file = submission.file.filename();
        if (submission.problem) graded.submission.problem = "has one";  // its text may name the folder
        const auto record = to_record(graded);
        fingerprint.add(std::string_view(reinterpret_cast<const char*>(record.data()), record.size()));
    }
    return fingerprint.hex();
}

/// A fingerprint of the student lists, given now or kept in the results: names decide which scene was dealt to whom.
std::string fingerprint_of(const Rosters& rosters, const Gradebook& gradebook) {
    Fingerprint fingerprint("raygrade/student-lists/1");
    const auto add = [&](const std::optional<KeptInput>& given, const char* name) {
        const auto used = given ? given : gradebook.input(name);
        fingerprint.add(used ? used->choice : "").add(used ? used->content : "");
    };
    add(rosters.canvas_given, canvas_roster_input);
    add(rosters.moodle_given, moodle_worksheet_input);
    add(rosters.late_given, late_days_input);
    return fingerprint.hex();
}

/// The conditions of this grading. The most informative ones come first, because the message names the first that
/// differs.
nlohmann::ordered_json conditions_of(const ClassRun& run, const ClassInputs& inputs,
                                     const std::string& class_fingerprint, const Gradebook& gradebook,
                                     const GradingOptions& options) {
    const auto yes_or_no = [](bool is_so) { return is_so ? "yes" : "no"; };
    const auto& scenes = options.variants;
    return {{"raygrade", RAYGRADE_VERSION},
            {"compiler", run.runner.toolchain.fingerprint},
            {"sandbox", to_string(run.runner.sandbox->tier())},
            {"assignment", fmt::format("{} {}", run.marking.assignment.name,
                                       Fingerprint("raygrade/assignment/1").add(inputs.file.toml).hex())},
            {"class", class_fingerprint},
            {"set of student lists", fingerprint_of(inputs.rosters, gradebook)},
            {"set of limits and compiler flags", execution_key("", run.runner, "")},
            {"--repeat", std::to_string(options.runner.repetitions)},
            {"--sanitize", yes_or_no(options.runner.sanitize)},
            {"--variants", scenes.count == 0 ? "none" : fmt::format("{} from seed {}", scenes.count, scenes.seed)},
            {"--stress", yes_or_no(options.hard_scenes)},
            {"--no-experiments", yes_or_no(!options.runner.experiments)}};
}

/// Takes the shard's submissions out of the class.
std::vector<Submission> share_of(std::vector<Submission> submissions, const Shard& shard) {
    const std::vector<int> shards = split(submissions, shard.count);
    std::vector<Submission> share;
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        if (shards[i] == shard.number) share.push_back(std::move(submissions[i]));
    }
    return share;
}

}  // namespace

int grade_shard(ClassInputs inputs, const Shard& shard, const ResultsOptions& options, const fs::path& merge_into,
                const GradingOptions& grading) {
    make_folder(fs::absolute(options.out).parent_path(), "");
    require_can_write({options.out, "--out", "part of a class", part_schema});
    Part part;
    part.head.shard = shard;
    part.head.class_size = inputs.submissions.size();
    const std::string class_fingerprint = fingerprint_of(inputs.submissions);
    std::map<std::string, std::size_t> index_of;
    for (std::size_t i = 0; i < inputs.submissions.size(); ++i) index_of.emplace(inputs.submissions[i].id, i);

    Gradebook gradebook(merge_into);
    const StudentNames names = name_submissions(inputs, options.rosters, gradebook, merge_into);
    attach_rereads(inputs.submissions, gradebook);
    ClassRun run = open_class_run(inputs.assignment, grading.runner, [&](reference::Assignment assignment) {
        return marking_for(std::move(assignment), names);
    });
    tell_key_notes(run.marking);
    part.head.alike = conditions_of(run, inputs, class_fingerprint, gradebook, grading);
    part.file = inputs.file;
    part.tier = run.runner.sandbox->tier();
    part.inputs = inputs.rosters.given();

    std::vector<Graded> graded =
        grade_submissions(share_of(std::move(inputs.submissions), shard), run, grading, options.quiet);
    const int status = status_of(graded);
    for (Graded& result : graded) {
        IndexedGraded& indexed =
            part.graded.emplace_back(IndexedGraded{index_of.at(result.submission.id), std::move(result)});
        indexed.graded.submission.name.clear();
    }
    part.head.submissions = part.graded.size();
    write_part(part, options.out);
    fmt::print("part: {}, {} of {} submissions\n", options.out.string(), part.head.submissions, part.head.class_size);
    return status;
}

}  // namespace harness
