#include "harness/results/reports.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <sstream>
#include <utility>

#include "harness/gradebook/gradebook.h"
#include "harness/machine/errors.h"
#include "harness/machine/file_descriptor.h"
#include "harness/machine/fresh_file.h"
#include "harness/report/class/page.h"
#include "harness/report/data/grades_csv.h"
#include "harness/report/data/grades_json.h"
#include "harness/report/page/student_page.h"
#include "harness/report/text/feedback.h"
#include "harness/text/escape.h"
#include "harness/text/utf8.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

void write_feedback(const ClassResults& results, std::size_t index, const fs::path& folder) {
    const Graded& graded = results.graded[index];
    const std::string name = feedback_name(graded.submission.id, index);
    const Marking& own = own_marking(results.marking, graded.submission);
    write_file(folder / (name + ".md"), report::feedback_markdown(graded, own));
    write_file(folder / (name + ".html"), report::student_page(graded, own));
}

/// Removes the pages of students who are no longer in the class, and files that a killed command left unfinished.
void remove_other_feedback(const ClassResults& results, const fs::path& folder) {
    std::set<std::string> kept;
    for (std::size_t i = 0; i < results.graded.size(); ++i) {
        const std::string name = feedback_name(results.graded[i].submission.id, i);
        kept.insert({name + ".md", name + ".html"});
    }
    std::vector<fs::path> others;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const bool is_ours =
            is_unfinished(entry.path()) || entry.path().extension() == ".md" || entry.path().extension() == ".html";
        const bool is_folder = entry.symlink_status().type() == fs::file_type::directory;
        if (is_ours && !is_folder && !kept.contains(entry.path().filename().string())) others.push_back(entry.path());
    }
    for (const fs::path& other : others) fs::remove(other);
}

void write_all_feedback(const ClassResults& results, const fs::path& folder) {
    for (std::size_t i = 0; i < results.graded.size(); ++i) write_feedback(results, i, folder);
    remove_other_feedback(results, folder);
}

std::optional<report::CanvasImport> write_canvas(const ClassResults& results, const fs::path& file) {
    if (!results.canvas) {
        fs::remove(file);  // from an earlier run; nobody should import its marks any more
        return std::nullopt;
    }
    report::CanvasImport import = report::canvas_import(*results.canvas, results.graded);
    write_file(file, import.csv);
    return import;
}

std::optional<report::MoodleImport> write_moodle(const ClassResults& results, const fs::path& file) {
    if (!results.moodle) {
        fs::remove(file);
        return std::nullopt;
    }
    report::MoodleImport import = report::moodle_import(*results.moodle, results.graded);
    write_file(file, import.csv);
    return import;
}

std::optional<report::FeedbackZip> write_zip(const ClassResults& results, const fs::path& file) {
    if (!report::is_from_lms(results.graded)) {
        fs::remove(file);
        return std::nullopt;
    }
    report::FeedbackZip zip;
    write_file(
        file, [&](std::ostream& stream) { zip = report::write_feedback_zip(stream, results.graded, results.marking); });
    return zip;
}

/// Without a sync, renamed files could be empty after a power cut.
void put_on_disk(const fs::path& folder) {
    const FileDescriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!opened || syncfs(opened.get()) != 0) fail_to_write(folder, errno);
}

}  // namespace

std::vector<std::string> marks_of_results() {
    return {"grades.json", gradebook_name, path_beside("grades.json")};
}

std::string feedback_name(const std::string& id, std::size_t index) {
    constexpr std::size_t longest = 200;
    std::string name;
    for (std::size_t i = 0; i < id.size(); ++i) {
        // Two ids never share a page: "Ann/Lee" becomes "Ann%2FLee", and "Ann%2FLee" becomes "Ann%252FLee".
        const std::string_view next = std::string_view(id).substr(i, 3);
        if (next.starts_with('/')) {
            name += "%2F";
        } else if (next == "%2F" || next == "%25") {
            name += "%25";
        } else {
            name += id[i];
        }
    }
    if (name.size() > longest) name = fmt::format("{}-{}", beginning_of_characters(name, longest), index + 1);
    return name;
}

std::optional<report::CanvasRoster> read_roster(const std::optional<KeptInput>& input) {
    if (!input) return std::nullopt;
    return report::read_canvas_roster(input->content, input->choice);
}

std::optional<report::MoodleWorksheet> read_worksheet(const std::optional<KeptInput>& input) {
    if (!input) return std::nullopt;
    std::vector<std::string> columns;
    std::istringstream choice(input->choice);
    for (std::string column; std::getline(choice, column);) columns.push_back(column);
    return report::read_moodle_worksheet(input->content, columns);
}

HandedBack write_reports(const ClassResults& results, const fs::path& folder, std::optional<std::size_t> only) {
    try {
        if (only) {
            write_feedback(results, *only, folder / "feedback");
        } else {
            write_all_feedback(results, folder / "feedback");
        }
        HandedBack handed_back;
        handed_back.canvas = write_canvas(results, folder / canvas_import_name);
        handed_back.moodle = write_moodle(results, folder / moodle_import_name);
        write_file(folder / "grades.csv", report::grades_csv(results.graded));
        handed_back.feedback = write_zip(results, folder / feedback_zip_name);
        write_file(folder / "grades.json", [&](std::ostream& stream) {
            report::write_grades_json(stream, results.graded, results.marking, results.tier);
        });
        write_file(folder / "report.html", [&](std::ostream& stream) {
            report::write_class_report(stream, results.graded, results.marking, results.tier, [&](std::size_t index) {
                return "feedback/" + in_address(feedback_name(results.graded[index].submission.id, index)) + ".html";
            });
        });
        put_on_disk(folder);
        return handed_back;
    } catch (const fs::filesystem_error& error) {
        throw HarnessError(fmt::format("cannot write {}: {}. Free some space, or check its permissions",
                                       error.path1().string(), error.code().message()));
    }
}

bool goes_back(const ClassResults& results) {
    return results.canvas || results.moodle || report::is_from_lms(results.graded);
}

bool class_reports_are_as_left(const std::vector<Graded>& graded, const fs::path& folder) {
    std::error_code error;
    const auto saved = fs::last_write_time(folder / gradebook_name, error);
    const auto is_as_left = [&](const fs::path& file) {
        const auto written = fs::last_write_time(file, error);
        return !error && written <= saved;
    };
    for (const char* report : {"grades.json", "report.html"}) {
        if (fs::exists(path_beside(folder / report), error)) return false;  // left by a killed command
    }
    if (error || !is_as_left(folder / "grades.csv") || !is_as_left(folder / "grades.json") ||
        !is_as_left(folder / "report.html")) {
        return false;
    }
    for (std::size_t i = 0; i < graded.size(); ++i) {
        const fs::path page = folder / "feedback" / feedback_name(graded[i].submission.id, i);
        if (!is_as_left(page.string() + ".md") || !is_as_left(page.string() + ".html")) return false;
    }
    return true;
}

}  // namespace harness
