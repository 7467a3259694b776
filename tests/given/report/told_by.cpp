#include "tests/given/report/told_by.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>

#include "tests/given/bytes_of.h"
#include "tests/given/temporary_folder.h"

std::string told_by(const std::string& command, const std::string& content) {
    const TemporaryFolder folder;
    const auto file = folder.write("content", content);
    const auto script = folder.write("script", command);
    const auto told = folder.path() / "told";
    const std::string run = "bash " + script.string() + " " + file.string() + " > " + told.string() + " 2>&1";
    const int status = std::system(run.c_str());
    std::string text = bytes_of(told);
    EXPECT_EQ(status, 0) << text;
    return text;
}

std::string python(const std::string& program, const std::string& content) {
    return told_by("PYTHONUTF8=1 python3 - \"$1\" <<'END'\nimport csv, json, sys, zipfile\n" + program + "\nEND\n",
                   content);
}
