// A minimal loop for primary visibility, written by hand over the kernel. The compiled loop is measured against it.
#pragma once

#include <span>

#include "reference/render/scene/prepared_scene.h"

/// Renders one row of the picture: each pixel is colored by the normal of the first hit of its camera ray.
void minimal_row(const reference::render::PreparedScene& scene, int y, std::span<reference::Color> colors);
