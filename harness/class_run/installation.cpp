#include "harness/class_run/installation.h"

#include "harness/machine/parts.h"

namespace harness {

std::filesystem::path assignments_folder() {
    return find_part("share/raygrade/assignments");
}

}  // namespace harness
