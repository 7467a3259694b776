// What marking forgives: the key's allowances with the rubric's tolerance.
#pragma once

#include "reference/answer_key.h"

namespace reference {

/// By component, how far an answer may be from the key's enclosure: the certified allowance, or more where the rubric
/// widens it; finite also where nothing bounds what a correct program finds. Empty for NoValue and verdicts.
Numbers graded_allowance(const KeyItem& item, const Answer& answer, const Rubric& rubric);

}  // namespace reference
