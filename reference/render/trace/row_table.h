// The loops for all sets of effects for one way to find objects. Including this file compiles them.
#pragma once

#include <array>
#include <utility>

#include "reference/render/trace/trace.h"

namespace reference::render {

constexpr std::size_t effect_sets = 64;

constexpr std::size_t number_of(const Effects& effects) {
    return std::size_t{effects.illumination} + 2 * std::size_t{effects.shadows && effects.illumination} +
           4 * std::size_t{effects.mirrors} + 8 * std::size_t{effects.refraction} +
           16 * std::size_t{effects.supersampling} + 32 * std::size_t{effects.textures && effects.illumination};
}

constexpr Effects effects_numbered(std::size_t number) {
    const auto bit = [&](std::size_t i) { return (number >> i & 1U) != 0; };
    return {bit(0), bit(0) && bit(1), bit(2), bit(3), bit(4), bit(0) && bit(5)};
}

template <class Objects>
RenderRow row_renderer_over(const Effects& effects) {
    constexpr auto table = []<std::size_t... number>(std::index_sequence<number...>) {
        return std::array<RenderRow, effect_sets>{&render_row<effects_numbered(number), Objects>...};
    }
    (std::make_index_sequence<effect_sets>());
    return table[number_of(effects)];
}

}  // namespace reference::render
