#include "harness/gradebook/record.h"

#include <algorithm>
#include <concepts>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tuple>

#include "harness/record/hard_scenes_json.h"
#include "reference/stages/decisions.h"

// Each struct names its fields once, in `fields` (a map from names) or in `row` (an array). A Writer and a Reader use
// the same list. Names and the order of a row never change; a new field of a row is added at its end.

namespace harness {
namespace {

using nlohmann::json;

std::string_view to_string(Ended ended) {
    return word_for(ended);
}
std::string_view to_string(Lms system) {
    switch (system) {
        case Lms::canvas: return "canvas";
        case Lms::moodle: return "moodle";
        case Lms::gradescope: return "gradescope";
        case Lms::brightspace: return "brightspace";
        case Lms::blackboard: return "blackboard";
    }
    return "";
}

std::string_view to_string(MatrixOrder order) {
    switch (order) {
        case MatrixOrder::unsaid: return "unsaid";
        case MatrixOrder::rows: return "rows";
        case MatrixOrder::columns: return "columns";
    }
    return "";
}

/// The value with this name. to_string is empty for numbers above the enum's last value.
template <class Enum>
Enum value_called(const std::string& word) {
    for (int i = 0; !to_string(static_cast<Enum>(i)).empty(); ++i) {
        if (to_string(static_cast<Enum>(i)) == word) return static_cast<Enum>(i);
    }
    throw std::invalid_argument(word);
}

/// The inverse of reference::first_decision.
reference::FirstObject first_object_called(const std::string& word) {
    for (const reference::FirstObject first : {reference::FirstObject::tie, reference::FirstObject::no_hit}) {
        if (reference::first_decision(first) == word) return first;
    }
    for (const reference::Subject object : reference::objects) {
        if (to_string(object) == word) return reference::FirstObject(object);
    }
    throw std::invalid_argument(word);
}

auto row(Flag& flag) {
    return std::tie(flag.kind, flag.evidence);
}
auto row(OwnScene& scene) {
    return std::tie(scene.toml, scene.cause);
}
auto row(Submitter& submitter) {
    return std::tie(submitter.name, submitter.sid, submitter.email);
}
auto row(ScenesScore& score) {
    return std::tie(score.points, score.max_points);
}
auto row(ItemOnVariant& item) {
    return std::tie(item.question, item.item, item.run, item.before, item.after, item.diagnosis);
}
auto row(VariantRun& run) {
    return std::tie(run.name, run.changes, run.before, run.ended_well, run.share);
}
auto row(UntriedVariant& scene) {
    return std::tie(scene.name, scene.changes, scene.why);
}
auto row(MistakeOnScenes& mistake) {
    return std::tie(mistake.question, mistake.item, mistake.diagnosis, mistake.advice);
}
auto row(Doubt& doubt) {
    return std::tie(doubt.why, doubt.line);
}
auto row(RemainingDoubt& remaining) {
    return std::tie(remaining.question, remaining.item, remaining.doubt, remaining.layout_doubt);
}
/// A value that only some rows have.
template <class Value>
struct If {
    Value& value;
    bool is_written;
};
template <class T>
constexpr bool is_if = false;
template <class Value>
constexpr bool is_if<If<Value>> = true;
/// Items make up most of a record, and names would make up most of an item.
auto row(ItemScore& item) {
    return std::tuple_cat(
        std::tie(item.spec.name, item.verdict, item.points, item.max_points, item.printed, item.line, item.error,
                 item.allowance, item.accepted_as, item.diagnosis, item.advice, item.doubt),
        std::tuple(If{item.reread, !item.reread.empty()}, If{item.last_line, item.last_line > item.line},
                   If{item.by_columns, item.by_columns}),
        std::tie(item.layout_doubt),
        std::tuple(If{item.experiment, !item.experiment.empty()}, If{item.by_order, item.by_order},
                   If{item.difference, !item.difference.empty()}));
}

std::vector<reference::ItemSpec> default_items_of(int number) {
    std::vector<reference::ItemSpec> items;
    std::ranges::copy_if(reference::default_items(), std::back_inserter(items),
                         [&](const reference::ItemSpec& spec) { return spec.question == number; });
    return items;
}

/// The items that the question asks for, by full names; empty for a question of 2021, which is known by its number.
std::string asked_by(const QuestionScore& question) {
    std::string names;
    for (const ItemScore& item : question.items) {
        if (!names.empty()) names += ' ';
        names += reference::item_of(item.spec.id).full_name;
    }
    std::string by_default;
    for (const reference::ItemSpec& spec : default_items_of(question.number)) {
        if (!by_default.empty()) by_default += ' ';
        by_default += reference::item_of(spec.id).full_name;
    }
    return names == by_default ? "" : names;
}

/// The inverse of asked_by, for a question whose items have their names only.
void complete(QuestionScore& question, const std::string& asked) {
    reference::Question listed{question.number, {}, {}};
    for (std::size_t begin = 0; begin < asked.size();) {
        const std::size_t end = std::min(asked.find(' ', begin), asked.size());
        const reference::Item* item = reference::find_item(std::string_view(asked).substr(begin, end - begin));
        if (item == nullptr) throw std::invalid_argument(asked);
        listed.items.push_back(item->id);
        begin = end + 1;
    }
    const auto specs = asked.empty() ? default_items_of(question.number) : reference::asked_items({listed});
    for (ItemScore& item : question.items) {
        const auto found = std::ranges::find(specs, item.spec.name, &reference::ItemSpec::name);
        if (found == specs.end()) throw std::invalid_argument("an item of another question");
        item.spec = *found;
        item.last_line = std::max(item.line, item.last_line);
    }
    if (!question.title.empty()) return;
    const auto& questions = reference::default_questions();
    const auto found = std::ranges::find(questions, question.number, &reference::Question::number);
    if (found != questions.end()) question.title = found->title;
}

template <class Archive>
void fields(Archive& at, QuestionScore& question) {
    at.always("number", question.number);
    at.always("verdict", question.verdict);
    at.unless_default("title", question.title);
    at.always("items", question.items);
    std::string asked = Archive::reads ? "" : asked_by(question);
    at.unless_default("asks", asked);
    if (Archive::reads) complete(question, asked);
    at.unless_default("points", question.points);
    at.unless_default("max_points", question.max_points);
}

template <class Archive>
void fields(Archive& at, Score& score) {
    at.always("questions", score.questions);
    at.unless_default("points", score.points);
    at.unless_default("max_points", score.max_points);
    at.unless_default("other_scenes", score.variants);
    at.unless_default("follow_cap", score.follow_cap);
}

template <class Archive>
void fields(Archive& at, LmsName& name) {
    at.always("system", name.system);
    at.unless_default("student", name.student);
    at.unless_default("id", name.id);
    at.unless_default("attachment", name.attachment);
    at.unless_default("file", name.file);
    at.unless_default("handed_in", name.handed_in);
    bool late = name.late == true;
    at.unless_default("late", late);
    if (name.system == Lms::canvas) name.late = late;
    at.always("is_file", name.is_file);
    at.unless_default("submitters", name.submitters);
}

template <class Archive>
void fields(Archive& at, Submission& submission) {
    at.always("id", submission.id);
    at.unless_default("name", submission.name);
    at.unless_default("file", submission.file);
    at.unless_default("source_sha256", submission.source_sha256);
    at.unless_default("notes", submission.notes);
    at.unless_default("lms", submission.lms);
    at.unless_default("problem", submission.problem);
}

template <class Archive>
void fields(Archive& at, Build& build) {
    at.unless_default("tried", build.tried);
    at.unless_default("compiled", build.compiled);
    at.unless_default("reached_limit", build.reached_limit);
    at.unless_default("diagnostics", build.diagnostics);
    at.unless_default("ms", build.wall);
}

template <class Archive>
void fields(Archive& at, ProcessResult& run) {
    at.always("ended", run.ended);
    at.unless_default("exit_code", run.exit_code);
    at.unless_default("signal", run.signal);
    at.unless_default("error", run.error);
    at.unless_default("cpu_ms", run.cpu);
    at.unless_default("wall_ms", run.wall);
    at.unless_default("peak_memory_bytes", run.peak_memory_bytes);
    at.unless_default("errors", run.errors);
    at.unless_default("errors_truncated", run.errors_truncated);
}

template <class Archive>
void fields(Archive& at, VariantsReport& report) {
    at.always("verdict", report.verdict);
    at.always("not_found", report.not_found);
    at.always("runs", report.runs);
    at.always("moved", report.moved);
    at.always("broken", report.broken);
    at.always("unmoved", report.unmoved);
    at.unless_default("not_tried", report.not_tried);
    at.unless_default("seed", report.seed);
}

template <class Archive>
void fields(Archive& at, ItemPlace& place) {
    at.always("question", place.question);
    at.always("item", place.item);
    std::string lines = Archive::reads ? "" : lines_text(place);
    at.unless_default("lines", lines);
    std::string first = place.first_object ? std::string(reference::first_decision(place.first_object)) : "";
    at.unless_default("first_object", first);
    if (Archive::reads && !first.empty()) place.first_object = first_object_called(first);
    if (Archive::reads && !lines.empty()) {
        const std::optional<ItemPlace> read = read_lines(lines);
        if (!read) throw std::invalid_argument(lines);
        place.first_line = read->first_line;
        place.last_line = read->last_line;
        place.numbers = read->numbers;
    }
    at.unless_default("order", place.order);
    at.unless_default("note", place.note);
    at.unless_default("by_experiment", place.by_experiment);
    at.unless_default("as_read", place.as_read);
}

template <class Archive>
void fields(Archive& at, ExperimentReport& report) {
    at.unless_default("places", report.places);
    at.unless_default("mistakes", report.mistakes);
    at.unless_default("doubts", report.doubts);
    at.unless_default("unsettled", report.unsettled);
}

template <class Archive>
void fields(Archive& at, Graded& graded) {
    at.always("submission", graded.submission);
    at.always("outcome", graded.execution.outcome);
    at.always("sandbox", graded.execution.tier);
    at.always("build", graded.execution.build);
    at.always("run", graded.execution.run);
    at.always("score", graded.score);
    at.unless_default("our_fault", graded.execution.our_fault);
    at.unless_default("compiler", graded.execution.compiler);
    at.unless_default("explanation", graded.execution.explanation);
    at.unless_default("printout_beginning", graded.execution.printout_beginning);
    at.unless_default("flags", graded.findings.flags);
    at.unless_default("sanitizer", graded.execution.sanitizer);
    at.unless_default("late_share", graded.late_share);
    at.unless_default("own_scene", graded.findings.own_scene);
    at.unless_default("other_scenes", graded.findings.variants);
    at.unless_default("stress", graded.findings.hard_scenes);
    at.unless_default("experiment", graded.findings.experiment);
}

template <class Value>
concept Row = requires(Value& value) {
    row(value);
};
template <class Value>
concept List = requires(Value& value) {
    value.emplace_back();
}
&&!std::same_as<Value, std::string>;
template <class Value>
concept Nullable = requires(Value& value) {
    value.reset();
};

struct Writer {
    static constexpr bool reads = false;
    json record = json::object();

    template <class Value>
    static json written(Value& value) {
        if constexpr (std::is_enum_v<Value>) {
            return to_string(value);
        } else if constexpr (std::same_as<Value, std::filesystem::path>) {
            return value.native();
        } else if constexpr (std::same_as<Value, std::chrono::milliseconds>) {
            return value.count();
        } else if constexpr (std::same_as<Value, HardScenesReport>) {
            return hard_scenes_json(value);
        } else if constexpr (is_if<Value>) {
            return value.is_written ? written(value.value) : json();
        } else if constexpr (Nullable<Value>) {
            return value ? written(*value) : json();
        } else if constexpr (List<Value>) {
            json::array_t list;
            for (auto& each : value) list.push_back(written(each));
            return list;
        } else if constexpr (Row<Value>) {
            json::array_t list = std::apply([](auto&&... each) { return json::array_t{written(each)...}; }, row(value));
            while (!list.empty() && list.back().is_null())
                list.pop_back();  // so that a new optional field does not change old records
            return list;
        } else if constexpr (requires(Writer at) { fields(at, value); }) {
            Writer inner;
            fields(inner, value);
            return std::move(inner.record);
        } else {
            return value;
        }
    }

    template <class Value>
    void always(const char* name, Value& value) {
        record[name] = written(value);
    }

    /// Most fields are at their default, and a class has hundreds of thousands of fields.
    template <class Value>
    void unless_default(const char* name, Value& value) {
        if constexpr (Nullable<Value>) {
            if (value) always(name, value);
        } else if constexpr (List<Value>) {
            if (!value.empty()) always(name, value);
        } else if (value != Value()) {
            always(name, value);
        }
    }
};

/// Throws json::exception or std::invalid_argument if a record is not as a Writer writes it.
struct Reader {
    static constexpr bool reads = true;
    const json& record;

    template <class Value>
    static void read(const json& from, Value& value) {
        if constexpr (std::is_enum_v<Value>) {
            value = value_called<Value>(from.get<std::string>());
        } else if constexpr (std::same_as<Value, std::chrono::milliseconds>) {
            value = std::chrono::milliseconds(whole_number<std::int64_t>(from));
        } else if constexpr (std::same_as<Value, HardScenesReport>) {
            value = hard_scenes_from_json(from);
        } else if constexpr (std::same_as<Value, std::string_view>) {
            value = item_name(from.get<std::string>());
        } else if constexpr (is_if<Value>) {
            if (!from.is_null()) read(from, value.value);
        } else if constexpr (Nullable<Value>) {
            if (!from.is_null()) read(from, value.emplace());
        } else if constexpr (List<Value>) {
            value.reserve(from.size());  // spare capacity would be a tenth of a class's memory
            for (const json& entry : from) read(entry, value.emplace_back());
        } else if constexpr (Row<Value>) {
            // The row of an older raygrade may be shorter.
            std::size_t i = 0;
            std::apply([&](auto&&... each) { ((i < from.size() ? read(from.at(i++), each) : void()), ...); },
                       row(value));
        } else if constexpr (requires(Reader at) { fields(at, value); }) {
            Reader inner{from};
            fields(inner, value);
        } else if constexpr (std::integral<Value> && !std::same_as<Value, bool>) {
            value = whole_number<Value>(from);
        } else {
            value = from.get<Value>();
        }
    }

    template <class Value>
    void always(const char* name, Value& value) {
        read(record.at(name), value);
    }

    template <class Value>
    void unless_default(const char* name, Value& value) {
        if (const auto found = record.find(name); found != record.end()) read(*found, value);
    }

    /// The item's name in the table of items, which outlives the record.
    static std::string_view item_name(const std::string& name) {
        for (const reference::Item& item : reference::known_items()) {
            if (item.id.name == name) return item.id.name;
            if (item.full_name == name) return item.full_name;
        }
        throw std::invalid_argument(name);
    }
};

/// Reports use these indices of runs without checking them.
void check_runs(const Graded& graded) {
    if (!graded.findings.variants) return;
    for (const auto* items : {&graded.findings.variants->broken, &graded.findings.variants->unmoved}) {
        for (const ItemOnVariant& item : *items) {
            if (item.run >= graded.findings.variants->runs.size())
                throw std::invalid_argument("a run that is not there");
        }
    }
}

}  // namespace

std::vector<std::uint8_t> to_record(const Graded& graded) {
    Graded copy = graded;  // a Writer takes a reference to non-const, like a Reader
    return json::to_cbor(Writer::written(copy));
}

std::optional<Graded> from_record(const std::vector<std::uint8_t>& record) {
    try {
        Graded graded;
        Reader::read(json::from_cbor(record), graded);
        check_runs(graded);
        return graded;
    } catch (const json::exception&) {
        return std::nullopt;
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

}  // namespace harness
