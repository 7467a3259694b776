#include "harness/gradebook/author.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <ctime>

namespace harness {
namespace {

std::string account_name() {
    const passwd* account = getpwuid(geteuid());
    return account == nullptr ? fmt::format("user {}", geteuid()) : account->pw_name;
}

}  // namespace

Author author_now(const std::string& name) {
    return {name.empty() ? account_name() : name,
            fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))};
}

}  // namespace harness
