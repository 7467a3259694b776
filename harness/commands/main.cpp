// Runs the command line and reports every failure.
#include <unistd.h>

#include <atomic>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string_view>

#include "harness/class_run/exit_status.h"
#include "harness/commands/command_line.h"
#include "harness/machine/errors.h"
#include "harness/machine/say.h"
#include "harness/run/limits.h"
#include "harness/text/escape.h"
#include "reference/toml/assignment_error.h"

namespace {

using namespace harness;

constexpr std::string_view want_of_memory =
    "raygrade: not enough memory, or too few threads. Free some memory, or raise the limits `ulimit -v` and `ulimit "
    "-u`.\n";

/// Reports an exception that no handler can catch, for example from a thread or a destructor. Allocates no memory.
[[noreturn]] void end_with_a_word() {
    static std::atomic_flag told;
    while (told.test_and_set()) pause();  // the first thread ends the process
    constexpr std::string_view fault =
        "raygrade: stopped by a bug in raygrade. Please report it with the command you ran.\n";
    std::string_view word = fault;
    int status = our_fault;
    try {
        if (const auto current = std::current_exception()) std::rethrow_exception(current);
    } catch (const std::exception& error) {
        if (is_for_want_of_memory(error)) {
            word = want_of_memory;
            status = some_not_graded;
        }
    } catch (...) {
    }
    if (write(STDERR_FILENO, word.data(), word.size()) < 0) status = our_fault;
    _exit(status);
}

volatile std::sig_atomic_t a_reader_is_gone = 0;

/// A pipe without a reader, or a file at its size limit, makes the write fail like any other error. These are handlers,
/// because programs that raygrade starts would inherit an ignored signal.
void take_as_errors_of_writes() {
    std::signal(SIGPIPE, [](int) { a_reader_is_gone = 1; });
    std::signal(SIGXFSZ, [](int) {});
}

/// Ends the program after stdout has failed.
int end_without_stdout() {
    if (a_reader_is_gone != 0) {  // every program ends quietly before `| head`
        std::signal(SIGPIPE, SIG_DFL);
        std::raise(SIGPIPE);
    }
    complain(HarnessError("cannot write to stdout, so the output is incomplete. Is the disk full?"));
    return some_not_graded;
}

}  // namespace

int main(int argc, char** argv) {
    std::set_terminate(end_with_a_word);
    take_as_errors_of_writes();
    std::setlocale(LC_CTYPE, "C.UTF-8");
    try {
        const int status = run_command_line(argc, argv);
        return std::fflush(stdout) != 0 || std::ferror(stdout) != 0 ? end_without_stdout() : status;
    } catch (const UsageError& error) {
        complain(error);
        return usage;
    } catch (const LimitError& error) {
        complain(error);
        return usage;
    } catch (const reference::AssignmentError& error) {
        complain(error);
        return usage;
    } catch (const std::domain_error& error) {
        complain(error);
        return usage;
    } catch (const HarnessError& error) {
        complain(error);
        return some_not_graded;
    } catch (const std::exception& error) {
        if (is_for_want_of_memory(error)) {
            say("{}", want_of_memory);
            return some_not_graded;
        }
        if (std::ferror(stdout) != 0) return end_without_stdout();
        say("raygrade: a bug in raygrade: {}\nPlease report it with the command you ran.\n",
            escape_control(error.what()));
        return our_fault;
    }
}
