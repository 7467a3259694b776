// A value of the key in JSON, the same in the key and in grades.
#pragma once

#include <nlohmann/json.hpp>

#include "reference/key/answer.h"
#include "reference/stages/items.h"

namespace reference {

/// A scalar as a number, a vector as an array, a matrix as an array of columns, a first object as its sentence, no
/// value as null.
nlohmann::ordered_json value_json(const Value& value, Shape shape);

}  // namespace reference
