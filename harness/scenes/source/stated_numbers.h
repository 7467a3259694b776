// The points and numbers that a source states, with the names it gives them. What they mean is for scene_literals to
// say.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/variants/constant.h"
#include "harness/variants/words.h"

namespace harness::variants {

/// A constant, and the bytes of the source that state it.
struct StatedNumber {
    Constant constant;
    std::size_t begin = 0;
    std::size_t end = 0;
    bool in_define = false;  ///< where a negative number goes into brackets
    bool certain = true;     ///< surely compiled
};

/// `R = 2`, `R(2)`, `R{2}` or `#define R 2`.
struct NamedNumber {
    std::string name;
    StatedNumber number;
};

/// Three constants that stand together.
struct StatedVector {
    std::array<double, 3> value{};
    std::vector<StatedNumber> numbers;      ///< three; one where it stands for all three, as in vec3(2)
    std::optional<StatedNumber> following;  ///< the constant behind them in the same brackets
    std::string name;                       ///< of what it initialises; empty where that has none
    std::string_view callee;                ///< what stands before its bracket, such as "vec3"; may be empty
    bool weak = false;                      ///< part of a longer list, which may mean something else
};

/// What stands between two commas of a list: a vector, a number, or something else.
struct ListElement {
    std::optional<std::size_t> vector;  ///< into SourceNumbers::vectors
    std::optional<StatedNumber> number;
};

struct StatedList {
    std::string_view callee;  ///< the function or type before its bracket; may be empty
    std::vector<ListElement> elements;
};

struct SourceNumbers {
    std::vector<StatedVector> vectors;
    std::vector<NamedNumber> named;
    std::vector<StatedList> lists;       ///< that hold at least one vector
    std::vector<StatedNumber> literals;  ///< every number literal by itself, in order
};

/// In time linear in the number of words.
SourceNumbers stated_numbers(const std::vector<Word>& words);

}  // namespace harness::variants
