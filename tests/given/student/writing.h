// A student's own way of writing a printout: a grammar of layouts, drawn independently for each student and the same
// throughout one printout.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <random>
#include <string>

#include "tests/given/student/program.h"

namespace student {

struct Writing {
    std::string output;
    std::map<std::string, std::string> features;  ///< what was drawn: feature -> choice
};

/// What one student chooses among, the same throughout a printout.
class Choices {
  public:
    explicit Choices(std::uint64_t seed) : random_(seed) {}

    /// This student's choice. Drawn when it is first asked for.
    const std::string& one_of(const std::string& feature, std::initializer_list<const char*> choices) {
        const auto [found, is_new] = drawn_.try_emplace(feature);
        if (is_new) found->second = *(choices.begin() + random_() % choices.size());
        return found->second;
    }
    /// The choice that was drawn before.
    const std::string& drawn(const std::string& feature) const { return drawn_.at(feature); }
    const std::map<std::string, std::string>& all() const { return drawn_; }

  private:
    std::mt19937_64 random_;
    std::map<std::string, std::string> drawn_;
};

/// Prints a program's answers in the way of student `seed`.
Writing write(const Program& program, std::uint64_t seed);

}  // namespace student
