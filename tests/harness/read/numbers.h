// What tests of reading compare: the numbers of the values that were read.
#pragma once

#include <vector>

#include "harness/read/printed_value.h"

namespace harness {

using Numbers = std::vector<double>;

inline Numbers numbers_of(const std::vector<PrintedValue>& values) {
    Numbers numbers;
    for (const PrintedValue& value : values) {
        for (const PrintedNumber& number : value.numbers) numbers.push_back(number.value);
    }
    return numbers;
}

}  // namespace harness
