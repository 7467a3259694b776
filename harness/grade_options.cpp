#include "harness/grade_options.h"

#include <CLI/CLI.hpp>

#include "harness/shared_options.h"

namespace harness {
namespace {

/// The lists of other systems, and what goes back to them.
void add_rosters(CLI::App& command, GradeOptions& options) {
    command
        .add_option("--canvas-roster", options.canvas_roster,
                    "A gradebook exported from Canvas: also write grades-canvas.csv, which Canvas imports, and say who "
                    "could not be matched")
        ->type_name("FILE");
    command
        .add_option("--canvas-column", options.canvas_column,
                    "The assignment's column in it, with its number or without; needed where there are several")
        ->type_name("TITLE");
    command
        .add_option(
            "--moodle-worksheet", options.moodle_worksheet,
            "A grading worksheet downloaded from Moodle: also write grades-moodle.csv, the same with the grades "
            "filled in, and say who could not be matched")
        ->type_name("FILE");
    command
        .add_option("--moodle-column", options.moodle_columns,
                    "What a column of it is for, where raygrade can't tell: identifier, name, grade, maximum or "
                    "changeable, as in --moodle-column grade=Bewertung")
        ->allow_extra_args(false)
        ->type_name("WHAT=HEADING");
}

}  // namespace

void add_grade_options(CLI::App& command, GradeOptions& options) {
    command
        .add_option("paths", options.paths, "What to grade: files, folders and archives, in the order of the report")
        ->required()
        ->type_name("PATH...");
    add_assignment(command, options.assignment)->default_str("that of the results in --out, else default");
    options.assignment.clear();
    command
        .add_option(
            "-o,--out", options.out,
            "The folder for report.html, gradebook.sqlite, grades.json, grades.csv and feedback/<id>.html and .md")
        ->type_name("DIR")
        ->capture_default_str();
    add_jobs(command, options.jobs, "How many submissions to grade at a time; changes nothing but the time");
    command.add_flag("--apply", options.apply,
                     "Write the new marks over those of an earlier run in the output folder; without it a regrade "
                     "only shows who rises, who falls and why, and whose feedback is another");
    add_rosters(command, options);
    add_junit(command, options.junit);
    command
        .add_option("--trace", options.trace,
                    "Write a trace of build, run, read and score of each submission here, for ui.perfetto.dev")
        ->type_name("FILE");
    add_variants(command, options.variants);
    command.add_flag("--stress", options.stress,
                     "Also run each program on the hard scenes of `raygrade stress` and put what it loses there "
                     "into the feedback; costs no points, and some fifteen runs of each program");
    add_workshop(command, options.workshop);
    command.footer(limits_footer() + "\nExample: raygrade grade submissions/ --assignment a6-2021 --out results -j 4");
}

}  // namespace harness
