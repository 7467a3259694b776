#include "harness/report/compile_error/known_headers.h"

#include <algorithm>
#include <iterator>

#include "harness/text/lower_case.h"

namespace harness::report {
namespace {

/// Headers that raygrade's compiler has and that students use, to find wrong case or a wrong folder.
constexpr std::string_view known_headers[] = {
    "algorithm",
    "array",
    "cassert",
    "cfloat",
    "chrono",
    "climits",
    "cmath",
    "cstdio",
    "cstdlib",
    "cstring",
    "fstream",
    "functional",
    "glm/ext.hpp",
    "glm/glm.hpp",
    "glm/gtc/constants.hpp",
    "glm/gtc/epsilon.hpp",
    "glm/gtc/matrix_access.hpp",
    "glm/gtc/matrix_inverse.hpp",
    "glm/gtc/matrix_transform.hpp",
    "glm/gtc/type_ptr.hpp",
    "glm/gtx/component_wise.hpp",
    "glm/gtx/intersect.hpp",
    "glm/gtx/io.hpp",
    "glm/gtx/norm.hpp",
    "glm/gtx/normal.hpp",
    "glm/gtx/string_cast.hpp",
    "glm/gtx/transform.hpp",
    "glm/mat3x3.hpp",
    "glm/mat4x4.hpp",
    "glm/matrix.hpp",
    "glm/vec2.hpp",
    "glm/vec3.hpp",
    "glm/vec4.hpp",
    "iomanip",
    "iostream",
    "iterator",
    "limits",
    "map",
    "math.h",
    "memory",
    "numeric",
    "optional",
    "random",
    "sstream",
    "stdexcept",
    "stdio.h",
    "stdlib.h",
    "string",
    "string.h",
    "tuple",
    "unistd.h",
    "utility",
    "vector",
};

struct Elsewhere {
    std::string_view header, system;
};
/// In lower case.
constexpr Elsewhere of_other_systems[] = {
    {"conio.h", "Windows"},     {"corecrt_math_defines.h", "Windows"},
    {"direct.h", "Windows"},    {"glut/glut.h", "macOS"},
    {"io.h", "Windows"},        {"opengl/gl.h", "macOS"},
    {"opengl/gl3.h", "macOS"},  {"pch.h", "Visual Studio"},
    {"process.h", "Windows"},   {"stdafx.h", "Visual Studio"},
    {"targetver.h", "Windows"}, {"tchar.h", "Windows"},
    {"windows.h", "Windows"},
};

struct Declared {
    std::string_view name, header;
};
/// Names for which g++ 12 does not suggest the header.
constexpr Declared declared_in[] = {
    {"abs", "cmath"},
    {"acos", "cmath"},
    {"cos", "cmath"},
    {"fabs", "cmath"},
    {"fixed", "iostream"},
    {"glm", "glm/glm.hpp"},
    {"glm::inverseTranspose", "glm/gtc/matrix_inverse.hpp"},
    {"glm::length2", "glm/gtx/norm.hpp"},
    {"glm::lookAt", "glm/gtc/matrix_transform.hpp"},
    {"glm::perspective", "glm/gtc/matrix_transform.hpp"},
    {"glm::rotate", "glm/gtc/matrix_transform.hpp"},
    {"glm::scale", "glm/gtc/matrix_transform.hpp"},
    {"glm::to_string", "glm/gtx/string_cast.hpp"},
    {"glm::translate", "glm/gtc/matrix_transform.hpp"},
    {"glm::value_ptr", "glm/gtc/type_ptr.hpp"},
    {"M_PI", "cmath"},
    {"pow", "cmath"},
    {"sin", "cmath"},
    {"sqrt", "cmath"},
    {"std::fixed", "iostream"},
    {"std::max", "algorithm"},
    {"std::min", "algorithm"},
    {"std::pow", "cmath"},
    {"std::numeric_limits", "limits"},
    {"std::setfill", "iomanip"},
    {"std::setprecision", "iomanip"},
    {"std::setw", "iomanip"},
    {"std::sort", "algorithm"},
    {"std::sqrt", "cmath"},
    {"std::swap", "utility"},
    {"tan", "cmath"},
};

}  // namespace

std::string header_meant(std::string_view header) {
    std::string small = lower_case(header);
    std::replace(small.begin(), small.end(), '\\', '/');
    for (const std::string& candidate : {small, small + ".hpp", small + ".h", small + "pp"}) {
        for (const std::string_view known : known_headers) {
            const bool is_inside =
                known.size() > candidate.size() && known.starts_with("glm/") && known.ends_with("/" + candidate);
            if (known == candidate || is_inside) return std::string(known);
        }
    }
    // A path to the student's own copy of GLM.
    if (const std::size_t glm = small.rfind("/glm/"); glm != std::string::npos) {
        const std::string below = small.substr(glm + 1), meant = header_meant(below);
        return meant.empty() && below.ends_with(".hpp") ? below : meant;
    }
    const std::size_t slash = small.rfind('/');
    if (slash == std::string::npos || small.find("glm") == std::string::npos) return "";
    const std::string meant = header_meant(small.substr(slash + 1));
    return meant.starts_with("glm/") ? meant : "";
}

bool is_of_newer_standard(std::string_view name) {
    // Headers, their names in std that programs use, and members of std's types.
    constexpr std::string_view newer[] = {
        "barrier",     "bit",       "bit_cast",       "char8_t",         "compare",   "concept",  "concepts",
        "consteval",   "constinit", "contains",       "coroutine",       "ends_with", "erase_if", "expected",
        "flat_map",    "flat_set",  "floating_point", "format",          "generator", "integral", "jthread",
        "latch",       "lerp",      "mdspan",         "midpoint",        "numbers",   "print",    "println",
        "ranges",      "requires",  "semaphore",      "source_location", "span",      "ssize",    "stacktrace",
        "starts_with", "stdfloat",  "stop_token",     "syncstream",      "views"};
    return std::ranges::find(newer, name) != std::end(newer);
}

std::string_view system_of_header(std::string_view header) {
    const std::string small = lower_case(header);
    const auto* found = std::find_if(std::begin(of_other_systems), std::end(of_other_systems),
                                     [&](const Elsewhere& elsewhere) { return elsewhere.header == small; });
    return found == std::end(of_other_systems) ? "" : found->system;
}

std::string_view header_of_name(std::string_view name) {
    const auto* found = std::find_if(std::begin(declared_in), std::end(declared_in),
                                     [&](const Declared& declared) { return declared.name == name; });
    return found == std::end(declared_in) ? "" : found->header;
}

}  // namespace harness::report
