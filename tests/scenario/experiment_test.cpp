// The real raygrade on programs whose answers it can't find by their words, so that it runs them on two other scenes.
// Each is tests/given/experiment/ray_cast.cpp with other lines. They gain no answer by that which they do not name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

using Edits = std::vector<std::pair<std::string, std::string>>;

std::string program(const Edits& edits) {
    std::string source = read(project_folder() / "tests/given/experiment/ray_cast.cpp");
    for (const auto& [from, to] : edits) {
        const std::size_t at = source.find(from);
        if (at == std::string::npos) throw std::runtime_error("not in the program: " + from);
        source.replace(at, from.size(), to);
    }
    return source;
}

struct Item {
    double points = 0;
    std::string verdict;
    bool is_doubtful = false;
    std::string note;  ///< of the experiment

    bool is_given() const { return points > 0 && !is_doubtful; }
    bool operator==(const Item&) const = default;
};

using Items = std::map<std::string, Item>;  ///< by "question.item"

Items items_of(const json& submission) {
    Items items;
    for (const json& question : submission.at("questions")) {
        for (const json& item : question.at("items")) {
            const json reading = item.at("reading").is_null() ? json::object() : item.at("reading");
            items[question.at("number").dump() + "." + item.at("name").get<std::string>()] = {
                item.at("points"), item.at("verdict"), reading.contains("doubt"), reading.value("experiment", "")};
        }
    }
    return items;
}

/// A class of such programs, by name.
class Programs {
  public:
    explicit Programs(const std::map<std::string, Edits>& all) {
        write(assignment(), read(project_folder() / "tests/given/labelled/offaxis/assignment.toml"));
        for (const auto& [name, edits] : all) write(folder / "class" / name / "ray_cast.cpp", program(edits));
    }

    fs::path assignment() const { return folder / "assignment.toml"; }

    std::map<std::string, Items> grade(const std::vector<std::string>& more = {},
                                       const Preparation& prepare = {}) const {
        const fs::path out = folder / ("out" + std::to_string(++runs));
        std::vector<std::string> words{
            "grade",   (folder / "class").string(), "--assignment", assignment().string(), "--out", out.string(),
            "--limit", "run.cpu_seconds=1"};
        words.insert(words.end(), more.begin(), more.end());
        const Result result = raygrade(words, prepare);
        EXPECT_EQ(result.status, 0) << result.both();
        std::map<std::string, Items> graded;
        const json grades = read_json(out / "grades.json");
        for (const json& submission : grades.at("submissions")) graded[submission.at("id")] = items_of(submission);
        return graded;
    }

    TemporaryFolder folder;

  private:
    mutable int runs = 0;
};

const std::string t = "number(\"t\", t);", u_and_v = R"(number("u", u), number("v", v))";
const std::string question_6 = R"(number("a", a), number("b", b), number("c", c), number("d", d);)";
const std::string verdict = R"(sphere_is_first ? "ray hits sphere first" : "ray hits triangle first")";
const std::string matrix_rows = "row(K[0][r], K[1][r], K[2][r])";
const std::string begin = "question(1);";

/// Tells whether it runs in the copy, which reads its scene from stdin.
const std::string is_copy = "#include <unistd.h>\nbool is_copy() { return lseek(0, 0, SEEK_CUR) > 0; }\nint main() {";

/// A thousand numbers that change with the scene. Those of question 8 are among them.
const std::string sums_and_products =
    "const double all[] = {s, u, v, t, b, c, d, S.x, S.y, S.z, V.x, V.y, V.z, eye.x, eye.y, eye.z, A.x, B.x, C.x, 1};\n"
    R"(for (double x : all) for (double y : all) std::printf("%f\n%f\n", x * y, x + y);)";

struct Attack {
    std::string name;
    std::set<std::string> not_given;  ///< items that the printout says wrong or not at all
    Edits edits;
};

/// In this layout the words leave a doubt.
const std::pair<std::string, std::string> name_behind = {t, R"(std::printf("%f 2 t\n", t);)"};

/// All other items are right, in a layout whose doubts the experiment settles.
const std::vector<Attack> attacks = {
    {"right", {}, {}},
    {"name behind", {}, {name_behind}},
    {"right without headings", {}, {{R"(std::printf("Question %d:\n", number);)", "(void)number;"}}},
    {"debug line with words", {"6.t"}, {{t, R"(number("t", wrong), std::printf("debug: t = %f\n", t);)"}}},
    {"debug line without words", {"6.t"}, {{t, R"(number("t", wrong), std::printf("%f\n", t);)"}}},
    {"debug line before all", {"6.t"}, {{begin, R"(std::printf("%f\n", t);)" + begin}, {t, "number(\"t\", wrong);"}}},
    {"every number", {"6.t"}, {{t, R"(for (int i = 0; i < 3000; ++i) std::printf("%.3f\n", i * 0.004);)"}}},
    {"all that the scene gives", {"8.t", "8.u", "8.v"}, {{"number(\"t\", s), " + u_and_v + ";", sums_and_products}}},
    {"a copy that lies", {"6.t"}, {{"int main() {", is_copy}, {t, R"(number("t", is_copy() ? t : wrong);)"}}},
    {"other scenes are lies",
     {"6.t"},
     {{t, R"(number("t", is_own_scene ? wrong : t), number("q", is_own_scene ? t : wrong);)"}}},
    {"one of three", {"6.t"}, {{t, R"(std::printf("t could be %f, %f or %f\n", wrong, t, 2 * t);)"}}},
    {"one or the other", {"6.t"}, {{t, R"(std::printf("t ==> %f or %f\n", wrong, t);)"}}},
    {"one under the other", {"6.t"}, {{t, R"(number("t", wrong), number("t", t), number("t", 2 * t);)"}}},
    {"u and v exchanged", {"8.u", "8.v"}, {{u_and_v, R"(number("u", v), number("v", u))"}}},
    {"columns called row", {"8.matrix"}, {{matrix_rows, R"(std::printf("row %d", r + 1), vec("", K[r]))"}}},
    {"columns called r", {"8.matrix"}, {{matrix_rows, R"(std::printf("r%d", r + 1), vec("", K[r]))"}}},
    {"verdict inverted", {"10.verdict"}, {{verdict, "!" + verdict}}},
    {"verdict inverted in other words",
     {"10.verdict"},
     {{verdict, R"(sphere_is_first ? "q ==> plip" : "q ==> plop")"}}},
    {"right at the second attempt", {"6.t"}, {{t, "number(\"t\", wrong); question(6); " + question_6 + t}}},
    {"only in question 10", {"6.t"}, {{t, ""}, {"question(10);", R"(question(10), std::printf("%f < %f\n", s, t);)"}}},
};

TEST(Experiment, FindsNamedAnswersAndNothingElse) {
    std::map<std::string, Edits> all;
    for (const Attack& attack : attacks) all[attack.name] = attack.edits;
    const Programs programs(all);
    const auto graded = programs.grade(), as_read = programs.grade({"--no-experiments"});
    for (const Attack& attack : attacks) {
        for (const auto& [name, item] : graded.at(attack.name)) {
            const Item& read = as_read.at(attack.name).at(name);
            SCOPED_TRACE(attack.name + ": " + name + " is " + item.verdict + ". " + item.note);
            EXPECT_EQ(item.is_given(), !attack.not_given.contains(name));
            EXPECT_GE(item.points, read.points);
        }
    }
    EXPECT_EQ(graded.at("name behind").at("6.t").note,
              "Line 21 was read as t because it changes as t does on 2 other scenes.");
    EXPECT_TRUE(as_read.at("name behind").at("6.t").is_doubtful);
}

const std::string far_t = "(-b + std::sqrt(d)) / (2 * a)", vec_V = "vec(\"V\", V);", number_b = "number(\"b\", b)",
                  sphere_N = "vec(\"N\", glm::normalize(hit - center));";

/// Each prints a right number beside the answer that it says, which is wrong.
const std::vector<Attack> right_beside_wrong = {
    {"the far root is chosen",
     {"6.t"},
     {{t, R"(std::printf("t_near = %f\nt_far = %f\nWe choose t = %f\n", t, )" + far_t + ", " + far_t + ");"}}},
    {"the far root is taken",
     {"6.t"},
     {{t, R"(std::printf("t1 = %f, t2 = %f, so we take %f\n", t, )" + far_t + ", " + far_t + ");"}}},
    {"the far root by its name",
     {"6.t"},
     {{t, R"(std::printf("t1 = %f\nt2 = %f\nlarger root: t2\nt = t2\n", t, )" + far_t + ");"}}},
    {"the far root in words",
     {"6.t"},
     {{t, R"(std::printf("t1 = %f\nt2 = %f\nusing the larger root\n", t, )" + far_t + ");"}}},
    {"b and -b", {"6.b"}, {{number_b, R"(std::printf("b = %f, -b = %f\n", -b, b))"}}},
    {"-b alone", {"6.b"}, {{number_b, R"(std::printf("-b = %f\n", b))"}}},
    {"V and -V", {"5.V"}, {{vec_V, R"(vec("V", -V), vec("-V", V);)"}}},
    {"V negated", {"5.V"}, {{vec_V, R"(std::printf("V = -vec3(%f, %f, %f)\n", V.x, V.y, V.z);)"}}},
    {"V doubled", {"5.V"}, {{vec_V, R"(std::printf("V = 2 * vec3(%f, %f, %f)\n", V.x, V.y, V.z);)"}}},
    {"Z and -Z", {"2.Z_vcs"}, {{R"(vec("Z", Z))", R"(vec("Z", -Z), vec("-Z", Z))"}}},
    {"t and its size", {"8.t"}, {{R"(number("t", s))", R"(std::printf("t = %f\n|t| = %f\n", -s, s))"}}},
    {"another pixel", {"5.V"}, {{vec_V, R"(vec("V", -V), std::puts("Another pixel"), question(5), vec("V", V);)"}}},
    {"what is expected",
     {"5.V"},
     {{vec_V, "vec(\"V\", -V);"},
      {begin, R"(std::puts("Expected output:"), question(5), vec("V", V), std::puts("My output:"); )" + begin}}},
    {"what is expected on one line",
     {"8.t"},
     {{R"(number("t", s))", R"(std::printf("t = %f\nexpected: t = %f\n", wrong, s))"}}},
};

TEST(Experiment, DoesNotTakeARightNumberThatIsNotTheAnswer) {
    std::map<std::string, Edits> all;
    for (const Attack& attack : right_beside_wrong) all[attack.name] = attack.edits;
    const auto graded = Programs(all).grade();
    for (const Attack& attack : right_beside_wrong) {
        for (const std::string& name : attack.not_given)
            EXPECT_FALSE(graded.at(attack.name).at(name).is_given()) << attack.name;
    }
}

/// The program on a scene whose numbers are all computed, so that they are not found.
std::string with_hidden_scene() {
    const std::string source = program({name_behind});
    const std::size_t from = source.find("const dvec3 eye"), to = source.find("void question");
    const std::regex number(R"(-?\b\d+(\.\d+)?\b)");
    return source.substr(0, from) +
           std::regex_replace(source.substr(from, to - from), number, "std::strtod(\"$&\", nullptr)") +
           source.substr(to);
}

/// A program that states the scene and prints right answers without using it.
std::string with_constants() {
    const std::string source = program({});
    return source.substr(0, source.find("void question")) +
           "int main() { std::puts(\"Question 5:\\nV ==> 0.314749 | -0.370716 | -0.873786\\n"
           "Question 6:\\nb ==> -22.745409\\n9.737209 2 t\"); }\n";
}

TEST(Experiment, ChangesNothingWhereOtherScenesShowNothing) {
    const auto elsewhere = [](const std::string& what) {
        return Edits{{begin, "if (!is_own_scene) " + what + "; " + begin}, name_behind};
    };
    const Programs programs({
        {"crashes", elsewhere("std::abort()")},
        {"does not end", elsewhere("for (volatile int i = 0;;) i = i + 1")},
        {"exits with another code", elsewhere("std::exit(3)")},
        {"takes another branch", elsewhere("return std::puts(\"Question 6:\\nno hit\"), 0")},
        {"prints nothing", elsewhere("return 0")},
        {"prints without end", elsewhere("for (;;) std::puts(\"1.5\")")},
        {"debugs", {{begin, "for (int i = 0; i < 1500; ++i) row(t * i, u, v * i); " + begin}, name_behind}},
    });
    write(programs.folder / "class/hides its scene/ray_cast.cpp", with_hidden_scene());
    write(programs.folder / "class/prints constants/ray_cast.cpp", with_constants());
    const auto graded = programs.grade(), as_read = programs.grade({"--no-experiments"});
    for (const auto& [name, items] : graded) {
        EXPECT_TRUE(items == as_read.at(name)) << name;
        EXPECT_TRUE(items.at("6.t").is_doubtful) << name;
    }
}

/// The stages of `raygrade grade --trace`, such as "right (any scene) run".
std::set<std::string> traced(const Programs& programs, const std::vector<std::string>& more) {
    const fs::path file = programs.folder / "trace.json";
    std::vector<std::string> words{"--fresh", "--trace", file.string()};
    words.insert(words.end(), more.begin(), more.end());
    programs.grade(words);
    std::set<std::string> stages;
    const json trace = read_json(file);
    for (const json& event : trace.at("traceEvents"))
        stages.insert(event.at("args").at("of").get<std::string>() + " " + event.at("name").get<std::string>());
    return stages;
}

TEST(Experiment, CopiesAreInTheTraceAndNotCompiledWithNoExperiments) {
    const Programs programs({{"right", {name_behind}},
                             {"endless", {name_behind, {"question(10);", "for (volatile int i = 0;;) i = i + 1;"}}}});
    const std::set<std::string> stages = traced(programs, {});
    EXPECT_THAT(stages, IsSupersetOf({"right run", "right (any scene) build", "right (any scene) run"}));
    EXPECT_THAT(stages, Not(Contains(HasSubstr("endless ("))));
    EXPECT_THAT(traced(programs, {"--no-experiments"}), Not(Contains(HasSubstr("right ("))));
}

TEST(Experiment, DependsNeitherOnJobsNorOnTheCache) {
    std::map<std::string, Edits> all;
    for (const char* name : {"right", "u and v exchanged", "one of three", "every number"})
        all[name] = std::ranges::find(attacks, std::string(name), &Attack::name)->edits;
    const Programs programs(all);
    const Preparation cache = with_cache(programs.folder / "cache");
    const auto one = programs.grade({"--jobs", "1"}, cache);
    EXPECT_EQ(one, programs.grade({"--jobs", "1"}, cache)) << "from the cache";
    EXPECT_EQ(one, programs.grade({"--jobs", "4", "--fresh"}, cache));
}

TEST(Experiment, RunsOnTheSceneThatWasDealt) {
    const Programs programs({{"ada",
                              {{"pixel_x = 411, pixel_y = 129", "pixel_x = 376, pixel_y = 105"},
                               {"center(6.6, -1.4, 0.5)", "center(5.6, -1.4, 0.5)"}}},
                             {"ben", {}}});
    write(programs.assignment(), read(programs.assignment()) +
                                     "\n[[student]]\nid = \"ada\"\nwindow.pixel = [376, 105]\n"
                                     "sphere.center = [5.6, -1.4, 0.5]\n"
                                     "[[student]]\nid = \"ben\"\nwindow.pixel = [407, 126]\n");
    const auto graded = programs.grade();
    for (const auto& [name, item] : graded.at("ada")) EXPECT_TRUE(item.is_given()) << name;
    EXPECT_NE(graded.at("ben").at("1.P_VCS").verdict, "right") << "the assignment's scene is not Ben's";
}

}  // namespace
}  // namespace scenario
