// Readers that know nothing of our writers.
#pragma once

#include <string>

/// What a shell command prints with `content` in the file $1; fails the test where the command fails.
std::string told_by(const std::string& command, const std::string& content);

/// What a Python program prints that has the path of `content` in sys.argv[1]; csv, json, sys and zipfile are imported.
std::string python(const std::string& program, const std::string& content);
