#include "harness/build/header_use.h"

#include <gmock/gmock.h>

namespace {

using harness::header_use;
using harness::HeaderUse;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(HeaderUse, HasTheIncludesSortedAndEachOnce) {
    const HeaderUse use = header_use(
        "#include <vector>\n#include \"glm/glm.hpp\"\n#include <cmath>\n#include <glm/glm.hpp>\nint main() {}\n");
    EXPECT_THAT(use.lines, ElementsAre("#include <cmath>", "#include <glm/glm.hpp>", "#include <vector>"));
    EXPECT_EQ(use.last_line, 4U);
}

TEST(HeaderUse, EndsBeforeADirectiveThatMayChangeWhatFollows) {
    for (const char* other : {"#include <unistd.h>", "#include <complex.h>", "#include \"own/glm/glm.hpp\"",
                              "#include <glm/gtx/fast_trigonometry.hpp>", "#define PI 3.14", "#define NDEBUG",
                              "#define GLM_FORCE_RADIANS", "int i;"}) {
        const std::string rest = std::string(other) + "\n#include <cmath>\n";
        const HeaderUse use = header_use("#include <vector>\n" + rest);
        EXPECT_THAT(use.lines, ElementsAre("#include <vector>")) << other;
        EXPECT_EQ(use.rest, std::string(17, ' ') + '\n' + rest);
        EXPECT_EQ(use.last_line, 1U);
    }
}

TEST(HeaderUse, HasTheMacrosThatHeadersReadIfTheyComeFirst) {
    const HeaderUse use = header_use("#define GLM_FORCE_RADIANS\n#define _USE_MATH_DEFINES\n#include <cmath>\n");
    EXPECT_THAT(use.lines, ElementsAre("#define GLM_FORCE_RADIANS", "#define _USE_MATH_DEFINES", "#include <cmath>"));
    EXPECT_THAT(use.rest, testing::MatchesRegex(" +\n +\n +\n"));
}

TEST(HeaderUse, LeavesTheMacroOfTheCoursesFlagsInTheSource) {
    const HeaderUse use = header_use(
        "#include <iostream>\n#define GLM_ENABLE_EXPERIMENTAL\n#include <glm/gtx/string_cast.hpp> // to_string\n");
    EXPECT_THAT(use.lines, ElementsAre("#include <glm/gtx/string_cast.hpp>", "#include <iostream>"));
    EXPECT_EQ(use.rest,
              std::string(19, ' ') + "\n#define GLM_ENABLE_EXPERIMENTAL\n" + std::string(34, ' ') + " // to_string\n");
    EXPECT_EQ(use.last_line, 3U);
}

TEST(HeaderUse, LeavesASourceWithoutIncludesAsItIs) {
    for (const std::string source : {"", "int i;\n", "#define NDEBUG\nint i;\n", "#define PI 3\n#include <cmath>\n"}) {
        EXPECT_THAT(header_use(source).lines, IsEmpty());
        EXPECT_EQ(header_use(source).rest, source);
    }
}

}  // namespace
