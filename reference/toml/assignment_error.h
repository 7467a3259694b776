// An error in an assignment file.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace reference {

/// The assignment can't be used. what() is a complete message: file, line, key, what is wrong and how to fix it.
class AssignmentError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
    /// For an error about a key: its place "file:line: sphere[1].radius", its path there and the error.
    AssignmentError(const std::string& place, std::string key, std::string problem)
        : std::runtime_error(place + " " + problem), key_(std::move(key)), problem_(std::move(problem)) {}

    /// "sphere[1].radius"; empty if the error is not about a key.
    const std::string& key() const { return key_; }
    /// "is -2, and must be above 0"; empty if the error is not about a key.
    const std::string& problem() const { return problem_; }

  private:
    std::string key_;
    std::string problem_;
};

}  // namespace reference
