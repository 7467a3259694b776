#include "harness/sandbox/scratch.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "harness/failure.h"
#include "harness/names.h"
#include "harness/sandbox/removal.h"

namespace harness {

namespace {

/// The harness keeps its way in through its group, also as a root that is held to permissions.
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
    throw HarnessError("Could not make a scratch folder below " + in_quotes(workspace.path()) + ": " + why +
                       ". Make room there, or set TMPDIR to a folder that can be written to.");
}

Scratch::~Scratch() {
    remove_folder(path_);
}

}  // namespace harness
