#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>

#include "harness/class_run/progress.h"
#include "harness/class_run/students/rosters.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/machine/say.h"
#include "harness/prepare/check_text.h"
#include "harness/prepare/deal.h"
#include "harness/prepare/handout.h"
#include "harness/record/final_mark.h"
#include "harness/record/marking.h"
#include "harness/report/accuracy/sentences.h"
#include "harness/report/exchange/roster.h"
#include "harness/results/reports.h"
#include "harness/text/escape.h"
#include "harness/text/shell_word.h"
#include "reference/toml/scene_toml.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

struct AssignmentOptions {
    std::string file;
    prepare::Search search;
    fs::path roster;  ///< of deal
    fs::path dealt = "dealt";
    fs::path handout;  ///< empty for stdout
    bool force = false;
};

int list_assignments() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(assignments_folder())) {
        if (entry.path().extension() == ".toml" && !entry.is_symlink()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) {
        const auto assignment = reference::load_assignment(file.string(), assignments_folder());
        fmt::print("{:<12} {:>2} questions  {}\n", assignment.name, assignment.questions.size(),
                   escape_control(assignment.title));
    }
    fmt::print("(in {})\n", assignments_folder().string());
    return all_graded;
}

int check_assignment(const AssignmentOptions& options) {
    const reference::Assignment assignment = load_as_graded(options.file);
    const reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
    double points = 0;
    for (const reference::Question& question : assignment.questions)
        points += assignment.rubric.points_of(question.number);
    fmt::print("{}: {}, {} questions, {:g} points\n", assignment.name, escape_control(assignment.title),
               assignment.questions.size(), points);
    for (const std::string& note : key.notes) fmt::print("note: {}\n", note);
    fmt::print("{}", prepare::objects_text(key));
    const auto decisions = reference::accuracy::decisions_of(assignment, key.canonical);
    fmt::print("\n{}\n{}\n", report::decisions_summary(decisions), prepare::decisions_text(decisions));
    const prepare::ShownMistakes mistakes = prepare::shown_mistakes(assignment, key);
    fmt::print("{}\n", prepare::mistakes_text(mistakes, key));
    const std::string file = shell_word(options.file);
    if (!mistakes.hidden.empty())
        fmt::print("To look for a scene that reveals more mistakes: raygrade assignment propose {}\n", file);
    fmt::print("Next: raygrade assignment handout {} --out handout\n", file);
    return all_graded;
}

int propose_scene(const AssignmentOptions& options) {
    const reference::Assignment assignment = load_as_graded(options.file);
    prepare::Search search = options.search;
    ShareProgress progress;
    search.progress = [&](double done) { progress.tell(done); };
    const prepare::Proposal proposal = prepare::propose(assignment, search);
    say("{}", prepare::proposal_text(proposal));
    fmt::print("{}", reference::scene_toml(proposal.scene));
    return all_graded;
}

/// The assignment's file, with a [[student]] table for each new scene.
std::string with_students(const reference::AssignmentFile& file, const reference::Assignment& assignment,
                          const std::map<std::string, reference::Scene<reference::Decimal>>& scenes) {
    std::string text = file.toml;
    for (const auto& [student, scene] : scenes) {
        if (!assignment.dealt.contains(student)) text += "\n" + prepare::student_toml(student, scene, assignment.scene);
    }
    return text;
}

/// Writes NAME.html, NAME.md and NAME.svg.
void write_handout(const fs::path& folder, const std::string& name, const reference::Assignment& assignment,
                   const std::string& student) {
    const std::string picture = name + ".svg";
    write_file(folder / picture, prepare::handout_picture(assignment));
    write_file(folder / (name + ".md"), prepare::handout_markdown(assignment, student, in_address(picture)));
    write_file(folder / (name + ".html"), prepare::handout_html(assignment, student));
}

void note_missing_due_date(const reference::Assignment& assignment, const std::string& file) {
    if (!assignment.rubric.due)
        say("note: {} has no due date; add due = \"2026-11-05 23:59\" to its [rubric] to print one\n",
            escape_control(file));
}

int deal_scenes(const AssignmentOptions& options) {
    const reference::AssignmentFile file = reference::read_assignment_file(options.file, assignments_folder());
    const reference::Assignment assignment = as_graded(reference::parse_assignment(file.toml, file.path));
    std::vector<report::RosterStudent> roster;
    try {
        roster = report::students_in(read_roster_text(options.roster));
    } catch (const report::RosterError& error) {
        throw UsageError(fmt::format("{} {}", options.roster.string(), error.what()));
    }
    // A second deal would replace scenes that students already work on.
    const fs::path dealt_file = options.dealt / file.path.filename(), handouts = options.dealt / "handouts";
    if (fs::exists(dealt_file) && fs::exists(handouts)) {
        throw UsageError(
            fmt::format("{} already has dealt scenes; name a new folder with --out, and deal from {} to keep them",
                        options.dealt.string(), dealt_file.string()));
    }
    look_into(options.dealt, {}, "handouts", {"scenes dealt from this assignment", "--out"});
    const ResultsFolder folder(options.dealt, "handouts");
    std::vector<std::string> students;
    for (const report::RosterStudent& student : roster) students.push_back(student.id);
    ShareProgress progress;
    const auto scenes =
        prepare::deal(assignment, students, {options.search.seed, [&](double done) { progress.tell(done); }});
    const std::string toml = with_students(file, assignment, scenes);
    const reference::Assignment dealt = reference::parse_assignment(toml, dealt_file);
    write_file(dealt_file, toml);
    for (std::size_t i = 0; i < roster.size(); ++i) {
        const auto& [id, name] = roster[i];
        write_handout(handouts, feedback_name(id, i), reference::of_student(dealt, id),
                      name.empty() ? id : fmt::format("{} ({})", name, id));
    }
    fmt::print("scenes: {}\nhandouts: {}\n", dealt_file.string(), handouts.string());
    note_missing_due_date(dealt, dealt_file.string());
    say("students with their own scene: {}, {} of them new.\nNext: raygrade grade CLASS --assignment {}\n",
        dealt.dealt.size(), dealt.dealt.size() - assignment.dealt.size(), shell_word(dealt_file.string()));
    return all_graded;
}

int make_handout(const AssignmentOptions& options) {
    const reference::Assignment assignment = load_as_graded(options.file);
    if (!assignment.dealt.empty()) say("note: this is the common scene; {}.toml@ID is a student's\n", assignment.name);
    note_missing_due_date(assignment, options.file);
    constexpr std::string_view before_student = ".toml@";
    const std::size_t at = options.file.find(before_student);
    const std::string student = at == std::string::npos ? "" : options.file.substr(at + before_student.size());
    if (options.handout.empty()) {
        fmt::print("{}", prepare::handout_markdown(assignment, student, ""));
        say("To write a page for printing, with a picture of the scene: raygrade assignment handout {} --out handout\n",
            shell_word(options.file));
        return all_graded;
    }
    prepare_results(options.handout, "handout.html", options.force);
    write_handout(options.handout, "handout", assignment, student);
    fmt::print("to print: {}\nMarkdown: {}\n", (options.handout / "handout.html").string(),
               (options.handout / "handout.md").string());
    return all_graded;
}

void add_file(CLI::App& command, AssignmentOptions& options) {
    command.add_option("assignment", options.file, "An assignment: one that comes with raygrade, or a .toml file")
        ->type_name("NAME|FILE")
        ->required();
}

}  // namespace

Subcommand assignment_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("assignment", "Check, improve, deal or hand out an assignment");
    command.require_subcommand(1);
    command.footer("Example: raygrade assignment check my.toml");
    const auto options = std::make_shared<AssignmentOptions>();
    CLI::App* list = command.add_subcommand("list", "List the assignments that come with raygrade");
    list->footer("Example: raygrade assignment list");
    CLI::App* check = command.add_subcommand(
        "check", "Warn about borderline hits, and about common mistakes that the scene would not reveal");
    add_file(*check, *options);
    check->footer("Example: raygrade assignment check next-year.toml");
    CLI::App* propose = command.add_subcommand(
        "propose", "Find a slightly different scene that reveals more mistakes and has no borderline hits");
    add_file(*propose, *options);
    propose->add_option("--steps", options->search.steps, "How many scenes to try")
        ->check(number(1, 100000))
        ->type_name("N")
        ->capture_default_str();
    propose->add_option("--seed", options->search.seed, "Another seed starts the search elsewhere")
        ->check(number(0))
        ->type_name("N")
        ->capture_default_str();
    propose->footer(
        "The new scene goes to stdout, a summary of the changes to stderr.\nExample: raygrade assignment propose "
        "a6-2021 > scene.toml");
    CLI::App* deal = command.add_subcommand("deal", "Give each student their own scene, and write the handouts");
    add_file(*deal, *options);
    deal->add_option(
            "roster", options->roster,
            "A roster: a CSV file with a column id (the names of the submissions) and perhaps name, or an export from "
            "Canvas or Moodle")
        ->type_name("ROSTER.csv")
        ->required();
    deal->add_option("-o,--out", options->dealt, "A new folder for the assignment and the handouts")
        ->type_name("DIR")
        ->capture_default_str();
    deal->add_option("--seed", options->search.seed, "Another seed gives other scenes")
        ->check(number(0))
        ->type_name("N")
        ->capture_default_str();
    deal->footer(
        "Students who already have a scene in the assignment keep it, so you can add latecomers.\nExample: raygrade "
        "assignment deal a6-2021 class.csv --out dealt\nOne student's answers: raygrade reference -a "
        "dealt/a6-2021.toml@s07");
    CLI::App* handout = command.add_subcommand(
        "handout", "Write the handout for students: scene with a picture, due date, questions and points");
    add_file(*handout, *options);
    handout
        ->add_option("-o,--out", options->handout,
                     "A folder for handout.html, a page to print, and the same as Markdown; without it, print the "
                     "Markdown")
        ->type_name("DIR");
    handout->add_flag("--force", options->force, "Replace an earlier handout");
    handout->footer("Example: raygrade assignment handout a6-2021 --out handout");
    return {&command, [=] {
                if (list->parsed()) return list_assignments();
                if (check->parsed()) return check_assignment(*options);
                if (deal->parsed()) return deal_scenes(*options);
                return propose->parsed() ? propose_scene(*options) : make_handout(*options);
            }};
}

}  // namespace harness
