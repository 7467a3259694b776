// Scenes and answers for the tests of the explaining picture.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "harness/grade.h"

namespace picture_scenes {

struct Named {
    std::string name;
    std::string toml;
};

/// All that is hard to draw: any scale, any camera, no sphere, no triangle, tangent, grazing, a start on the triangle,
/// an eye within a huge sphere, objects far away or all over each other.
const std::vector<Named>& hard_scenes();
harness::Marking marking_of(const Named& scene);
harness::Marking marking_of(const std::string& name);  ///< one of them
harness::Marking random_marking(std::uint64_t seed);

/// What grading a program with this output gives.
harness::Graded graded(const std::string& output, const harness::Marking& marking);

/// Answers that are right, near, wild, not finite or none at all, as the seed says.
std::string random_output(std::uint64_t seed, const harness::Marking& marking);

}  // namespace picture_scenes
