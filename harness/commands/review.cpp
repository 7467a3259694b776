#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/say.h"
#include "harness/review/agenda.h"
#include "harness/review/site.h"
#include "harness/serve/http/server.h"
#include "harness/serve/queue/result_address.h"

namespace harness {
namespace {

struct ReviewOptions {
    std::filesystem::path results = "results";
    std::string by;          ///< empty for the account that runs raygrade
    std::uint16_t port = 0;  ///< 0 picks a free port
};

/// Serves until it is stopped.
int review_class(const ReviewOptions& options) {
    review::Session session(options.results, options.by);
    const std::string secret = serve::new_result_address();
    review::Site site(session, secret);
    const auto open = review::agenda_of(session).open.size();
    const std::string here = "127.0.0.1";
    try {
        serve::Server server(here, options.port, {}, site);
        server.stop_on_signals();
        fmt::print("{} of {} to review\nOpen {}{}/\n", open, session.graded().size(),
                   serve::web_address(here, server.port()), secret);
        fmt::print("Only this machine can open this address. Each decision is saved at once. Press Ctrl-C to stop.\n");
        std::fflush(stdout);
        server.run();
    } catch (const serve::ListenError& error) {
        throw UsageError(error.what());
    }
    return all_graded;
}

void add_options(CLI::App& command, ReviewOptions& options) {
    command.add_option("results", options.results, "The results folder of `raygrade grade`")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_option("--by", options.by, "Your name; by default your account's")->type_name("NAME");
    command.add_option("-p,--port", options.port, "The port; 0 picks a free one")
        ->check(number(0, 65'535))
        ->type_name("N")
        ->capture_default_str();
    command.footer(
        "The review page lists every answer a person should check. You can accept it, change points, correct how it "
        "was "
        "read, or comment, for one student or for everyone with the same answer. The gradebook records who decided, "
        "when and "
        "why. The reports are updated at once.\n\nExample: raygrade review results --by \"Prof. X\"");
}

}  // namespace

Subcommand review_command(CLI::App& app) {
    return subcommand(app, "review", "Check doubtful answers and flags on a page in your browser", add_options,
                      review_class);
}

}  // namespace harness
