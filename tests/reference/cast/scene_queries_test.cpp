// Both forms of rays at a scene: their answers' bytes, what is malformed, and any number of threads.
#include "reference/cast/scene_queries.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reference/accuracy/rays/random_numbers.h"
#include "tests/given/render/scenes.h"
#include "tests/given/temporary_folder.h"

namespace {

using namespace reference;
using accuracy::P;
using accuracy::Random;
using cast::answer_lines;
using cast::answer_records;
using kernel::Ray;
using testing::ElementsAre;
using testing::HasSubstr;

/// One object of each kind side by side in the plane z = 0, 10 apart, and a mesh of two faces that share an edge.
render::PreparedScene scene_of_all() {
    const TemporaryFolder folder;
    folder.write("square.obj", "v 30 0 0\nv 31 0 0\nv 31 1 0\nv 30 1 0\nf 1 2 3\nf 1 3 4\n");
    return cast::objects_of(load_scene(folder.write(
        "scene.toml",
        scenes::with_camera(scenes::sphere("[0, 0, 0]", "1") + scenes::sphere("[5, 0, 0]", "1") +
                            scenes::triangle("[[10, 0, 0], [12, 0, 0], [10, 2, 0]]") +
                            scenes::cylinder("[20, 0, 0]", "1", "4") + "[[mesh]]\nfile = \"square.obj\"\n"))));
}

std::string line_of(const Ray<double>& ray) {
    const auto number = [](double x) {
        return std::isfinite(x) ? fmt::to_string(x)
                                : fmt::format("\"{}\"", std::isnan(x) ? "nan"
                                                        : x > 0       ? "inf"
                                                                      : "-inf");
    };
    const auto point = [&](const P& p) { return fmt::format("[{},{},{}]", number(p.x), number(p.y), number(p.z)); };
    return fmt::format("{{\"origin\":{},\"direction\":{}}}\n", point(ray.origin), point(ray.direction));
}

std::string record_of(const Ray<double>& ray) {
    std::string record;
    for (const P& p : {ray.origin, ray.direction}) {
        for (const double x : {p.x, p.y, p.z}) {
            const auto bits = std::bit_cast<std::uint64_t>(x);
            for (unsigned shift = 0; shift < 64; shift += 8) record.push_back(static_cast<char>(bits >> shift & 0xffU));
        }
    }
    return record;
}

std::string in_lines(const render::PreparedScene& scene, const std::vector<Ray<double>>& rays, int jobs = 1) {
    std::string text;
    for (const auto& ray : rays) text += line_of(ray);
    std::istringstream in(text);
    std::ostringstream out;
    EXPECT_EQ(answer_lines(scene, in, out, jobs), 0);
    return out.str();
}

std::string in_records(const render::PreparedScene& scene, const std::vector<Ray<double>>& rays, int jobs = 1) {
    std::string bytes;
    for (const auto& ray : rays) bytes += record_of(ray);
    std::istringstream in(bytes);
    std::ostringstream out;
    const cast::RecordsRead read = answer_records(scene, in, out, jobs);
    EXPECT_EQ(read.whole, rays.size());
    EXPECT_EQ(read.left_over, 0U);
    return out.str();
}

std::uint64_t whole_at(std::string_view bytes, std::size_t from, std::size_t count) {
    std::uint64_t x = 0;
    for (std::size_t i = count; i-- > 0;) x = x << 8U | static_cast<unsigned char>(bytes.at(from + i));
    return x;
}

/// What an answer in a record would be in a line.
nlohmann::json json_of(std::string_view record) {
    const std::array kinds{"none", "sphere", "triangle", "mesh", "cylinder", "invalid"};
    const std::array parts{"tube", "top", "bottom"};
    const std::string kind = kinds.at(whole_at(record, 0, 4));
    if (kind == "none" || kind == "invalid") return {{"first", kind}};
    nlohmann::json json{{"first", fmt::format("{} {}", kind, whole_at(record, 4, 4))}};
    const auto number = [&](std::size_t from) { return std::bit_cast<double>(whole_at(record, from, 8)); };
    if (std::isfinite(number(16))) {
        json["t"] = number(16);
    } else {
        json["t"] = nullptr;
    }
    if (kind == "mesh") json["face"] = whole_at(record, 8, 4);
    if (kind == "cylinder") json["part"] = parts.at(whole_at(record, 12, 1));
    if (whole_at(record, 13, 1) == 1) json["tie"] = true;
    if (kind == "mesh" || kind == "triangle") std::tie(json["u"], json["v"]) = std::pair(number(24), number(32));
    return json;
}

std::vector<Ray<double>> rays_at_all(int count) {
    Random random(1);
    std::vector<Ray<double>> rays;
    for (int i = 0; i < count; ++i) {
        const P at(5 * random.whole(0, 6), 0, 0);
        rays.push_back({at + random.point(2) + P(0, 0, 3), random.direction() - P(0, 0, 1)});
        // Often along an edge or a seam.
        rays.push_back({at + random.whole_point(1), random.whole_point(1)});
    }
    rays.push_back({P(0, 0, 1e300), P(0, 0, -1e-300)});
    rays.push_back({P(0, 0, 2), P(0, std::nan(""), -1)});
    rays.push_back({P(0, 0, -HUGE_VAL), P(0, 0, -1)});
    return rays;
}

TEST(SceneQueries, NameWhatIsHit) {
    const render::PreparedScene scene = scene_of_all();
    const auto down_at = [&](double x, double y) { return in_lines(scene, {{P(x, y, 2), P(0, 0, -0.5)}}); };
    EXPECT_EQ(down_at(0, 0), "{\"first\":\"sphere 0\",\"t\":2}\n");
    EXPECT_EQ(down_at(6, 0), "{\"first\":\"sphere 1\",\"t\":4}\n");
    EXPECT_EQ(down_at(10.5, 1), "{\"first\":\"triangle 0\",\"t\":4,\"u\":0.25,\"v\":0.5}\n");
    EXPECT_EQ(down_at(20, 0), "{\"first\":\"cylinder 0\",\"t\":2,\"part\":\"tube\"}\n");
    EXPECT_EQ(down_at(30.25, 0.75), "{\"first\":\"mesh 0\",\"face\":1,\"t\":4,\"u\":0.25,\"v\":0.5}\n");
    EXPECT_EQ(down_at(30.5, 0.5), "{\"first\":\"mesh 0\",\"face\":0,\"tie\":true,\"t\":4,\"u\":0,\"v\":0.5}\n");
    EXPECT_EQ(down_at(40, 0), "{\"first\":\"none\"}\n");
    EXPECT_EQ(in_lines(scene, {{P(20, 5, 0), P(0, -1, 0)}}), "{\"first\":\"cylinder 0\",\"t\":3,\"part\":\"top\"}\n");
    EXPECT_EQ(in_lines(scene, {{P(20, -5, 0), P(0, 1, 0)}}),
              "{\"first\":\"cylinder 0\",\"t\":3,\"part\":\"bottom\"}\n");
    EXPECT_EQ(in_lines(scene, {{P(0, 0, 2), P(0, 0, 0)}}), "{\"first\":\"invalid\"}\n");
    EXPECT_EQ(in_lines(scene, {{P(0, 0, 1e300), P(0, 0, -1e-300)}}), "{\"first\":\"sphere 0\",\"t\":null}\n");
}

TEST(SceneQueries, AnswerInRecordsOfFixedLayout) {
    const render::PreparedScene scene = scene_of_all();
    const std::string seam = in_records(scene, {{P(30.5, 0.5, 2), P(0, 0, -0.5)}});
    EXPECT_EQ(seam, std::string("\3\0\0\0\0\0\0\0\0\0\0\0\0\1\0\0"
                                "\0\0\0\0\0\0\x10\x40\0\0\0\0\0\0\0\0\0\0\0\0\0\0\xe0\x3f",
                                40));
    const std::string top = in_records(scene, {{P(20, 5, 0), P(0, -1, 0)}});
    EXPECT_EQ(top, std::string("\4\0\0\0\0\0\0\0\0\0\0\0\1\0\0\0"
                               "\0\0\0\0\0\0\x08\x40\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
                               40));
    EXPECT_EQ(in_records(scene, {{P(0, 0, std::nan("")), P(0, 0, 1)}}), "\5" + std::string(39, '\0'));
    EXPECT_EQ(in_records(scene, {{P(40, 0, 1), P(0, 0, 1)}}), std::string(40, '\0'));
}

TEST(SceneQueries, AreTheSameInBothFormsToTheLastBit) {
    const render::PreparedScene scene = scene_of_all();
    const std::vector<Ray<double>> rays = rays_at_all(2000);
    const std::string records = in_records(scene, rays);
    std::istringstream lines(in_lines(scene, rays));
    std::size_t place = 0;
    std::map<std::string, int> kinds;
    for (std::string line; std::getline(lines, line); place += cast::answer_bytes) {
        const nlohmann::json json = nlohmann::json::parse(line);
        ASSERT_EQ(json, json_of(std::string_view(records).substr(place, cast::answer_bytes))) << line;
        ++kinds[json.at("first")];
    }
    EXPECT_EQ(place, records.size());
    EXPECT_EQ(kinds.size(), 7U) << "each kind is hit";
}

TEST(SceneQueries, HaveTheSameAnswersForAnyNumberOfThreads) {
    const render::PreparedScene scene = scene_of_all();
    const std::vector<Ray<double>> rays = rays_at_all(20'000);
    const std::string lines = in_lines(scene, rays);
    const std::string records = in_records(scene, rays);
    for (const int jobs : {2, 3, 16}) {
        EXPECT_TRUE(in_lines(scene, rays, jobs) == lines) << jobs;
        EXPECT_TRUE(in_records(scene, rays, jobs) == records) << jobs;
    }
}

TEST(SceneQueries, ReportAMalformedLineByItsNumberAndAnswerTheRest) {
    const render::PreparedScene scene = scene_of_all();
    const std::string good = line_of({P(0, 0, 2), P(0, 0, -1)});
    const std::string answer = "{\"first\":\"sphere 0\",\"t\":1}\n";
    for (const auto& [bad, why] : std::vector<std::pair<std::string, std::string>>{
             {"", "no JSON found"},
             {"{}", "a query must have an origin and a direction"},
             {R"({"origin":[0,0,2],"direction":[0,0]})", "direction must have three numbers"},
             {R"({"origin":[0,0,1e999],"direction":[0,0,1]})", ""},
             {R"({"origin":[0,0,2],"direction":[0,0,1],"spheres":[]})", "the objects are the scene's"},
             {R"({"origin":[0,0,2],"direction":[0,0,1],"triangles":[[[0,0,0],[1,0,0],[0,1,0]]]})",
              "the objects are the scene's"},
             {R"({"origin":[0,0,2],"direction":[0,0,1],"range":[0,1]})", "is not a key"},
             {std::string(1000, '['), ""},
             {"\xff\xfe", ""},
             {std::string(1, '\0'), ""}}) {
        std::istringstream in(good + bad + "\n" + good + bad);
        std::ostringstream out;
        EXPECT_EQ(answer_lines(scene, in, out, 2), bad.empty() ? 1 : 2) << bad;
        std::istringstream lines(out.str());
        std::string first, second, third;
        std::getline(lines, first);
        std::getline(lines, second);
        std::getline(lines, third);
        EXPECT_EQ(first + "\n", answer);
        EXPECT_THAT(second, HasSubstr(why));
        EXPECT_EQ(nlohmann::json::parse(second).at("line"), 2);
        EXPECT_EQ(third + "\n", answer);
    }
}

TEST(SceneQueries, TellWhatIsLeftOfARecordThatIsCutOff) {
    const render::PreparedScene scene = scene_of_all();
    const std::string record = record_of({P(0, 0, 2), P(0, 0, -1)});
    for (const std::size_t whole : {0U, 1U, 6000U}) {
        for (const std::size_t more : {1U, 47U}) {
            std::string bytes;
            for (std::size_t i = 0; i < whole; ++i) bytes += record;
            std::istringstream in(bytes + record.substr(0, more));
            std::ostringstream out;
            const cast::RecordsRead read = answer_records(scene, in, out, 3);
            EXPECT_EQ(read.whole, whole);
            EXPECT_EQ(read.left_over, more);
            EXPECT_EQ(out.str().size(), whole * cast::answer_bytes);
        }
    }
}

}  // namespace
