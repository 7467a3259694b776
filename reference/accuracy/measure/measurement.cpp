#include "reference/accuracy/measure/measurement.h"

namespace reference::accuracy {

std::string name_of(Primitive primitive) {
    switch (primitive) {
        case Primitive::sphere: return "sphere";
        case Primitive::triangle: return "triangle";
        case Primitive::cast: return "cast";
    }
    return "";
}

}  // namespace reference::accuracy
