#include "tests/given/hard_scenes/held.h"

#include <fmt/format.h>

#include "reference/key/key_formats.h"
#include "tests/given/printed_values.h"

namespace harness::stress {

student::Marking held(student::Marking marking, reference::PixelConvention convention) {
    marking.assignment.rubric.pixel_conventions = {convention};
    marking.key = reference::make_key(marking.assignment, reference::Precision::certified);
    return marking;
}

student::Marking far_sphere() {
    student::Marking marking = student::handout_scene();
    const auto decimal = [](const char* text) { return reference::Decimal::parse(text).value(); };
    marking.assignment.scene.spheres.front() = {{decimal("0"), decimal("0"), decimal("-99998")}, decimal("1")};
    return held(std::move(marking));
}

std::string right_printout(const student::Marking& marking) {
    return reference::to_text(marking.key);
}

std::vector<HardItem> losses_of(const std::string& printed, const student::Marking& marking) {
    return losses(::mark(right_printout(marking), marking), ::mark(printed, marking),
                  {marking.assignment, marking.key});
}

std::vector<std::string> told_losses(const std::string& printed, const student::Marking& marking) {
    std::vector<std::string> told;
    for (const HardItem& item : losses_of(printed, marking))
        told.push_back(fmt::format("{}.{}: {}", item.question, item.item, to_string(item.loss)));
    return told;
}

}  // namespace harness::stress
