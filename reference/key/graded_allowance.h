// The error that marking accepts: the key's allowances, widened by the rubric's tolerance.
#pragma once

#include "reference/key/answer.h"
#include "reference/toml/rubric.h"

namespace reference {

/// Whether a correct program in float32 is near the answer, with any formulas: its allowance has a bound. Without one,
/// e.g. at a tangent, an answer can't be judged by its number.
bool float_can_answer(const Answer& answer);

/// By component, how far an answer may be from the key's enclosure: the certified allowance, or more if the rubric
/// widens it; infinite if float can't answer. Empty for NoValue and a first object.
Numbers graded_allowance(const KeyItem& item, const Answer& answer, const Rubric& rubric);

}  // namespace reference
