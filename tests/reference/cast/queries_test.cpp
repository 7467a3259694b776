#include "reference/cast/queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace {

std::string answer(const std::string& queries) {
    std::istringstream in(queries);
    std::ostringstream out;
    reference::cast::answer_queries(in, out);
    return out.str();
}

const std::string ray = R"("origin":[0,0,2],"direction":[0,0,-1])";
const std::string sphere = R"({"center":[1,1,0],"radius":2})";
const std::string triangle = R"([[0,-2,2],[2,2,2],[-2,2,2]])";

TEST(Cast, AnswersTheHandoutsScene) {
    // 2 - √2 = 0.5857864376269049512: the shortest decimal that reads back as the nearest double.
    EXPECT_EQ(answer("{" + ray + R"(,"spheres":[)" + sphere + R"(],"triangles":[)" + triangle + "]}\n"),
              R"({"spheres":[{"result":"hit","t":0.585786437626905}],)"
              R"("triangles":[{"result":"hit","t":0,"u":0.25,"v":0.25}],"first":"triangle 0"})"
              "\n");
}

TEST(Cast, TakesKeysInAnyOrderAndWithoutObjects) {
    EXPECT_EQ(answer(R"({"direction":[0,0,-1],"origin":[0,0,2]})"),
              "{\"spheres\":[],\"triangles\":[],\"first\":\"none\"}\n");
}

/// The handout of 2024: the ray meets the tube at (3, 1, 0), where S is (4, 1, 0).
TEST(Cast, AnswersTheHandoutsCylinder) {
    EXPECT_EQ(
        answer(R"({"origin":[4,1,0],"direction":[-1,0,0],"spheres":[{"center":[1,0,1],"radius":2}],)"
               R"("cylinders":[{"center":[2,0,0],"radius":1,"height":4},{"height":1,"center":[2,3,0],"radius":9}],)"
               R"("triangles":[[[3,-1,-1],[3,-1,1],[1,3,0]]]})"),
        R"({"spheres":[{"result":"hit","t":1.5857864376269049}],)"
        R"("triangles":[{"result":"hit","t":2,"u":0.25,"v":0.5}],)"
        R"("cylinders":[{"result":"hit","t":1,"part":"tube"},{"result":"miss"}],"first":"cylinder 0"})"
        "\n");
}

TEST(Cast, NamesEveryResultAndPartOfACylinder) {
    const auto of = [&](const std::string& origin, const std::string& direction, const std::string& radius) {
        const std::string line = answer(R"({"origin":)" + origin + R"(,"direction":)" + direction +
                                        R"(,"cylinders":[{"center":[0,0,0],"radius":)" + radius + R"(,"height":2}]})");
        const std::string before = R"({"spheres":[],"triangles":[],"cylinders":[)";
        EXPECT_EQ(line.substr(0, before.size()), before);
        return line.substr(before.size());
    };
    EXPECT_EQ(of("[0,3,0]", "[0,-1,0]", "1"),
              "{\"result\":\"hit\",\"t\":2,\"part\":\"top\"}],\"first\":\"cylinder 0\"}\n");
    EXPECT_EQ(of("[0,-3,0]", "[0,2,0]", "1"),
              "{\"result\":\"hit\",\"t\":1,\"part\":\"bottom\"}],\"first\":\"cylinder 0\"}\n");
    EXPECT_EQ(of("[1,0,-2]", "[0,0,1]", "1"),
              "{\"result\":\"tangent\",\"t\":2,\"part\":\"tube\"}],\"first\":\"cylinder 0\"}\n");
    EXPECT_EQ(of("[1,3,0]", "[0,-1,0]", "1"), "{\"result\":\"miss\"}],\"first\":\"none\"}\n");
    EXPECT_EQ(of("[1,3,0]", "[0,-1,0]", "0"), "{\"result\":\"invalid\"}],\"first\":\"invalid\"}\n");
    EXPECT_EQ(of("[1,3,0]", "[0,0,0]", "1"), "{\"result\":\"invalid\"}],\"first\":\"invalid\"}\n");
}

TEST(Cast, ForgetsTheObjectsOfThePreviousLine) {
    const std::string none = "{\"spheres\":[],\"triangles\":[],\"first\":\"none\"}\n";
    const std::string full = "{" + ray + R"(,"spheres":[)" + sphere + R"(],"triangles":[)" + triangle +
                             R"(],"cylinders":[{"center":[0,0,0],"radius":1,"height":2}]})" + "\n";
    EXPECT_EQ(answer(full + "{" + ray + "}\n" + full), answer(full) + none + answer(full));
}

TEST(Cast, CountsEveryMalformedLine) {
    std::istringstream in("{\nnonsense\n{" + ray + "}\n[]\n");
    std::ostringstream out;
    EXPECT_EQ(reference::cast::answer_queries(in, out), 3);
}

TEST(Cast, ReadsHexFloatsToTheirLastBit) {
    const std::string query = R"({"origin":["-0x1p-149",0.25,"0x1p+0"],"direction":[0,0,-1],)"
                              R"("triangles":[[[0,0,0],[1,0,0],[0,"0x1.8p-1",0]]]})";
    EXPECT_EQ(answer(query), "{\"spheres\":[],\"triangles\":[{\"result\":\"miss\"}],\"first\":\"none\"}\n");
}

/// From 2^64 on, JSON's whole numbers are no integers of the machine.
TEST(Cast, ReadsWholeNumbersOfAnySize) {
    const auto t_from = [](const std::string& z) {
        return answer(R"({"origin":[0,0,)" + z +
                      R"(],"direction":[0,0,-1],"spheres":[{"center":[0,0,0],"radius":1}]})");
    };
    const auto hit = [](const std::string& t) {
        return R"({"spheres":[{"result":"hit","t":)" + t + R"(}],"triangles":[],"first":"sphere 0"})" + "\n";
    };
    EXPECT_EQ(t_from("18446744073709551616"), hit("1.8446744073709552e+19"));
    EXPECT_EQ(t_from("100000000000000000000000"), hit("1e+23"));
    EXPECT_EQ(t_from("1000000000000000000000000.0"), hit("1e+24"));
    EXPECT_NE(t_from("-9223372036854775809").find("\"miss\""), std::string::npos);
    // A text stays as it is: the key is named with its digits.
    EXPECT_NE(
        answer(R"({"origin":[0,0,99999999999999999999],"\"12345678901234567890":1})").find("12345678901234567890\\\""),
        std::string::npos);
    EXPECT_NE(t_from("00000000000000000000001").find("\"error\""), std::string::npos);
}

TEST(Cast, NamesEveryResult) {
    const auto only_sphere = [&](const std::string& origin, const std::string& direction, const std::string& object) {
        return answer(R"({"origin":)" + origin + R"(,"direction":)" + direction + R"(,"spheres":[)" + object + "]}");
    };
    const std::string unit = R"({"center":[0,0,0],"radius":1})";
    EXPECT_EQ(only_sphere("[1,0,2]", "[0,0,-1]", unit),
              "{\"spheres\":[{\"result\":\"tangent\",\"t\":2}],\"triangles\":[],\"first\":\"sphere 0\"}\n");
    EXPECT_EQ(only_sphere("[1.5,0,2]", "[0,0,-1]", unit),
              "{\"spheres\":[{\"result\":\"miss\"}],\"triangles\":[],\"first\":\"none\"}\n");
    const std::string invalid = "{\"spheres\":[{\"result\":\"invalid\"}],\"triangles\":[],\"first\":\"invalid\"}\n";
    EXPECT_EQ(only_sphere("[0,0,2]", "[0,0,0]", unit), invalid);
    EXPECT_EQ(only_sphere(R"([0,0,"inf"])", "[0,0,-1]", unit), invalid);
    EXPECT_EQ(only_sphere(R"([0,0,"nan"])", "[0,0,-1]", unit), invalid);
    EXPECT_EQ(only_sphere("[0,0,2]", "[0,0,-1]", R"({"center":[0,0,0],"radius":0})"), invalid);
    EXPECT_EQ(answer(R"({"origin":[-5,0,2],"direction":[1,0,0],"triangles":[)" + triangle +
                     R"(,[[0,0,0],[1,1,1],[2,2,2]],[["-inf",0,0],[0,1,0],[1,0,0]]]})"),
              R"({"spheres":[],"triangles":[{"result":"coplanar"},{"result":"degenerate"},{"result":"invalid"}],)"
              R"("first":"invalid"})"
              "\n");
}

TEST(Cast, NumbersTheFirstHitFromZeroAmongItsKind) {
    const std::string far = R"({"center":[0,0,-9],"radius":1})";
    const std::string near = R"({"center":[0,0,0],"radius":1})";
    EXPECT_NE(answer("{" + ray + R"(,"spheres":[)" + far + "," + near + "]}").find("\"first\":\"sphere 1\""),
              std::string::npos);
    EXPECT_NE(answer("{" + ray + R"(,"spheres":[)" + near + "," + far + "," + near + "]}").find("\"first\":\"tie\""),
              std::string::npos);
    // A tie behind the first hit does not count as a tie.
    EXPECT_NE(
        answer("{" + ray + R"(,"spheres":[)" + far + "," + far + "," + near + "]}").find("\"first\":\"sphere 2\""),
        std::string::npos);
}

TEST(Cast, GivesNullForATOutsideTheRangeOfDouble) {
    EXPECT_EQ(answer(R"({"origin":[0,0,1e300],"direction":[0,0,-1e-300],"spheres":[{"center":[0,0,0],"radius":1}]})"),
              "{\"spheres\":[{\"result\":\"hit\",\"t\":null}],\"triangles\":[],\"first\":\"sphere 0\"}\n");
}

TEST(Cast, ReportsAMalformedLineByItsNumberAndAnswersTheRest) {
    const std::string good = "{" + ray + "}";
    for (const std::string& bad : {std::string("{"),
                                   std::string(""),
                                   std::string("[]"),
                                   std::string("nonsense"),
                                   std::string("{}"),
                                   good + "x",
                                   std::string(R"({"origin":[0,0],"direction":[0,0,1]})"),
                                   std::string(R"({"origin":[0,0,0,0],"direction":[0,0,1]})"),
                                   std::string(R"({"origin":[0,0,"1.5"],"direction":[0,0,1]})"),
                                   std::string(R"({"origin":[0,0,"0x"],"direction":[0,0,1]})"),
                                   std::string(R"({"origin":[0,0,"0x-1p0"],"direction":[0,0,1]})"),
                                   std::string(R"({"origin":[0,0,null],"direction":[0,0,1]})"),
                                   std::string(R"({"origin":[0,0,1e999],"direction":[0,0,1]})"),
                                   "{" + ray + "," + ray + "}",
                                   "{" + ray + R"(,"spheres":[],"spheres":[]})",
                                   "{" + ray + R"(,"triangles":[],"triangles":[]})",
                                   "{" + ray + R"(,"cubes":[]})",
                                   "{" + ray + R"(,"spheres":[{"center":[0,0,0]}]})",
                                   "{" + ray + R"(,"spheres":[{"center":[0,0,0],"radius":1,"name":2}]})",
                                   "{" + ray + R"(,"cylinders":[],"cylinders":[]})",
                                   "{" + ray + R"(,"cylinders":[{"center":[0,0,0],"radius":1}]})",
                                   "{" + ray + R"(,"cylinders":[{"center":[0,0,0],"height":1}]})",
                                   "{" + ray + R"(,"cylinders":[{"height":1,"radius":1}]})",
                                   "{" + ray + R"(,"cylinders":[{"center":[0,0,0],"radius":1,"height":1,"up":2}]})",
                                   "{" + ray + R"(,"cylinders":[{"center":[0,0,0],"radius":1,"height":1,"height":1}]})",
                                   "{" + ray + R"(,"cylinders":[[0,0,0]]})",
                                   "{" + ray + R"(,"triangles":[[[0,0,0],[0,0,0]]]})",
                                   "{" + ray + R"(,"spheres":{}})",
                                   std::string("\xff\xfe")}) {
        SCOPED_TRACE(bad);
        std::istringstream in(good + "\n" + bad + "\n" + good + "\n");
        std::ostringstream out;
        EXPECT_EQ(reference::cast::answer_queries(in, out), 1);
        const std::string text = out.str();
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
        const std::size_t second = text.find('\n') + 1;
        EXPECT_EQ(text.substr(second, 10), "{\"error\":\"");
        const std::size_t third = text.find('\n', second) + 1;
        EXPECT_NE(text.find("\"line\":2}"), std::string::npos);
        EXPECT_EQ(text.substr(third), answer(good));
    }
}

}  // namespace
