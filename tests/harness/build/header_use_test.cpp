#include "harness/build/header_use.h"

#include <gmock/gmock.h>

namespace {

using harness::header_parts;
using harness::HeaderLines;
using harness::HeaderParts;
using harness::include_block;
using harness::use_of_header;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(HeaderParts, AreTheIncludesSortedAndEachOnce) {
    const HeaderParts parts =
        header_parts({"#include <vector>", "#include \"glm/glm.hpp\"", "#include <cmath>", "#include <glm/glm.hpp>"});
    EXPECT_THAT(parts.includes, ElementsAre("#include <cmath>", "#include <glm/glm.hpp>", "#include <vector>"));
    EXPECT_THAT(parts.settings, IsEmpty());
}

TEST(HeaderParts, EndBeforeAHeaderOfWhichNothingIsKnown) {
    for (const char* other : {"#include <unistd.h>", "#include <complex.h>", "#include \"own/glm/glm.hpp\"",
                              "#include <glm/gtx/fast_trigonometry.hpp>"}) {
        const HeaderParts parts = header_parts({"#include <vector>", other, "#include <cmath>"});
        EXPECT_THAT(parts.includes, ElementsAre("#include <vector>")) << other;
    }
}

TEST(HeaderParts, HoldTheMacrosThatHeadersReadIfTheyComeFirst) {
    const HeaderParts parts = header_parts({"#define GLM_FORCE_RADIANS", "#define MINE 1", "#define _USE_MATH_DEFINES",
                                            "#include <cmath>", "#define NDEBUG", "#include <cassert>"});
    EXPECT_THAT(parts.settings, ElementsAre("#define GLM_FORCE_RADIANS", "#define _USE_MATH_DEFINES"));
    EXPECT_THAT(parts.includes, ElementsAre("#include <cmath>")) << "NDEBUG changes what follows it";
    EXPECT_THAT(lines_of(parts),
                ElementsAre("#define GLM_FORCE_RADIANS", "#define _USE_MATH_DEFINES", "#include <cmath>"));
}

TEST(HeaderParts, DoNotHoldTheMacroOfTheCoursesFlags) {
    const HeaderParts parts =
        header_parts({"#include <iostream>", "#define GLM_ENABLE_EXPERIMENTAL", "#include <glm/gtx/string_cast.hpp>"});
    EXPECT_THAT(parts.includes, ElementsAre("#include <glm/gtx/string_cast.hpp>", "#include <iostream>"));
    EXPECT_THAT(parts.settings, IsEmpty());
}

TEST(HeaderParts, EndBeforeAMacroThatIsTooLongForACommandLine) {
    const std::string macro = "#define A " + std::string(200000, '1');
    EXPECT_THAT(header_parts({"#include <cmath>", macro, "#include <vector>"}).includes,
                ElementsAre("#include <cmath>"));
    const auto block = include_block("#include <cmath>\n" + macro + "\n#include <vector>\n");
    EXPECT_FALSE(use_of_header({"#include <cmath>", "#include <vector>"}, header_lines(block)));
    ASSERT_TRUE(use_of_header({"#include <cmath>"}, header_lines(block)));
    EXPECT_THAT(use_of_header({"#include <cmath>"}, header_lines(block))->own_macros, IsEmpty());
}

TEST(HeaderParts, AreOfTheFirst64Directives) {
    HeaderLines lines(63, "#define A");
    lines.insert(lines.end(), {"#include <cmath>", "#include <vector>"});
    EXPECT_THAT(header_parts(lines).includes, ElementsAre("#include <cmath>"));
}

const HeaderLines header{"#include <cmath>", "#include <iostream>"};

TEST(UseOfHeader, ReplacesItsLinesWhereverTheyStand) {
    const auto block = include_block(
        "#include <vector>\n#include <iostream>\n#include <string>\n#include <cmath>\n#include <iostream>\n"
        "#include <array>\n");
    const auto use = use_of_header(header, header_lines(block));
    ASSERT_TRUE(use);
    EXPECT_THAT(use->replaced, ElementsAre(1, 3, 4));
    EXPECT_THAT(use->own_macros, IsEmpty());
}

TEST(UseOfHeader, NamesTheMacrosDefinedBeforeItsLastLine) {
    const auto block = include_block(
        "#define PI 3.14\n#define SQUARE(x) ((x)*(x))\n#include <cmath>\n#define EMPTY\n#define NONE()\n"
        "#define CALL (1)\n#include <iostream>\n#define BEHIND 1\n#include <vector>\n");
    const auto use = use_of_header(header, header_lines(block));
    ASSERT_TRUE(use);
    EXPECT_THAT(use->replaced, ElementsAre(2, 6));
    std::vector<std::string> names, options;
    for (const harness::Macro& macro : use->own_macros) {
        names.push_back(macro.name);
        options.push_back(macro.option);
    }
    EXPECT_THAT(options, ElementsAre("-DPI= 3.14", "-DSQUARE(x)= ((x)*(x))", "-DEMPTY=", "-DNONE()=", "-DCALL= (1)"));
    EXPECT_THAT(names, ElementsAre("PI", "SQUARE", "EMPTY", "NONE", "CALL"));
}

TEST(UseOfHeader, ReplacesSettingsToo) {
    const HeaderLines left_handed{"#define GLM_FORCE_LEFT_HANDED", "#include <glm/glm.hpp>"};
    const auto block = include_block("#define GLM_FORCE_LEFT_HANDED\n#include <vector>\n#include <glm/glm.hpp>\n");
    const auto use = use_of_header(left_handed, header_lines(block));
    ASSERT_TRUE(use);
    EXPECT_THAT(use->replaced, ElementsAre(0, 2));
    EXPECT_THAT(use->own_macros, IsEmpty());
}

TEST(UseOfHeader, FitsNoSourceThatIncludesLessOrHasOtherSettings) {
    for (const char* source : {
             "#include <cmath>\n",
             "",
             "#define NDEBUG\n#include <cmath>\n#include <iostream>\n",
             "#include <cmath>\n#define NDEBUG\n#include <iostream>\n",
             "#include <cmath>\nint x;\n#include <iostream>\n",
         })
        EXPECT_FALSE(use_of_header(header, header_lines(include_block(source)))) << source;
    EXPECT_FALSE(
        use_of_header({"#define NDEBUG", "#include <cmath>"}, header_lines(include_block("#include <cmath>\n"))));
}

}  // namespace
