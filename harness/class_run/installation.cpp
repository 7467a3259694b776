#include "harness/class_run/installation.h"

namespace harness {

std::filesystem::path assignments_folder() {
    return RAYGRADE_ASSIGNMENTS;
}

}  // namespace harness
