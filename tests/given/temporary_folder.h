// A folder for one test, gone at its end.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "harness/sandbox/workspace.h"

/// Makes files and folders below itself for a test.
class TemporaryFolder {
  public:
    const std::filesystem::path& path() const { return workspace_.path(); }

    /// Writes a file, with the folders it lies in.
    std::filesystem::path write(const std::filesystem::path& name, const std::string& text) const {
        const auto file = path() / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }
    std::filesystem::path make_folder(const std::filesystem::path& name) const {
        std::filesystem::create_directories(path() / name);
        return path() / name;
    }

  private:
    harness::Workspace workspace_;
};
