// The command line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <clocale>
#include <cstdio>
#include <thread>

#include "harness/command_stress.h"
#include "harness/commands.h"
#include "harness/failure.h"
#include "harness/find_submissions.h"

namespace {

using namespace harness;

constexpr const char* about =
    "Grades a ray-casting assignment: compiles each ray_cast.cpp, runs it, reads its ten\n"
    "answers and marks them against a certified key.\n\n"
    "  raygrade grade class/ --out results     a class: marks, reports, grades.json\n"
    "  raygrade override s05 6.t 2 --why ...   an instructor's mark in place of the automatic one\n"
    "  raygrade check ray_cast.cpp             a student's own check before handing in\n"
    "  raygrade stress ray_cast.cpp            which hard scenes a method survives, and what would do better\n"
    "  raygrade serve                          the same as a page for browsers\n"
    "  raygrade reference                      the canonical answers\n"
    "  raygrade cast < queries.jsonl           exact answers to any rays\n"
    "  raygrade accuracy --out accuracy        what accuracy costs in time: a page of pictures\n"
    "  raygrade explain output.txt             a picture of the scene and of what a program printed\n"
    "  raygrade render -o scene.png            the scene as its camera sees it\n"
    "  raygrade doctor                         what this machine has and lacks";

constexpr const char* footer =
    "Exit status: 0 all graded, 1 some not graded, 2 a mistake in the command or the assignment, 3 a fault of "
    "raygrade.\n"
    "Marks never change it, except under `check --fail-under`.";

void add_assignment(CLI::App& command, std::string& assignment) {
    command
        .add_option("-a,--assignment", assignment,
                    "The name of an assignment that comes with raygrade, or a .toml file")
        ->type_name("NAME|FILE")
        ->capture_default_str();
}

void add_junit(CLI::App& command, std::filesystem::path& junit) {
    command
        .add_option("--junit", junit,
                    "Also write JUnit XML, for continuous integration: a testsuite a submission, a testcase an answer")
        ->type_name("FILE.xml");
}

void add_workshop(CLI::App& command, WorkshopOptions& workshop) {
    command
        .add_option("--limit", workshop.limits,
                    "What a program or the compiler may use, instead of the default or the assignment's: "
                    "--limit run.cpu_seconds=4, see below")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
    command
        .add_option("--sandbox", workshop.sandbox,
                    "Which sandbox programs run in; auto takes the strongest that holds on this machine")
        ->check(CLI::IsMember({"auto", "bwrap", "landlock"}))
        ->capture_default_str();
    command
        .add_option(
            "--repeat", workshop.repetitions,
            "Run each program so often and flag one whose answers differ, as of memory never set; costs no points")
        ->check(CLI::Range(1, 100))
        ->type_name("N")
        ->capture_default_str();
    command.add_flag(
        "--sanitize", workshop.sanitize,
        "Also build and run under AddressSanitizer and UndefinedBehaviorSanitizer, and say what they find; "
        "costs no points, and ten times as long");
    workshop.cache = cache_folder();
    command.add_flag("--fresh", workshop.fresh,
                     "Compile and run everything anew, also what was before; see README, What is kept");
    command.add_flag("--unsafe", workshop.unsafe,
                     "Where no sandbox holds, run strangers' programs with limits alone: they can read and change "
                     "what you can");
}

void add_variants(CLI::App& command, variants::VariantOptions& options) {
    command
        .add_option("--variants", options.count,
                    "Also run each program on N other scenes, written into its source, and say which answers move with "
                    "the scene; costs no points of its own, and gives some where the rubric says so (variant_points)")
        ->check(CLI::Range(0, 16))
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option("--variant-seed", options.seed,
                    "Where the other scenes are drawn from; the same seed gives the same scenes")
        ->type_name("N")
        ->capture_default_str();
}

void add_render(CLI::App& command, RenderOptions& render) {
    render.assignment = "default";
    render.out = "image.png";
    render.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    add_assignment(command, render.assignment);
    command.add_option("--scene", render.scene, "A scene file instead: an assignment without questions, see README")
        ->type_name("FILE")
        ->excludes("--assignment");
    command.add_option("-o,--out", render.out, "The PNG file to write; an earlier picture there is replaced")
        ->type_name("FILE")
        ->capture_default_str();
    command.add_option("--size", render.size, "Pixels across and up; default: the window's")->type_name("WxH");
    command.add_option("-j,--jobs", render.jobs, "How many threads to use; changes nothing but the time")
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->capture_default_str();
    command.add_flag("--explain", render.explain,
                     "Say which effects the scene calls for and why each other one is off, the rays by kind and the "
                     "time by effect");
    command.add_flag("--all-effects", render.all_effects,
                     "Simulate every effect, called for or not: the same picture, later");
    command.footer(
        "Examples: raygrade render --assignment a6-2021 -o 2021.png --explain\n"
        "          raygrade render --scene reference/scenes/glass.toml --size 1280x720 -j 4");
}

/// The table of limits below the help of a command.
std::string limits_footer() {
    std::string text = "Limits, with their defaults:\n";
    for (const LimitDescription& limit : describe_limits()) {
        text += fmt::format("  {:<21} {:>5}  {}\n", limit.name, limit.value, limit.consequence);
    }
    return text;
}

CLI::App& add_serve(CLI::App& app, ServeOptions& serve) {
    CLI::App& command = *app.add_subcommand(
        "serve", "Put up a page where students check their ray_cast.cpp in a browser, as `raygrade check` does");
    add_assignment(command, serve.assignment);
    command.add_option("-p,--port", serve.port, "The port; 0 for any free one, which is told")
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option("--host", serve.host,
                    "The address of this machine to listen at; any but 127.0.0.1 and ::1 lets others in, 0.0.0.0 all")
        ->type_name("ADDRESS")
        ->capture_default_str();
    command
        .add_option("--name", serve.names,
                    "A name by which browsers know the page, as in --name check.example.edu; others are refused")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command.add_flag("--behind-proxy", serve.behind_proxy,
                     "Requests come from a proxy with a certificate: believe its X-Forwarded-For");
    command.add_option("-j,--jobs", serve.jobs, "How many programs to grade at a time")
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--queue", serve.queue, "How many may wait; more are asked to come again")
        ->check(CLI::Range(1, 100'000))
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option("--rate", serve.rate,
                    "How many programs one address may send a minute; more for a room behind one address")
        ->check(CLI::Range(1, 100'000))
        ->type_name("N")
        ->capture_default_str();
    command.add_option("--keep", serve.keep_hours, "How long results are kept")
        ->check(CLI::Range(1, 24 * 365))
        ->type_name("HOURS")
        ->capture_default_str();
    command
        .add_option("--grace", serve.grace_seconds,
                    "How long to go on with the queue when stopped; the rest is graded after the next start")
        ->check(CLI::Range(0, 24 * 3600))
        ->type_name("SECONDS")
        ->capture_default_str();
    command
        .add_option("--state", serve.state,
                    "The folder for queue and results; without it, one for the assignment in $XDG_STATE_HOME/raygrade "
                    "or ~/.local/state/raygrade")
        ->type_name("DIR");
    add_workshop(command, serve.workshop);
    command.footer(
        limits_footer() +
        "\nStudents upload or paste a program, see their place in the queue, and get their page: verdicts and hints, "
        "never the\nright values unless the assignment says so. Each result has an address that nobody can guess. "
        "Nothing is handed in.\n\n"
        "Examples: raygrade serve --assignment a6-2021                       a look at it: only on this machine\n"
        "          raygrade serve --host 192.168.1.20 --rate 200             a lab, in plain text\n"
        "          raygrade serve --behind-proxy --name check.example.edu    behind nginx or Caddy, see README");
    return command;
}

int run(int argc, char** argv) {
    CLI::App app(about, "raygrade");
    app.footer(footer);
    app.require_subcommand(1);
    app.set_version_flag("--version", "raygrade " RAYGRADE_VERSION);
    app.get_formatter()->column_width(36);

    GradeOptions grade{{},    "default", "results", static_cast<int>(std::max(1U, std::thread::hardware_concurrency())),
                       false, {},        {},        {},
                       {}};
    CLI::App& grade_app = *app.add_subcommand("grade",
                                              "Grade a class: a source, a folder of student folders or of sources, or "
                                              "the zip of Canvas, Moodle or Gradescope");
    grade_app
        .add_option("paths", grade.paths, "What to grade: files, folders and archives, in the order of the report")
        ->required()
        ->type_name("PATH...");
    add_assignment(grade_app, grade.assignment);
    grade_app
        .add_option(
            "-o,--out", grade.out,
            "The folder for report.html, gradebook.sqlite, grades.json, grades.csv and feedback/<id>.html and .md")
        ->type_name("DIR")
        ->capture_default_str();
    grade_app
        .add_option("-j,--jobs", grade.jobs, "How many submissions to grade at a time; changes nothing but the time")
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->capture_default_str();
    grade_app.add_flag("--apply", grade.apply,
                       "Write the new marks over those of an earlier run in the output folder; without it a regrade "
                       "only shows who rises, who falls and why");
    grade_app
        .add_option("--canvas-roster", grade.canvas_roster,
                    "A gradebook exported from Canvas: also write grades-canvas.csv, which Canvas imports, and say who "
                    "could not be matched")
        ->type_name("FILE");
    grade_app
        .add_option("--canvas-column", grade.canvas_column,
                    "The assignment's column in it, with its number or without; needed where there are several")
        ->type_name("TITLE");
    grade_app
        .add_option(
            "--moodle-worksheet", grade.moodle_worksheet,
            "A grading worksheet downloaded from Moodle: also write grades-moodle.csv, the same with the grades "
            "filled in, and say who could not be matched")
        ->type_name("FILE");
    grade_app
        .add_option("--moodle-column", grade.moodle_columns,
                    "What a column of it is for, where raygrade can't tell: identifier, name, grade, maximum or "
                    "changeable, as in --moodle-column grade=Bewertung")
        ->allow_extra_args(false)
        ->type_name("WHAT=HEADING");
    add_junit(grade_app, grade.junit);
    grade_app
        .add_option("--trace", grade.trace,
                    "Write a trace of build, run, read and score of each submission here, for ui.perfetto.dev")
        ->type_name("FILE");
    add_variants(grade_app, grade.variants);
    grade_app.add_flag("--stress", grade.stress,
                       "Also run each program on the hard scenes of `raygrade stress` and put what it loses there "
                       "into the feedback; costs no points, and some fifteen runs of each program");
    add_workshop(grade_app, grade.workshop);
    grade_app.footer(limits_footer() +
                     "\nExample: raygrade grade submissions/ --assignment a6-2021 --out results -j 4");

    OverrideOptions given;
    CLI::App& override_app = *app.add_subcommand(
        "override", "Give points in place of the automatic ones: they stay through every regrade, with the reason");
    override_app.add_option("id", given.id, "The submission, as the reports name it")->type_name("ID");
    override_app.add_option("item", given.item, "An item such as 6.t, a question such as 6, or total")
        ->type_name("ITEM");
    override_app.add_option("points", given.points, "What it gets instead, 0 or more")->type_name("POINTS");
    override_app.add_option("--why", given.why, "The reason, which the student reads too")->type_name("TEXT");
    override_app.add_option("--by", given.by, "Who decides; by default the account that runs raygrade")
        ->type_name("NAME");
    override_app.add_option("--results", given.results, "The folder that `raygrade grade` wrote its results to")
        ->type_name("DIR")
        ->capture_default_str();
    override_app.add_flag("--remove", given.remove, "Take an override back: the automatic points count again");
    override_app.add_flag("--list", given.list, "Show the overrides there are");
    override_app.footer(
        "The reports are written again at once. Example: raygrade override s05 6.t 1.5 --why \"right but for a sign\"");

    CheckOptions check{{}, "default", {}, {}};
    CLI::App& check_app = *app.add_subcommand(
        "check", "Check one ray_cast.cpp before handing it in: a verdict for each answer, never the answer");
    check_app.add_option("source", check.source, "The source, e.g. ray_cast.cpp")->required()->type_name("FILE");
    add_assignment(check_app, check.assignment);
    check_app.add_option("--fail-under", check.fail_under, "Exit with status 1 below this share of the points")
        ->check(CLI::Range(0.0, 100.0))
        ->type_name("PERCENT");
    check_app
        .add_option("--gradescope", check.gradescope,
                    "Also write Gradescope's results.json, as an autograder must: see README, For an autograder")
        ->type_name("FILE.json");
    check_app
        .add_option("--classroom50", check.classroom50,
                    "Also write Classroom 50's result.json, by the environment of its runner; not where there are no "
                    "marks")
        ->type_name("FILE.json");
    add_junit(check_app, check.junit);
    check_app
        .add_option("--html", check.html,
                    "Also write the verdicts as a page for a browser; replaces only an earlier page of raygrade's")
        ->type_name("FILE");
    add_variants(check_app, check.variants);
    add_workshop(check_app, check.workshop);
    check_app.footer(limits_footer() + "\nExample: raygrade check ray_cast.cpp");

    StressOptions stress;
    CLI::App& stress_app = *app.add_subcommand(
        "stress", "Run one ray_cast.cpp on hard scenes: what its method survives, and which formula would do better");
    add_stress_options(stress_app, stress);
    add_assignment(stress_app, stress.assignment);
    add_workshop(stress_app, stress.workshop);

    ServeOptions serve;
    serve.assignment = "default";
    serve.jobs = grade.jobs;
    CLI::App& serve_app = add_serve(app, serve);

    ReferenceOptions reference_options{"default"};
    CLI::App& reference_app =
        *app.add_subcommand("reference", "Print the canonical answers, as a right program prints them or as JSON");
    add_assignment(reference_app, reference_options.assignment);
    reference_app
        .add_option("-p,--precision", reference_options.precision,
                    "The arithmetic; certified encloses every true value and decides exactly")
        ->check(CLI::IsMember({"float", "double", "certified"}))
        ->capture_default_str();
    reference_app
        .add_option("-f,--format", reference_options.format,
                    "text in the handout's own format, or json (raygrade/key/1)")
        ->check(CLI::IsMember({"text", "json"}))
        ->capture_default_str();
    reference_app.footer("Example: raygrade reference --assignment a6-edge --format json");

    CLI::App& cast_app = *app.add_subcommand(
        "cast", "Answer rays exactly: one JSON query a line on stdin, one JSON answer a line on stdout");
    cast_app.footer(
        "A query: "
        "{\"origin\":[0,0,2],\"direction\":[0,0,-1],\"spheres\":[{\"center\":[1,1,0],\"radius\":2}],\"triangles\":[]}\n"
        "Numbers are JSON numbers or hex floats in quotes. t >= 0, edges and vertices are hits, a tangent is one in "
        "the order.");

    AccuracyOptions accuracy;
    CLI::App& accuracy_app = *app.add_subcommand(
        "accuracy", "Show what accuracy costs in time: every method on the same rays, timed and judged");
    accuracy_app
        .add_option("-k,--kernel", accuracy.kernels,
                    "Measure only the methods whose names hold one of these words, e.g. half-b or \"certified\"")
        ->type_name("NAME");
    accuracy_app.add_option("-n,--rays", accuracy.rays, "Rays of each distribution; 0 for as many as fit the time")
        ->type_name("N");
    accuracy_app
        .add_option("-s,--seed", accuracy.seed, "Where the random rays begin; the same seed gives the same rays")
        ->type_name("N")
        ->capture_default_str();
    accuracy_app.add_flag("--quick", accuracy.quick, "Fewer rays: below ten seconds rather than below a minute");
    accuracy_app
        .add_option("-a,--assignment", accuracy.assignment,
                    "Tell of this assignment's scene: each answer's error in float, double and long double, which "
                    "decisions hang on rounding, what the certified answers cost. Alone it measures nothing else")
        ->type_name("NAME|FILE");
    accuracy_app
        .add_option("-o,--out", accuracy.out,
                    "The folder for accuracy.html, accuracy.svg, accuracy.json and accuracy.csv; without it nothing is "
                    "written")
        ->type_name("DIR");
    accuracy_app.add_flag("--force", accuracy.force, "Replace the results of an earlier run in the output folder");
    accuracy_app
        .add_option("-f,--format", accuracy.format,
                    "What to print: a table to read, everything as JSON, or the rows as CSV")
        ->check(CLI::IsMember({"text", "json", "csv"}))
        ->capture_default_str();
    accuracy_app.footer(
        "Every method gets the same rays in one run, in turn, so that a busy machine slows all alike; every answer is\n"
        "judged by exact arithmetic. Benign rays are a usual picture's; hard ones aim at what rounding gets wrong. A "
        "`*`\n"
        "marks the frontier: no method is at once faster and less often wrong. Times depend on the machine, wrong\n"
        "decisions on the seed and the compiler's flags, which the reports name.\n\n"
        "Examples: raygrade accuracy --quick\n"
        "          raygrade accuracy --out accuracy            the pictures, for a browser, a printer or a slide\n"
        "          raygrade accuracy --assignment a6-2021      is float enough for this scene?");

    ExplainOptions explain{{}, "default"};
    CLI::App& explain_app = *app.add_subcommand(
        "explain", "Draw the assignment as SVG: camera, image plane, ray, objects, hit points, by the handout's names");
    explain_app
        .add_option("transcript", explain.transcript,
                    "What a program printed: its wrong points and vectors are drawn beside the right ones")
        ->type_name("TRANSCRIPT");
    add_assignment(explain_app, explain.assignment);
    explain_app.add_option("-o,--out", explain.out, "Where to write the picture; - for stdout")
        ->type_name("FILE")
        ->capture_default_str();
    explain_app.add_flag("--force", explain.force, "Replace an earlier picture");
    explain_app.add_flag("--without-answers", explain.without_answers,
                         "For a student: draw what the handout gives and what was printed, and nothing of the key");
    explain_app.footer("Example: ./ray_cast > output.txt; raygrade explain output.txt -o explain.svg");

    RenderOptions render;
    CLI::App& render_app =
        *app.add_subcommand("render", "Draw the scene as its camera sees it, and simulate only what it calls for");
    add_render(render_app, render);

    CLI::App& doctor_app = *app.add_subcommand("doctor", "Say what this machine has and lacks for grading");

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? all_graded : usage;
    }
    if (grade_app.parsed()) return grade_command(grade);
    if (override_app.parsed()) return override_command(given);
    if (check_app.parsed()) return check_command(check);
    if (stress_app.parsed()) return stress_command(stress);
    if (serve_app.parsed()) return serve_command(serve);
    if (reference_app.parsed()) return reference_command(reference_options);
    if (cast_app.parsed()) return cast_command();
    if (accuracy_app.parsed()) return accuracy_command(accuracy);
    if (explain_app.parsed()) return explain_command(explain);
    if (render_app.parsed()) return render_command(render);
    return doctor_app.parsed() ? doctor_command() : usage;
}

}  // namespace

int main(int argc, char** argv) {
    std::setlocale(LC_CTYPE, "C.UTF-8");
    try {
        const int status = run(argc, argv);
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
            throw HarnessError(
                "stdout can't be written to, so something of what it should show is missing; is the disk full?");
        }
        return status;
    } catch (const UsageError& error) {
        fmt::print(stderr, "raygrade: {}\n", error.what());
        return usage;
    } catch (const LimitError& error) {
        fmt::print(stderr, "raygrade: {}\n", error.what());
        return usage;
    } catch (const reference::AssignmentError& error) {
        fmt::print(stderr, "raygrade: {}\n", error.what());
        return usage;
    } catch (const std::domain_error& error) {
        fmt::print(stderr, "raygrade: {}\n", error.what());
        return usage;
    } catch (const HarnessError& error) {
        fmt::print(stderr, "raygrade: {}\n", error.what());
        return some_not_graded;
    } catch (const std::exception& error) {
        fmt::print(stderr, "raygrade: a fault of raygrade: {}\nPlease report it with the command you ran.\n",
                   error.what());
        return our_fault;
    }
}
