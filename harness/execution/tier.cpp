#include "harness/execution/tier.h"

namespace harness {

std::string sandbox_warning(Tier tier) {
    if (tier != Tier::unsafe) return {};
    return "Graded without a sandbox (--unsafe): a submission could have read and changed whatever the account that "
           "graded may, these reports and the answer key among it.";
}

}  // namespace harness
