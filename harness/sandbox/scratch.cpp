#include "harness/sandbox/scratch.h"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "harness/failure.h"
#include "harness/names.h"
#include "harness/sandbox/removal.h"

namespace harness {

Scratch::Scratch(const Workspace& workspace) : account_(spare_account()) {
    std::string name = (workspace.path() / "XXXXXX").string();
    const bool made = mkdtemp(name.data()) != nullptr;
    path_ = name;
    if (made && (!account_ || chown(path_.c_str(), account_->uid, account_->gid) == 0)) return;
    const std::string why = std::generic_category().message(errno);
    if (made) remove_folder(path_);
    throw HarnessError("Could not make a scratch folder below " + in_quotes(workspace.path()) + ": " + why +
                       ". Make room there, or set TMPDIR to a folder that can be written to.");
}

Scratch::~Scratch() {
    remove_folder(path_);
}

}  // namespace harness
