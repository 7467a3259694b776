// Whole reports as they are meant to be: files of tests/given/golden. RAYGRADE_UPDATE_GOLDEN=1 writes them anew.
#pragma once

#include <gtest/gtest.h>

#include <string>

/// Whether the text is that of the file; otherwise tells the first line that differs.
testing::AssertionResult is_golden(const std::string& text, const std::string& file);

/// A page without its style, its script and its pictures.
std::string bare(std::string page);
