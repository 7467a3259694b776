// The least that primary visibility takes, written by hand over the kernel: what the compiled loop is measured by.
#pragma once

#include <span>

#include "reference/render/prepared_scene.h"

/// One row of the picture: the color by the normal of what each camera ray hits first.
void minimal_row(const reference::render::PreparedScene& scene, int y, std::span<reference::Color> colors);
