// The text of an assignment's handout. handout.h writes it as HTML and Markdown.
#pragma once

#include <string>
#include <vector>

#include "reference/toml/assignment.h"

namespace harness::prepare {

/// A piece of a handout, as plain text.
struct Block {
    enum class Kind { title, heading, paragraph, fact, picture, question, part, item };
    Kind kind;
    std::string text;
    std::string label = {};  ///< of a fact: "Camera"
};

/// The scene and the questions, without answers. `student` is the person who gets this scene; empty for nobody.
std::vector<Block> handout_text(const reference::Assignment& assignment, const std::string& student);

}  // namespace harness::prepare
