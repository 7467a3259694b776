// What accuracy costs at scale: a mesh, and what a ray hits first in it.
#pragma once

#include <functional>
#include <memory>

#include "reference/accuracy/measure/measurement.h"
#include "reference/accuracy/mesh/embree.h"
#include "reference/accuracy/mesh/mesh.h"

namespace reference::accuracy {

/// Adds the rows of every method on every set of rays at the mesh, with the measurement's seed, rays and repetitions;
/// and, where `embree` is null, the note that its rows are missing. A row's wrong answers are those whose verdict is
/// not right. Reports the share that is done to `progress`.
void measure_mesh(Measurement& measurement, const Mesh& mesh, const std::shared_ptr<const EmbreeLibrary>& embree,
                  const std::function<void(double)>& progress);

}  // namespace reference::accuracy
