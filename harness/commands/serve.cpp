#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <memory>

#include "harness/class_run/class_run.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/parts.h"
#include "harness/machine/say.h"
#include "harness/run/runner.h"
#include "harness/serve/http/server.h"
#include "harness/serve/http/server_limits.h"
#include "harness/serve/results/graders.h"
#include "harness/serve/site/site.h"
#include "reference/toml/assignment.h"

namespace harness {
namespace {

struct ServeOptions {
    std::string assignment;
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080;       ///< 0 picks a free port
    std::vector<std::string> names;  ///< DNS names by which browsers know the page
    bool behind_proxy = false;
    int jobs = 1;
    int keep_hours = 24;            ///< how long results are kept
    std::filesystem::path state{};  ///< the folder of queue and results; empty for the assignment's own
    RunnerOptions runner;
};

using serve::Reach;

Reach reach_of(const ServeOptions& options) {
    Reach reach;
    reach.loopback = serve::is_loopback(options.host);
    reach.behind_proxy = options.behind_proxy;
    for (const std::string& name : options.names) {
        reach.names.push_back(serve::host_of(name));
        if (name.empty() || reach.names.back().size() != name.size())
            throw UsageError(
                fmt::format("--name {} is not a plain host name; write e.g. --name check.example.edu", name));
    }
    if (reach.behind_proxy && reach.names.empty()) {
        throw UsageError(
            "--behind-proxy also needs --name, the host name in the page's address, e.g. --name check.example.edu");
    }
    return reach;
}

bool is_public(const Reach& reach) {
    return !reach.loopback || reach.behind_proxy;
}

std::filesystem::path state_of(const ServeOptions& options, const std::string& name) {
    if (!options.state.empty()) return options.state;
    if (const auto folder = serve::state_folder(options.assignment, name)) return *folder;
    throw UsageError("neither XDG_STATE_HOME nor HOME is a folder; choose a folder for queue and results with --state");
}

std::unique_ptr<serve::Server> listen(const ServeOptions& options, serve::Site& site) {
    try {
        return std::make_unique<serve::Server>(options.host, options.port, serve::ServerLimits(), site);
    } catch (const serve::ListenError& error) {
        throw UsageError(error.what());
    }
}

void announce(const ServeOptions& options, const Reach& reach, const serve::About& about, std::uint16_t port) {
    if (!reach.loopback) {
        say("raygrade: warning: everyone who can reach {} can use this page, and all data crosses the network "
            "unencrypted. Outside a trusted network, use a proxy with a certificate and --behind-proxy; see `raygrade "
            "help self-check-page`.\n",
            options.host);
    }
    if (reach.behind_proxy) {
        fmt::print("Open https://{}/ once its proxy forwards requests to {}\n", reach.names.front(),
                   serve::web_address(options.host, port));
    } else {
        fmt::print("Open {}\n", serve::web_address(options.host, port));
        for (const std::string& name : reach.names) fmt::print("  or {}\n", serve::web_address(name, port));
        if (options.host == "0.0.0.0" || options.host == "::")
            fmt::print("From other machines, use an address of this machine in place of {}\n", options.host);
    }
    if (const std::string sentence = serve::not_shown(about); !sentence.empty()) {
        fmt::print("{} `grade` and `check` give them with --variants.\n", sentence);
    }
    fmt::print("Press Ctrl-C to stop; the queue is kept for the next start.\n");
    std::fflush(stdout);
}

/// Serves until it is stopped.
int serve_pages(const ServeOptions& options) {
    const Reach reach = reach_of(options);
    if (is_public(reach) && options.runner.unsafe) {
        throw UsageError(
            "--unsafe would let anyone on the network run programs without a sandbox. Leave out --unsafe, or leave out "
            "--host and --behind-proxy. `raygrade doctor` says how to get a working sandbox.");
    }
    const reference::AssignmentFile file = reference::read_assignment_file(options.assignment, assignments_folder());
    const reference::Assignment assignment = reference::parse_assignment(file.toml, file.path);
    if (!assignment.dealt.empty()) {
        throw UsageError(
            fmt::format("{0} has a scene for each student, and this page does not know whose program it marks. "
                        "Students can run raygrade check ray_cast.cpp --assignment {1}@ID",
                        file.path.string(), file.path.filename().string()));
    }
    const serve::About about{assignment.title, std::chrono::hours(options.keep_hours),
                             assignment.rubric.variant_points};
    serve::SpoolBounds bounds;
    bounds.age = about.keep;
    serve::KeptPrograms kept_programs(state_of(options, assignment.name), bounds);
    kept_programs.take_for(assignment.name, file.toml);
    constexpr std::size_t longest_queue = 200;
    serve::Queue queue(kept_programs, longest_queue);
    serve::Site site({about, reach}, queue);
    // Opens the port before anything slow, so that a port in use is reported at once.
    const auto server = listen(options, site);
    const ClassRun run = open_class_run(assignment, options.runner);
    tell_key_notes(run.marking);
    if (!queue.is_idle()) say("waiting since the last run: {}\n", queue.queue_length());

    const serve::Graders graders(queue, kept_programs, about, run.runner, run.marking, options.jobs);
    server->stop_on_signals();
    announce(options, reach, about, server->port());
    server->run();
    if (const std::size_t left = queue.leave(); left > 0) {
        say("stopped; kept for the next start: {}\n", left);
        std::fflush(stdout);
        // Exits as if killed, which also ends the programs in the sandbox: a compiler could take minutes.
        std::_Exit(all_graded);
    }
    tell_problems(run.runner);
    say("stopped; the queue is empty\n");
    return all_graded;
}

void add_options(CLI::App& command, ServeOptions& options) {
    add_assignment(command, options.assignment);
    command.add_option("-p,--port", options.port, "The port; 0 picks a free one")
        ->check(number(0, 65'535))
        ->type_name("N")
        ->capture_default_str();
    command
        .add_option("--host", options.host,
                    "The address to listen on; 127.0.0.1 and ::1 are for this machine only, 0.0.0.0 is all addresses")
        ->type_name("ADDRESS")
        ->capture_default_str();
    command
        .add_option("--name", options.names,
                    "The host name in the page's address, e.g. check.example.edu; others are refused")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command.add_flag("--behind-proxy", options.behind_proxy, "An HTTPS proxy forwards the requests; needs --name");
    add_jobs(command, options.jobs, "How many programs to grade at a time");
    command.add_option("--keep", options.keep_hours, "How long results are kept")
        ->check(number(1, 24 * 365))
        ->type_name("HOURS")
        ->capture_default_str();
    command
        .add_option(
            "--state", options.state,
            "The folder for queue and results; by default in $XDG_STATE_HOME/raygrade or ~/.local/state/raygrade")
        ->type_name("DIR");
    add_runner(command, options.runner);
    command.footer(
        "Students upload or paste a program, see their place in the queue, and get verdicts and hints, but no right "
        "values unless the assignment allows it. Nobody can guess the address of a result. Nothing is submitted, and "
        "variant_points are not shown.\n\nExamples: raygrade serve --assignment a6-2021                 this machine "
        "only\n"
        "          raygrade serve --host 192.168.1.20                  a lab, unencrypted\n"
        "          raygrade serve --behind-proxy --name check.uni.edu  behind nginx");
}

}  // namespace

Subcommand serve_command(CLI::App& app) {
    return subcommand(app, "serve", "Run a web page where students check their ray_cast.cpp", add_options, serve_pages);
}

}  // namespace harness
