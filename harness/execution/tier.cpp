#include "harness/execution/tier.h"

namespace harness {

std::string sandbox_warning(Tier tier) {
    if (tier != Tier::unsafe) return {};
    return "Graded without a sandbox (--unsafe): a submission could have read and changed anything that the grading "
           "account can, including these reports and the answer key.";
}

}  // namespace harness
