#include "harness/class_reports.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <future>
#include <sstream>

#include "harness/clean_text.h"
#include "harness/failure.h"
#include "harness/folder_writer.h"
#include "harness/report/class_report.h"
#include "harness/report/report.h"
#include "harness/report/student_page.h"
#include "harness/results_folder.h"
#include "harness/sandbox/file_descriptor.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

void write_feedback(const ClassResults& results, std::size_t index, report::StudentPages& pages,
                    FolderWriter& feedback) {
    const Graded& one = results.graded[index];
    const std::string name = feedback_name(one.submission.id, index);
    feedback.write(name + ".md", report::feedback_markdown(one, results.marking));
    feedback.write(name + ".html", pages.page(one));
}

void write_all_feedback(const ClassResults& results, FolderWriter& feedback) {
    report::StudentPages pages(results.marking);
    for (std::size_t i = 0; i < results.graded.size(); ++i) write_feedback(results, i, pages, feedback);
    feedback.remove_others({".md", ".html"});
}

std::optional<report::CanvasImport> write_canvas(const ClassResults& results, const fs::path& file) {
    if (!results.canvas) {
        fs::remove(file);  // of an earlier run, whose marks are not to be imported any more
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

/// After a power cut a file that was written over could hold what it held before, which may be another student's.
void put_on_disk(const fs::path& folder) {
    const FileDescriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!opened || syncfs(opened.get()) != 0) fail_to_write(folder, errno);
}

}  // namespace

std::vector<std::string> marks_of_results() {
    return {"grades.json", gradebook_name};
}

std::string feedback_name(const std::string& id, std::size_t index) {
    constexpr std::size_t longest = 200;
    std::string name;
    for (const char c : id) name += c == '/' ? "%2F" : std::string(1, c);
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

HandedBack write_class_reports(const ClassResults& results, const fs::path& folder, std::optional<std::size_t> only) {
    try {
        // The other half, by the time it takes.
        std::future<void> written = std::async(std::launch::async, [&] {
            FolderWriter feedback(folder / "feedback");
            if (only) {
                report::StudentPages pages(results.marking);
                write_feedback(results, *only, pages, feedback);
            } else {
                write_all_feedback(results, feedback);
            }
        });
        HandedBack handed_back;
        handed_back.canvas = write_canvas(results, folder / canvas_import_name);
        handed_back.moodle = write_moodle(results, folder / moodle_import_name);
        write_file(folder / "grades.csv", report::grades_csv(results.graded));
        write_file(folder / "grades.json", [&](std::ostream& stream) {
            report::write_grades_json(stream, results.graded, results.marking, results.tier);
        });
        write_file(folder / "report.html", [&](std::ostream& stream) {
            report::write_class_report(stream, results.graded, results.marking, results.tier);
        });
        handed_back.feedback = write_zip(results, folder / feedback_zip_name);
        written.get();
        put_on_disk(folder);
        return handed_back;
    } catch (const fs::filesystem_error& error) {
        throw HarnessError(fmt::format("{}: can't be written: {}", error.path1().string(), error.code().message()));
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
