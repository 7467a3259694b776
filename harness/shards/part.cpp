#include "harness/shards/part.h"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "harness/gradebook/record.h"
#include "harness/machine/fresh_file.h"

namespace harness {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string head_line(const PartHead& head) {
    const Json json{{"schema", part_schema},    {"shard", head.shard.number},      {"shards", head.shard.count},
                    {"class", head.class_size}, {"submissions", head.submissions}, {"alike", to_json(head.alike)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

[[noreturn]] void refuse_part() {
    throw DamagedFile("is no part of a class, or damaged");
}

std::size_t count_in(const Json& json, const char* name) {
    constexpr std::size_t most = 10'000'000;
    const Json& value = json.at(name);
    if (!value.is_number_unsigned() || value.get<std::size_t>() > most) refuse_part();
    return value.get<std::size_t>();
}

PartHead head_of(const std::string& line) {
    try {
        const Json json = Json::parse(line);
        if (json.at("schema").get<std::string>() != part_schema) refuse_part();
        PartHead head;
        const std::size_t number = count_in(json, "shard"), count = count_in(json, "shards");
        if (number < 1 || number > count || count > Shard::most) refuse_part();
        head.shard = {static_cast<int>(number), static_cast<int>(count)};
        head.class_size = count_in(json, "class");
        head.submissions = count_in(json, "submissions");
        head.alike = conditions_in(json.at("alike"));
        return head;
    } catch (const Json::exception&) {
        refuse_part();
    }
}

std::string text_of(const std::vector<std::uint8_t>& record) {
    return {record.begin(), record.end()};
}

Frame frame_of(const IndexedGraded& one) {
    const Submission& submission = one.graded.submission;
    return {
        "submission",
        {std::to_string(one.index), text_of(to_record(one.graded)), one.graded.execution.printout, submission.source}};
}

IndexedGraded graded_in(Frame frame, std::size_t class_size) {
    IndexedGraded one;
    constexpr std::size_t texts = 4, longest_number = 8;
    if (frame.texts.size() != texts || frame.texts[0].empty() || frame.texts[0].size() > longest_number ||
        frame.texts[0].find_first_not_of("0123456789") != std::string::npos) {
        refuse_part();
    }
    one.index = std::stoul(frame.texts[0]);
    auto graded = from_record({frame.texts[1].begin(), frame.texts[1].end()});
    if (!graded || one.index >= class_size || frame.texts[2].size() > longest_kept_printout ||
        frame.texts[3].size() > longest_kept_source) {
        refuse_part();
    }
    one.graded = std::move(*graded);
    one.graded.execution.printout = std::move(frame.texts[2]);
    one.graded.submission.source = std::move(frame.texts[3]);
    return one;
}

void add(Part& part, Frame frame) {
    constexpr std::size_t texts_of_assignment = 3, texts_of_input = 3;
    if (frame.word == "submission") {
        part.graded.push_back(graded_in(std::move(frame), part.head.class_size));
    } else if (frame.word == "assignment" && frame.texts.size() == texts_of_assignment) {
        part.file = {frame.texts[0], frame.texts[1]};
        for (const Tier tier : {Tier::bwrap, Tier::landlock, Tier::unsafe}) {
            if (to_string(tier) == frame.texts[2]) part.tier = tier;
        }
    } else if (frame.word == "input" && frame.texts.size() == texts_of_input) {
        part.inputs.push_back({frame.texts[0], frame.texts[1], frame.texts[2]});
    } else {
        refuse_part();
    }
}

/// A part that is opened; the reader refers to the stream.
struct OpenPart {
    explicit OpenPart(const fs::path& file)
        : size(size_of(file)), stream(file, std::ios::binary), reader(stream, size) {}

    /// Looks before anything is opened, because opening a pipe would wait for its writer.
    static std::uintmax_t size_of(const fs::path& file) {
        std::error_code error;
        if (!fs::exists(file, error)) throw DamagedFile("is not there");
        const std::uintmax_t bytes = fs::file_size(file, error);
        if (error) throw DamagedFile("is no file that can be read");
        return bytes;
    }

    std::uintmax_t size;
    std::ifstream stream;
    FrameReader reader;
};

}  // namespace

void write_part(const Part& part, const fs::path& file) {
    write_file(file, [&](std::ostream& stream) {
        FrameWriter writer(stream, head_line(part.head));
        writer.write({"assignment", {part.file.path.string(), part.file.toml, std::string(to_string(part.tier))}});
        for (const KeptInput& each : part.inputs) writer.write({"input", {each.name, each.choice, each.content}});
        for (const IndexedGraded& each : part.graded) writer.write(frame_of(each));
        writer.write({"end", {}});
    });
}

PartHead read_part_head(const fs::path& file) {
    return head_of(OpenPart(file).reader.head());
}

Part read_part(const fs::path& file) {
    OpenPart open(file);
    Part part;
    part.head = head_of(open.reader.head());
    for (Frame frame = open.reader.next(); frame.word != "end"; frame = open.reader.next()) add(part, std::move(frame));
    if (!open.reader.is_at_end() || part.graded.size() != part.head.submissions) refuse_part();
    return part;
}

}  // namespace harness
