#include "harness/report_files.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>

#include "harness/bounded_file.h"
#include "harness/clean_text.h"
#include "harness/final_mark.h"
#include "harness/find_submissions.h"
#include "harness/report/gradescope.h"
#include "harness/report/junit.h"
#include "harness/results_folder.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

void list(const char* what, const std::vector<std::string>& names) {
    for (const std::string& name : names) fmt::print("  {}: {}\n", what, escape_control(name));
}

std::string from_environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

report::Classroom50Submission read_classroom50() {
    std::string missing;
    const auto required = [&](const char* name) {
        std::string value = from_environment(name);
        if (value.empty()) missing += (missing.empty() ? "" : ", ") + std::string(name);
        return value;
    };
    report::Classroom50Submission submission;
    submission.classroom = required("CLASSROOM");
    submission.assignment = required("ASSIGNMENT");
    submission.tag = required("SUBMISSION_TAG");
    submission.commit = required("COMMIT_URL");
    submission.release = required("RELEASE_URL");
    if (!missing.empty()) {
        throw UsageError(fmt::format(
            "--classroom50: not in the environment: {}. Call raygrade from an autograder.py, which the runner of "
            "Classroom 50 gives them to",
            missing));
    }
    submission.review = from_environment("REVIEW_URL");
    if (submission.review.empty()) submission.review = submission.commit;
    submission.owner = from_environment("OWNER");
    if (submission.owner.empty()) submission.owner = from_environment("USERNAME");
    submission.assignment_type = from_environment("ASSIGNMENT_TYPE");
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    submission.datetime = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
    return submission;
}

/// Throws UsageError, which names the file and the limit.
std::string read_roster_text(const fs::path& file) {
    constexpr std::uintmax_t longest = std::uintmax_t{64} << 20U;
    BoundedFile roster = read_bounded(file, longest, Links::follow);
    if (!roster.is_whole()) {
        throw UsageError(fmt::format("{}: can't be read: {}; give it as it was exported", file.string(),
                                     why_not_whole(roster, longest)));
    }
    return std::move(roster.bytes);
}

}  // namespace

void require_place_for_report_file(const fs::path& file, std::string_view option, std::string_view ending) {
    if (file.empty()) return;
    const auto fail = [&](const std::string& why) {
        throw UsageError(fmt::format("{}: {}; name another file with {}", file.string(), why, option));
    };
    if (file.extension() != ending) fail(fmt::format("does not end in {}", ending));
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) fail("is no file");
    const fs::path folder = fs::absolute(file).parent_path();
    if (access(folder.c_str(), W_OK | X_OK) != 0) fail(fmt::format("can't be written: {}", std::strerror(errno)));
}

void prepare_report_file(const fs::path& file, std::string_view option, std::string_view ending) {
    if (file.empty()) return;
    require_place_for_report_file(file, option, ending);
    for (const fs::path& earlier : {file, place_beside(file)}) {
        std::error_code error;
        fs::remove(earlier, error);
        if (error) {
            throw UsageError(fmt::format("{}: can't be replaced: {}; name another file with {}", file.string(),
                                         error.message(), option));
        }
    }
}

std::optional<KeptInput> read_roster_file(const GradeOptions& options) {
    if (options.canvas_roster.empty()) return std::nullopt;
    return KeptInput{canvas_roster_input, options.canvas_column, read_roster_text(options.canvas_roster)};
}

std::optional<KeptInput> read_worksheet_file(const GradeOptions& options) {
    if (options.moodle_worksheet.empty()) {
        if (options.moodle_columns.empty()) return std::nullopt;
        throw UsageError("--moodle-column: names a column of no worksheet; give it with --moodle-worksheet");
    }
    std::string columns;
    for (const std::string& column : options.moodle_columns) columns += column + '\n';
    KeptInput input{moodle_worksheet_input, columns, read_roster_text(options.moodle_worksheet)};
    try {
        read_worksheet(input);
    } catch (const report::RosterError& error) {
        throw UsageError(fmt::format("{} {}", options.moodle_worksheet.string(), error.what()));
    }
    return input;
}

void write_junit_file(const GradeOptions& options, const std::vector<Graded>& graded, const Marking& marking) {
    if (options.junit.empty()) return;
    write_file(options.junit, [&](std::ostream& stream) { report::write_junit(stream, graded, marking); });
}

void tell_canvas(const report::CanvasImport& import, const fs::path& file) {
    fmt::print("for Canvas: {}, {} matched\n", file.string(), import.matched);
    if (import.possible) {
        fmt::print("  Points Possible of the column are {:g}, not the assignment's: points are filled in as they are\n",
                   *import.possible);
    }
    list("more than Points Possible", import.above);
    list("ambiguous, left out", import.ambiguous);
    list("not in the gradebook, left out", import.unmatched);
    list("not graded, left out", import.not_graded);
    list("nothing handed in, left as it is", import.without);
}

void tell_moodle(const report::MoodleImport& import, const fs::path& file) {
    fmt::print("for Moodle: {}, {} filled in\n", file.string(), import.matched);
    if (import.other_maximum) {
        fmt::print("  the worksheet's maximum grade is {:g}, not the assignment's: points are filled in as they are\n",
                   *import.other_maximum);
    }
    list("ambiguous, left out", import.ambiguous);
    list("not in the worksheet, left out", import.unmatched);
    list("not graded, left out", import.not_graded);
    list("locked in Moodle, left out", import.locked);
    list("above the maximum grade, left out", import.above);
    list("lower than before", import.lowered);
    list("nothing handed in, left as it is", import.without);
}

void tell_feedback(const report::FeedbackZip& zip, const fs::path& file) {
    fmt::print("feedback to hand back: {}, {} pages\n", file.string(), zip.pages);
    list("left out", zip.left_out);
}

CheckFiles::CheckFiles(const CheckOptions& options) : options_(options) {
    if (!options.classroom50.empty()) classroom50_ = read_classroom50();
    prepare_report_file(options.gradescope, "--gradescope", ".json");
    prepare_report_file(options.classroom50, "--classroom50", ".json");
    prepare_report_file(options.junit, "--junit", ".xml");
}

void CheckFiles::write(const Graded& graded, const Marking& marking) const {
    if (!options_.gradescope.empty()) write_file(options_.gradescope, report::gradescope_results(graded, marking));
    if (classroom50_ && final_mark(graded))
        write_file(options_.classroom50, report::classroom50_result(graded, marking, *classroom50_));
    if (!options_.junit.empty()) write_file(options_.junit, report::junit({graded}, marking));
}

}  // namespace harness
