#include "harness/sandbox/host/scratch.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "harness/machine/errors.h"
#include "harness/sandbox/host/removal.h"
#include "harness/text/printable.h"

namespace harness {

namespace {

/// Gives the folder to `account` and to the harness's group. Through the group, even a root that must obey permissions
/// keeps access.
bool give_to(const Account& account, const std::filesystem::path& folder) {
    constexpr mode_t owner_and_group = 0770;
    return chmod(folder.c_str(), owner_and_group) == 0 && chown(folder.c_str(), account.uid, getegid()) == 0;
}

}  // namespace

Scratch::Scratch(const Workspace& workspace) : account_(spare_account()) {
    std::string name = (workspace.path() / "XXXXXX").string();
    const bool made = mkdtemp(name.data()) != nullptr;
    path_ = name;
    if (made && (!account_ || give_to(*account_, path_))) return;
    const std::string why = std::generic_category().message(errno);
    if (made) remove_folder(path_);
    throw HarnessError("Could not create a scratch folder in " + in_quotes(workspace.path()) + ": " + why +
                       ". Free some space there, or set TMPDIR to a folder that you can write to.");
}

Scratch::~Scratch() {
    remove_folder(path_);
}

}  // namespace harness
