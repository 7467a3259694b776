// The pictures that these tests look at.
#pragma once

#include <string>

#include "harness/record/marking.h"
#include "harness/report/picture/picture.h"
#include "tests/given/report/picture_scenes.h"

inline std::string drawing(const harness::Marking& marking, bool with_answers = true) {
    return harness::report::explaining_picture(marking, nullptr, with_answers, "p-");
}

inline std::string picture_of(const harness::Marking& marking, const std::string& output, bool with_answers = true) {
    const harness::Graded student = picture_scenes::graded(output, marking);
    return harness::report::explaining_picture(marking, &student, with_answers, "p-");
}

inline bool has(const std::string& svg, const std::string& words) {
    return svg.find(words) != std::string::npos;
}
