#include "harness/source/scene/window_numbers.h"

#include <algorithm>
#include <array>
#include <string>

#include "harness/source/scene/part_name.h"
#include "harness/text/lower_case.h"

namespace harness::source {
namespace {

constexpr std::array numbers{
    WindowNumber{"clipLeft", [](std::string_view name) { return name.ends_with("left"); }, &SceneWindow::clip_left,
                 nullptr},
    WindowNumber{"clipRight", [](std::string_view name) { return name.ends_with("right"); }, &SceneWindow::clip_right,
                 nullptr},
    WindowNumber{"clipBottom", [](std::string_view name) { return name.ends_with("bottom"); },
                 &SceneWindow::clip_bottom, nullptr},
    WindowNumber{"clipTop", [](std::string_view name) { return name.ends_with("top"); }, &SceneWindow::clip_top,
                 nullptr},
    WindowNumber{"clipNear", [](std::string_view name) { return name.ends_with("near"); }, &SceneWindow::clip_near,
                 nullptr},
    WindowNumber{
        "W",
        [](std::string_view name) { return name == "w" || name == "nx" || name == "xres" || name.ends_with("width"); },
        nullptr, &SceneWindow::width},
    WindowNumber{
        "H",
        [](std::string_view name) { return name == "h" || name == "ny" || name == "yres" || name.ends_with("height"); },
        nullptr, &SceneWindow::height},
};

}  // namespace

double WindowNumber::value_in(const DecimalScene& scene) const {
    return pixels != nullptr ? scene.window.*pixels : (scene.window.*number).to_double();
}

std::span<const WindowNumber> window_numbers() {
    return numbers;
}

SourceNumbers without_right_edge(SourceNumbers numbers) {
    const auto is_called = [](std::string_view letter) {
        return [letter](const NamedNumber& number) { return last_word(number.name) == letter; };
    };
    if (std::ranges::any_of(numbers.named, is_called("L"))) std::erase_if(numbers.named, is_called("R"));
    return numbers;
}

const WindowNumber* window_number_called(std::string_view name) {
    const std::string plain = lower_case(name.substr(name.find_last_of('.') + 1));
    const auto found =
        std::ranges::find_if(numbers, [&](const WindowNumber& number) { return number.is_called(plain); });
    return found == numbers.end() ? nullptr : &*found;
}

}  // namespace harness::source
