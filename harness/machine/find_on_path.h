// Finding a program: as a shell does, or one of our own.
#pragma once

#include <filesystem>
#include <string>

namespace harness {

/// The absolute path of the first executable file called `name` in a folder of $PATH; empty when there is none. Folders
/// that are not absolute are passed over: they depend on where one stands.
std::filesystem::path find_on_path(const std::string& name);

/// A program that comes with raygrade: beside this executable, or where the build put it. Throws HarnessError when
/// there is none.
std::filesystem::path find_companion(const std::string& name, const std::filesystem::path& built);

/// $PATH, printable, for a message.
std::string shown_path();

}  // namespace harness
