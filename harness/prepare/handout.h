// The handout that an instructor gives to students. Both formats have the same text, and no answers.
#pragma once

#include <string>

#include "reference/toml/assignment.h"

namespace harness::prepare {

/// The scene as an SVG file, without hit points and answers.
std::string handout_picture(const reference::Assignment& assignment);

/// A page to print, with the picture in it. It loads nothing. `student`: see handout_text.
std::string handout_html(const reference::Assignment& assignment, const std::string& student);

/// `picture` is the address of the picture; empty leaves it out.
std::string handout_markdown(const reference::Assignment& assignment, const std::string& student,
                             const std::string& picture);

}  // namespace harness::prepare
