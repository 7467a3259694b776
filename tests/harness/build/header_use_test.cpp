#include "harness/build/header_use.h"

#include <gmock/gmock.h>

namespace {

using harness::header_use;
using harness::HeaderUse;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(HeaderUse, HasTheSlowIncludesSortedAndEachOnce) {
    const HeaderUse use = header_use(
        "#include <iostream>\n#include \"glm/glm.hpp\"\n#include <cmath>\n#include <glm/glm.hpp>\nint main() {}\n");
    EXPECT_THAT(use.lines, ElementsAre("#include <glm/glm.hpp>", "#include <iostream>"));
    EXPECT_THAT(use.rest, testing::MatchesRegex(" +\n +\n#include <cmath>\n +\nint main.*\n"));
    EXPECT_EQ(use.last_line, 4U);
}

TEST(HeaderUse, LeavesTheOtherHeadersInTheSource) {
    const HeaderUse use = header_use("#include <string>\n#include <iostream>\n#include <glm/gtc/type_ptr.hpp>\n");
    EXPECT_THAT(use.lines, ElementsAre("#include <iostream>"));
    EXPECT_EQ(use.rest, "#include <string>\n" + std::string(19, ' ') + "\n#include <glm/gtc/type_ptr.hpp>\n");
    EXPECT_EQ(use.last_line, 2U);
}

TEST(HeaderUse, EndsBeforeADirectiveThatMayChangeWhatFollows) {
    for (const char* other : {"#include <unistd.h>", "#include <complex.h>", "#include \"own/glm/glm.hpp\"",
                              "#include <glm/gtx/fast_trigonometry.hpp>", "#define PI 3.14", "#define NDEBUG",
                              "#define GLM_FORCE_RADIANS", "int i;"}) {
        const std::string rest = std::string(other) + "\n#include <glm/glm.hpp>\n";
        const HeaderUse use = header_use("#include <iostream>\n" + rest);
        EXPECT_THAT(use.lines, ElementsAre("#include <iostream>")) << other;
        EXPECT_EQ(use.rest, std::string(19, ' ') + '\n' + rest);
        EXPECT_EQ(use.last_line, 1U);
    }
}

TEST(HeaderUse, HasTheMacrosThatHeadersReadIfTheyComeFirst) {
    const HeaderUse use =
        header_use("#define GLM_FORCE_RADIANS\n#define _USE_MATH_DEFINES\n#include <cmath>\n#include <iostream>\n");
    EXPECT_THAT(use.lines,
                ElementsAre("#define GLM_FORCE_RADIANS", "#define _USE_MATH_DEFINES", "#include <iostream>"));
    EXPECT_THAT(use.rest, testing::MatchesRegex(" +\n +\n#include <cmath>\n +\n"));
    const std::string late = "#include <cmath>\n#define GLM_FORCE_RADIANS\n#include <iostream>\n";
    EXPECT_EQ(header_use(late).rest, late) << "the setting does not come first";
}

TEST(HeaderUse, LeavesTheMacroOfTheCoursesFlagsInTheSource) {
    const HeaderUse use =
        header_use("#include <iostream>\n#define GLM_ENABLE_EXPERIMENTAL\n#include <glm/glm.hpp> // vec3\n");
    EXPECT_THAT(use.lines, ElementsAre("#include <glm/glm.hpp>", "#include <iostream>"));
    EXPECT_EQ(use.rest,
              std::string(19, ' ') + "\n#define GLM_ENABLE_EXPERIMENTAL\n" + std::string(22, ' ') + " // vec3\n");
    EXPECT_EQ(use.last_line, 3U);
}

TEST(HeaderUse, LeavesASourceWithoutSlowHeadersAsItIs) {
    for (const std::string source :
         {"", "int i;\n", "#define NDEBUG\nint i;\n", "#define NDEBUG\n#include <cmath>\nint i;\n",
          "#define PI 3\n#include <iostream>\n"}) {
        EXPECT_THAT(header_use(source).lines, IsEmpty());
        EXPECT_EQ(header_use(source).rest, source);
    }
}

}  // namespace
