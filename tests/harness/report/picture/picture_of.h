// The picture that explains a printout.
#pragma once

#include <string>

#include "harness/report/picture/picture.h"
#include "tests/given/report/picture_scenes.h"

namespace harness::report {

inline std::string picture_of(const Marking& marking, const std::string& output, bool with_answers = true) {
    const Graded graded = picture_scenes::graded(output, marking);
    return explaining_picture(marking, &graded, with_answers, "p-");
}

}  // namespace harness::report
