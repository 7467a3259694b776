#include "harness/shards/part.h"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "harness/gradebook/gradebook.h"
#include "harness/gradebook/record.h"
#include "harness/machine/bounded_file.h"
#include "harness/machine/fingerprint.h"
#include "harness/machine/fresh_file.h"

namespace harness {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string head_line(const PartHead& head) {
    const Json json{{"schema", part_schema},    {"shard", head.shard.number},      {"shards", head.shard.count},
                    {"class", head.class_size}, {"submissions", head.submissions}, {"alike", head.alike}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

[[noreturn]] void refuse_part() {
    throw DamagedFile("is not a part of a class, or is damaged; merge takes the files that grade --shard wrote");
}

std::size_t count_in(const Json& json, const char* name) {
    constexpr std::size_t most = 10'000'000;
    const Json& value = json.at(name);
    if (!value.is_number_unsigned() || value.get<std::size_t>() > most) refuse_part();
    return value.get<std::size_t>();
}

PartHead head_of(std::string_view line) {
    try {
        const Json json = Json::parse(line);
        if (json.at("schema").get<std::string>() != part_schema) refuse_part();
        PartHead head;
        const std::size_t number = count_in(json, "shard"), count = count_in(json, "shards");
        if (number < 1 || number > count || count > Shard::most) refuse_part();
        head.shard = {static_cast<int>(number), static_cast<int>(count)};
        head.class_size = count_in(json, "class");
        head.submissions = count_in(json, "submissions");
        head.alike = json.at("alike");
        for (const auto& [what, value] : head.alike.get_ref<const Json::object_t&>())
            value.get_ref<const std::string&>();
        return head;
    } catch (const Json::exception&) {
        refuse_part();
    }
}

/// The second line of the file.
std::string seal_line(std::string_view head, std::string_view rest) {
    return fmt::format("{} {}", rest.size(), Fingerprint("raygrade/part/1").add(head).add(rest).hex());
}

Json to_json(const Part& part) {
    Json inputs = Json::array(), submissions = Json::array();
    for (const KeptInput& kept_input : part.inputs)
        inputs.push_back({kept_input.name, kept_input.choice, kept_input.content});
    for (const IndexedGraded& indexed_graded : part.graded) {
        submissions.push_back({indexed_graded.index, Json::binary(to_record(indexed_graded.graded)),
                               indexed_graded.graded.execution.printout, indexed_graded.graded.submission.source});
    }
    return {{"assignment", {part.file.path.string(), part.file.toml}},
            {"sandbox", to_string(part.tier)},
            {"inputs", std::move(inputs)},
            {"submissions", std::move(submissions)}};
}

IndexedGraded graded_in(const Json& json, std::size_t class_size) {
    IndexedGraded indexed_graded;
    indexed_graded.index = json.at(0).get<std::size_t>();
    auto graded = from_record(json.at(1).get_binary());
    if (!graded || indexed_graded.index >= class_size) refuse_part();
    indexed_graded.graded = std::move(*graded);
    indexed_graded.graded.execution.printout = json.at(2).get<std::string>();
    indexed_graded.graded.submission.source = json.at(3).get<std::string>();
    return indexed_graded;
}

void read_rest(std::string_view rest, Part& part) {
    try {
        const Json json = Json::from_cbor(rest);
        part.file = {json.at("assignment").at(0).get<std::string>(), json.at("assignment").at(1).get<std::string>()};
        for (const Tier tier : {Tier::bwrap, Tier::landlock, Tier::unsafe}) {
            if (to_string(tier) == json.at("sandbox").get<std::string>()) part.tier = tier;
        }
        for (const Json& entry : json.at("inputs"))
            part.inputs.push_back(
                {entry.at(0).get<std::string>(), entry.at(1).get<std::string>(), entry.at(2).get<std::string>()});
        for (const Json& each : json.at("submissions")) part.graded.push_back(graded_in(each, part.head.class_size));
    } catch (const Json::exception&) {
        refuse_part();
    }
}

std::string read_file(const fs::path& file, std::uintmax_t most) {
    BoundedFile read = read_bounded(file, most, Links::follow);
    if (read.error == ENOENT) throw DamagedFile("does not exist; check the name");
    if (read.is_special && fs::exists(file / gradebook_name))
        throw DamagedFile("is a results folder; merge takes the .part files that grade --shard wrote");
    if (read.error != 0 || read.is_special)
        throw DamagedFile("cannot be read: " + why_not_whole(read, most) + "; name the files that grade --shard wrote");
    return std::move(read.bytes);
}

/// Removes the first line from the text and returns it.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) throw DamagedFile("is incomplete");
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    return line;
}

}  // namespace

void write_part(const Part& part, const fs::path& file) {
    write_file(file, [&](std::ostream& stream) {
        const std::string head = head_line(part.head);
        std::string rest;
        Json::to_cbor(to_json(part), rest);
        stream << head << '\n' << seal_line(head, rest) << '\n' << rest;
    });
}

PartHead read_part_head(const fs::path& file) {
    constexpr std::uintmax_t longest_head = std::uintmax_t{1} << 20U;
    const std::string bytes = read_file(file, longest_head);
    std::string_view text = bytes;
    return head_of(take_line(text));
}

Part read_part(const fs::path& file) {
    const std::string bytes = read_file(file, std::numeric_limits<std::uint32_t>::max());
    std::string_view rest = bytes;
    const std::string_view head = take_line(rest), seal = take_line(rest);
    std::size_t size = 0;
    std::from_chars(seal.data(), seal.data() + seal.size(), size);
    if (size > rest.size()) throw DamagedFile("is incomplete");
    if (seal != seal_line(head, rest)) throw DamagedFile("is damaged");
    Part part;
    part.head = head_of(head);
    read_rest(rest, part);
    if (part.graded.size() != part.head.submissions) refuse_part();
    return part;
}

}  // namespace harness
