// Scenes and answers for the tests of the explaining picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/record/graded.h"
#include "harness/record/marking.h"

namespace picture_scenes {

struct Named {
    std::string name;
    std::string toml;
};

/// Scenes that are hard to draw: extreme scales and cameras, no sphere, no triangle, tangent, grazing, a ray that
/// starts on the triangle, an eye inside a huge sphere, objects far away or heaped on each other.
const std::vector<Named>& hard_scenes();
harness::Marking marking_of(const Named& scene);
harness::Marking marking_of(const std::string& name);  ///< of the hard scene with this name
harness::Marking random_marking(std::uint64_t seed);

/// The grading of a program with this output.
harness::Graded graded(const std::string& output, const harness::Marking& marking);

/// Answers drawn from the seed: right, nearly right, wild, not finite, or missing.
std::string random_output(std::uint64_t seed, const harness::Marking& marking);

}  // namespace picture_scenes
