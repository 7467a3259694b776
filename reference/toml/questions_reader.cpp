#include "reference/toml/questions_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "reference/toml/near_names.h"

namespace reference {
namespace {

constexpr int most_questions = 99;

/// Whether the scene has the item's object. Questions about the first object need two kinds of objects.
bool is_in_scene(Subject subject, const Scene<Decimal>& scene) {
    if (subject == Subject::camera) return true;
    if (subject != Subject::first_hit) return count_of(subject, scene) > 0;
    return std::ranges::count_if(objects, [&](Subject object) { return count_of(object, scene) > 0; }) >= 2;
}

class QuestionReader {
  public:
    explicit QuestionReader(const Scene<Decimal>& scene) : scene_(scene) {}

    void read(const TomlTable& table) {
        table.allow_only({"number", "title", "items", "parts", "points"});
        const int last = result_.questions.empty() ? 0 : result_.questions.back().number;
        Question question{table.has("number") ? table.integer("number", 1, most_questions) : last + 1, {}, {}};
        if (question.number <= last)
            table.fail("number",
                       fmt::format("is {} after {}; number the questions in ascending order", question.number, last));
        question.title = table.has("title") ? table.string("title") : fmt::format("question {}", question.number);
        if (table.has("points")) result_.points[question.number] = table.amount("points", 0, most_points);
        if (table.has("parts"))
            read_parts(table, question);
        else
            question.items = read_items(table);
        result_.questions.push_back(std::move(question));
    }

    ReadQuestions result() && { return std::move(result_); }

  private:
    void read_parts(const TomlTable& table, Question& question) {
        if (table.has("items")) table.fail("items", "cannot be used with parts; put each item into its part");
        const std::vector<TomlTable> parts = table.tables("parts");
        if (parts.empty()) table.fail("parts", "must have at least one part");
        for (const TomlTable& part : parts) {
            part.allow_only({"title", "items", "points"});
            question.parts.push_back({part.has("title") ? part.string("title") : "", read_items(part)});
            const std::vector<ItemId>& items = question.parts.back().items;
            question.items.insert(question.items.end(), items.begin(), items.end());
            if (part.has("points") && table.has("points"))
                part.fail("points", "is given for a part and for the whole question; keep one");
            if (part.has("points") != parts.front().has("points"))
                part.fail("points", "is given for only some parts of the question; give each part its points");
        }
        if (parts.front().has("points")) share_points(parts, question);
    }

    void share_points(const std::vector<TomlTable>& parts, const Question& question) {
        const std::vector<ItemSpec> specs = asked_items({question});
        auto spec = specs.begin();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const double points = parts[i].amount("points", 0, most_points);
            const std::size_t count = question.parts[i].items.size();
            result_.points[question.number] += points;
            for (const auto end = spec + static_cast<std::ptrdiff_t>(count); spec != end; ++spec) {
                result_.item_points[question.number][std::string(spec->name)] = points / static_cast<double>(count);
            }
        }
    }

    std::vector<ItemId> read_items(const TomlTable& table) {
        std::vector<ItemId> items;
        for (const std::string& name : table.strings("items")) items.push_back(read_item(table, name));
        if (items.empty()) table.fail("items", "must name at least one item");
        return items;
    }

    ItemId read_item(const TomlTable& table, const std::string& name) {
        const Item* item = find_item(name);
        if (item == nullptr) {
            std::vector<std::string> names;
            for (const Item& wanted_item : known_items()) names.emplace_back(wanted_item.full_name);
            table.fail("items", fmt::format("has \"{}\", which is not an item; {}", name, did_you_mean(name, names)));
        }
        if (!is_in_scene(item->id.subject, scene_)) {
            table.fail("items", item->id.subject == Subject::first_hit
                                    ? fmt::format("has \"{}\", which needs objects of two kinds in the scene", name)
                                    : fmt::format("has \"{0}\", but the scene has no {1}; add [[{1}]]", name,
                                                  to_string(item->id.subject)));
        }
        if (std::ranges::find(asked_, item->id) != asked_.end())
            table.fail("items", fmt::format("asks for \"{}\" twice; ask once", name));
        asked_.push_back(item->id);
        return item->id;
    }

    const Scene<Decimal>& scene_;
    std::vector<ItemId> asked_;
    ReadQuestions result_;
};

}  // namespace

ReadQuestions read_questions(const TomlTable& root, const Scene<Decimal>& scene) {
    const std::vector<TomlTable> tables = root.tables("question");
    if (tables.empty()) {
        ReadQuestions result{default_questions(), {}, {}};
        for (Question& question : result.questions)
            std::erase_if(question.items, [&](const ItemId& id) { return !is_in_scene(id.subject, scene); });
        std::erase_if(result.questions, [](const Question& question) { return question.items.empty(); });
        return result;
    }
    QuestionReader reader(scene);
    for (const TomlTable& table : tables) reader.read(table);
    return std::move(reader).result();
}

}  // namespace reference
