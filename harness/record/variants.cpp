#include "harness/record/variants.h"

namespace harness {

std::string_view to_string(VariantsVerdict verdict) {
    switch (verdict) {
        case VariantsVerdict::computes: return "computes";
        case VariantsVerdict::breaks: return "breaks";
        case VariantsVerdict::does_not_move: return "does_not_move";
        case VariantsVerdict::not_found: return "not_found";
    }
    return "";
}

}  // namespace harness
