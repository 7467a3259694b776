// Runs independent readers on a file that the harness wrote.
#pragma once

#include <string>

/// The output of a shell command that finds `content` in the file $1. Fails the test if the command fails.
std::string told_by(const std::string& command, const std::string& content);

/// The output of a Python program that finds `content` in the file sys.argv[1]. csv, json, sys and zipfile are
/// imported.
std::string python(const std::string& program, const std::string& content);
