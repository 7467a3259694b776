#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <future>
#include <iterator>
#include <optional>

#include "harness/batch.h"
#include "harness/clean_text.h"
#include "harness/commands.h"
#include "harness/failure.h"
#include "harness/find_submissions.h"
#include "harness/progress.h"
#include "harness/report/canvas.h"
#include "harness/report/report.h"
#include "harness/results_folder.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

/// Before a class is graded, not after. Throws UsageError.
void check_trace(const fs::path& trace) {
    const fs::path folder = fs::absolute(trace).parent_path();
    std::error_code error;
    if (fs::is_directory(trace, error) || access(folder.c_str(), W_OK | X_OK) != 0) {
        throw UsageError(fmt::format("{}: can't be written; name another file with --trace", trace.string()));
    }
}

/// The name of a submission's feedback: its id, which may hold the path before it, cut where a file name would be too
/// long.
std::string feedback_name(const std::string& id, std::size_t index) {
    constexpr std::size_t longest = 200;
    std::string name;
    for (const char c : id) name += c == '/' ? "%2F" : std::string(1, c);
    if (name.size() > longest) name = fmt::format("{}-{}", name.substr(0, longest), index + 1);
    return name + ".md";
}

void write_results(const std::vector<Graded>& graded, const Marking& marking, Tier tier, const fs::path& out) {
    const fs::path feedback = out / "feedback";
    for (const auto& entry : fs::directory_iterator(feedback)) {
        if (entry.path().extension() == ".md") fs::remove(entry.path());  // of an earlier run, under --force
    }
    std::future<void> written = std::async(std::launch::async, [&] {
        for (std::size_t i = 0; i < graded.size(); ++i) {
            write_file(feedback / feedback_name(graded[i].submission.id, i),
                       report::feedback_markdown(graded[i], marking));
        }
    });
    write_file(out / "grades.csv", report::grades_csv(graded));
    write_file(out / "grades.json",
               [&](std::ostream& stream) { report::write_grades_json(stream, graded, marking, tier); });
    written.get();
}

std::vector<Graded> grade_with_progress(std::vector<Submission> submissions, const std::shared_future<Marking>& marking,
                                        const Workshop& workshop, int jobs, const fs::path& trace) {
    Timeline timeline;
    std::vector<Graded> graded;
    {
        const Progress progress(timeline, submissions.size());
        graded = grade_all(std::move(submissions), marking, workshop, jobs, timeline);
    }
    fmt::print(stderr, "{}\n", closing_line(timeline));
    tell_problems(workshop);
    if (trace.empty()) return graded;
    write_file(trace, timeline.chrome_trace());
    return graded;
}

/// What one run shows is enough there: neither repetitions nor sanitizers.
void run_on_other_scenes(std::vector<Graded>& graded, const std::vector<std::string>& sources, const Marking& marking,
                         Workshop& workshop, const GradeOptions& options) {
    if (options.variants.count == 0) return;
    workshop.repetitions = 1;
    workshop.sanitize = false;
    Timeline timeline;
    {
        const Progress progress(timeline, graded.size() * static_cast<std::size_t>(options.variants.count));
        variants::run_variants(graded, sources, marking, workshop, options.jobs, options.variants, timeline);
    }
    fmt::print(stderr, "other scenes: {}\n", closing_line(timeline));
}

}  // namespace

void tell_problems(const Workshop& workshop) {
    if (!workshop.store) return;
    for (const std::string& problem : workshop.store->problems()) fmt::print(stderr, "note: {}\n", problem);
}

int status_of(const std::vector<Graded>& graded) {
    const auto ours = [](const Graded& one) { return one.our_fault; };
    const auto missed = [](const Graded& one) { return one.outcome == Outcome::not_graded; };
    if (std::any_of(graded.begin(), graded.end(), ours)) return our_fault;
    return std::any_of(graded.begin(), graded.end(), missed) ? some_not_graded : all_graded;
}

std::optional<report::CanvasRoster> read_roster(const GradeOptions& options) {
    if (options.canvas_roster.empty()) return std::nullopt;
    std::ifstream file(options.canvas_roster, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) {
        throw UsageError(fmt::format("{}: can't be read: {}", options.canvas_roster.string(), std::strerror(errno)));
    }
    try {
        return report::read_canvas_roster(text, options.canvas_column);
    } catch (const report::RosterError& error) {
        throw UsageError(fmt::format("{} {}", options.canvas_roster.string(), error.what()));
    }
}

void tell_canvas(const report::CanvasImport& import, const fs::path& file) {
    const auto list = [](const char* what, const std::vector<std::string>& names) {
        for (const std::string& name : names) fmt::print("  {}: {}\n", what, escape_control(name));
    };
    fmt::print("for Canvas: {}, {} matched\n", file.string(), import.matched);
    list("ambiguous, left out", import.ambiguous);
    list("not in the gradebook, left out", import.unmatched);
    list("not graded, left out", import.not_graded);
    list("nothing handed in, left as it is", import.without);
}

int grade_command(const GradeOptions& options) {
    const auto roster = read_roster(options);
    const reference::Assignment assignment = reference::load_assignment(options.assignment, assignments_folder());
    const auto marking = begin_marking(assignment);
    std::vector<Submission> submissions = find_submissions(options.paths);
    prepare_results(options.out, "grades.json", options.force ? Replace::yes : Replace::no, "feedback");
    if (!options.trace.empty()) check_trace(options.trace);
    Workshop workshop = open_workshop(options.workshop, assignment.limits);
    tell_of_the_sandbox(workshop);
    // A mistake of the assignment is to be told before a class is compiled.
    for (const std::string& note : marking.get().key.notes) fmt::print(stderr, "note: {}\n", note);
    std::vector<std::string> sources;  // for the other scenes, as grading gives them back
    if (options.variants.count > 0) {
        for (const Submission& submission : submissions) sources.push_back(submission.source);
    }
    std::vector<Graded> graded =
        grade_with_progress(std::move(submissions), marking, workshop, options.jobs, options.trace);
    run_on_other_scenes(graded, sources, marking.get(), workshop, options);
    fmt::print("{}", report::class_table(graded));
    std::fflush(stdout);  // the marks are shown before anything can go wrong with the files
    for (const Graded& one : graded) {
        for (const std::string& note : one.submission.notes)
            fmt::print(stderr, "note: {}: {}\n", one.submission.id, note);
    }
    try {
        if (roster) {
            const report::CanvasImport import = report::canvas_import(*roster, graded);
            write_file(options.out / "grades-canvas.csv", import.csv);
            tell_canvas(import, options.out / "grades-canvas.csv");
        }
        write_results(graded, marking.get(), workshop.sandbox->tier(), options.out);
    } catch (const fs::filesystem_error& error) {
        throw HarnessError(fmt::format("{}: can't be written: {}", error.path1().string(), error.code().message()));
    }
    fmt::print("\nresults: {}\nfeedback: {}\n", (options.out / "grades.json").string(),
               (options.out / "feedback").string());
    return status_of(graded);
}

}  // namespace harness
