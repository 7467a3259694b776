// The texts of the folder scripts, for making autograders.
#pragma once

#include <string_view>

namespace harness::autograder::scripts {

extern const std::string_view autograder_py;   ///< Classroom 50's autograder.py
extern const std::string_view raygrade;        ///< starts the program from program_files
extern const std::string_view run_autograder;  ///< Gradescope's
extern const std::string_view self_test_cpp;   ///< a submission that compiles but prints no answers
extern const std::string_view setup;           ///< Gradescope's setup.sh

}  // namespace harness::autograder::scripts
