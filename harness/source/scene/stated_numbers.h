// The points and numbers that a source states, with their names. scene_literals decides their meaning.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/source/code/constant.h"
#include "harness/source/code/words.h"

namespace harness::source {

/// A constant and its place in the source.
struct StatedNumber {
    Constant constant;
    std::size_t begin = 0;
    std::size_t end = 0;
    bool in_define = false;  ///< there a negative number needs brackets
    bool certain = true;     ///< surely compiled
};

/// `R = 2`, `R(2)`, `R{2}` or `#define R 2`.
struct NamedNumber {
    std::string name;
    StatedNumber number;
};

/// Three constants next to each other.
struct StatedVector {
    std::array<double, 3> value{};
    std::vector<StatedNumber> numbers;    ///< three; or a single number for all three, as in vec3(2)
    std::vector<StatedNumber> following;  ///< the constants after them in the same brackets, at most three
    std::string name;                     ///< of the variable that it initializes; empty if it has no name
    std::string_view callee;              ///< the type or function before its bracket, such as "vec3"; may be empty
    bool weak = false;                    ///< part of a longer list, which may mean something else
};

/// The text between two commas of a list: a vector, a number, or something else.
struct ListElement {
    std::optional<std::size_t> vector;  ///< into SourceNumbers::vectors
    std::optional<StatedNumber> number;
};

struct StatedList {
    std::string_view callee;  ///< the function or type before its bracket; may be empty
    std::string name;         ///< of the variable that it initializes; may be empty
    std::vector<ListElement> elements;

    /// The numbers next to each other from this element on.
    std::vector<StatedNumber> numbers_from(std::size_t first) const;
};

struct SourceNumbers {
    std::vector<StatedVector> vectors;
    std::vector<NamedNumber> named;
    std::vector<StatedList> lists;       ///< lists that contain at least one vector
    std::vector<StatedNumber> literals;  ///< every number literal separately, in order
};

/// Takes time linear in the number of words.
SourceNumbers stated_numbers(const std::vector<Word>& words);

}  // namespace harness::source
