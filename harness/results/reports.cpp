#include "harness/class_reports.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <sstream>
#include <utility>

#include "harness/clean_text.h"
#include "harness/failure.h"
#include "harness/folder_writer.h"
#include "harness/in_threads.h"
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
    in_threads(results.graded.size(), [&] {
        return [&, pages = report::StudentPages(results.marking)](std::size_t i) mutable {
            write_feedback(results, i, pages, feedback);
        };
    });
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
    // The last may be all that a run which was killed has left.
    return {"grades.json", gradebook_name, place_beside("grades.json")};
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

ReportsAhead::ReportsAhead(const ClassResults& results, fs::path folder)
    : results_(results),
      folder_(std::move(folder)),
      json_(folder_ / "grades.json"),
      page_(folder_ / "report.html"),
      ahead_(std::async(std::launch::async, [this] {
          json_.write([&](std::ostream& stream) {
              report::write_grades_json(stream, results_.graded, results_.marking, results_.tier);
          });
          page_.write([&](std::ostream& stream) {
              report::write_class_report(stream, results_.graded, results_.marking, results_.tier);
          });
      })) {}

HandedBack ReportsAhead::put_in_place(std::optional<std::size_t> only) {
    try {
        FolderWriter feedback(folder_ / "feedback");
        if (only) {
            report::StudentPages pages(results_.marking);
            write_feedback(results_, *only, pages, feedback);
        } else {
            write_all_feedback(results_, feedback);
        }
        HandedBack handed_back;
        handed_back.canvas = write_canvas(results_, folder_ / canvas_import_name);
        handed_back.moodle = write_moodle(results_, folder_ / moodle_import_name);
        write_file(folder_ / "grades.csv", report::grades_csv(results_.graded));
        handed_back.feedback = write_zip(results_, folder_ / feedback_zip_name);
        ahead_.get();
        json_.put_in_place();
        page_.put_in_place();
        put_on_disk(folder_);
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
    for (const char* report : {"grades.json", "report.html"}) {
        if (fs::exists(place_beside(folder / report), error)) return false;  // of a run that was killed
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
