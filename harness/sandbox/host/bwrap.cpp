#include "harness/sandbox/host/bwrap.h"

#include <initializer_list>
#include <system_error>

namespace harness {
namespace {

namespace fs = std::filesystem;

class Arguments {
  public:
    void add(std::initializer_list<std::string> words) { words_.insert(words_.end(), words); }
    void show(const fs::path& path) { add({"--ro-bind", path.string(), path.string()}); }
    std::vector<std::string> take() { return std::move(words_); }

  private:
    std::vector<std::string> words_;
};

/// Adds /lib and the like, which on Debian 12 are links into /usr.
void add_links(Arguments& arguments) {
    for (const char* name : {"/bin", "/lib", "/lib32", "/lib64", "/libx32"}) {
        std::error_code error;
        const fs::path target = fs::read_symlink(name, error);
        if (!error) arguments.add({"--symlink", target.string(), name});
    }
}

}  // namespace

std::vector<std::string> bwrap_arguments(const Command& command, const Sandbox& sandbox) {
    Arguments arguments;
    arguments.add({sandbox.bwrap().string()});
    // --unshare-user is needed as well, because --unshare-all only tries to make a user namespace.
    arguments.add({"--unshare-all", "--unshare-user", "--disable-userns", "--new-session", "--as-pid-1"});
    arguments.add({"--hostname", "sandbox"});
    for (const auto& folder : system_folders(command.purpose)) arguments.show(folder);
    add_links(arguments);
    for (const auto& path : command.readable) arguments.show(path);
    arguments.add({"--proc", "/proc", "--dev", "/dev"});
    arguments.add({"--ro-bind", sandbox.supervisor().string(), "/supervisor"});
    if (!command.preload.empty()) {
        const std::string library = sandbox.library_inside(command.preload).string();
        arguments.add({"--ro-bind", command.preload.string(), library, "--setenv", "LD_PRELOAD", library});
    }
    const std::string inside = sandbox.inside(command.working_directory).string();
    arguments.add({command.purpose == Purpose::compile ? "--bind" : "--ro-bind", command.working_directory.string(),
                   inside, "--chdir", inside});
    // The file systems that bwrap mounts itself have no size limit. Writing to /proc has effects outside the sandbox,
    // e.g. on which process the kernel kills when memory runs out.
    arguments.add({"--remount-ro", "/dev", "--remount-ro", "/proc", "--remount-ro", "/", "--", "/supervisor"});
    return arguments.take();
}

}  // namespace harness
