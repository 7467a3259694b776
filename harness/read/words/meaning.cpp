#include "harness/read/words/meaning.h"

namespace harness {

std::optional<reference::Subject> object_of(Meaning meaning) {
    switch (meaning) {
        case Meaning::sphere: return reference::Subject::sphere;
        case Meaning::triangle: return reference::Subject::triangle;
        case Meaning::cylinder: return reference::Subject::cylinder;
        default: return std::nullopt;
    }
}

}  // namespace harness
