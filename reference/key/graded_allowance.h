// The error that marking accepts: the key's allowances, widened by the rubric's tolerance.
#pragma once

#include "reference/key/answer_key.h"

namespace reference {

/// By component, how far an answer may be from the key's enclosure: the certified allowance, or more where the rubric
/// widens it. It is finite even where nothing bounds a correct program's value. Empty for NoValue and verdicts.
Numbers graded_allowance(const KeyItem& item, const Answer& answer, const Rubric& rubric);

}  // namespace reference
