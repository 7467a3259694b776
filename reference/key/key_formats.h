// The answer key written for a person and for a program.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reference/key/answer_key.h"
#include "reference/stages/items.h"

namespace reference {

/// One value as a right program prints it: 0.585786, vec3(0.000000, 0.000000, -2.000000), a sentence, or "none".
std::string value_text(const Value& value, Shape shape);

/// As a right program prints it: the handout's questions, one labelled answer per line, in glm::to_string's format.
std::string to_text(const AnswerKey& key);

/// The format raygrade/key/1, indented, with a final newline. Numbers read back as the same doubles.
std::string to_json(const AnswerKey& key);

/// One value in JSON, the same in the key and in grades: a scalar as a number, a vector as an array, a matrix as an
/// array of columns, a first object as its sentence, no value as null.
nlohmann::ordered_json value_json(const Value& value, Shape shape);

}  // namespace reference
