#include "harness/find_submissions.h"

#include "harness/failure.h"
#include "harness/intake.h"

namespace harness {

std::vector<Submission> find_submissions(const std::vector<std::filesystem::path>& paths) {
    try {
        return take_in_all(paths);
    } catch (const HarnessError& error) {
        throw UsageError(error.what());
    }
}

}  // namespace harness
