#include "harness/report/exchange/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "harness/record/final_mark.h"
#include "harness/report/text/item_text.h"
#include "harness/report/text/sentences.h"
#include "harness/text/escape.h"

namespace harness::report {
namespace {

constexpr const char* does_not_compile = "The program does not compile.";

/// XML 1.0 allows neither control bytes nor U+FFFE and U+FFFF.
std::string xml_text(std::string_view text) {
    std::string safe = escape_control(text);
    for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) {
        for (std::size_t at = safe.find(none); at != std::string::npos; at = safe.find(none, at))
            safe.replace(at, none.size(), none.back() == '\xBE' ? "\\ufffe" : "\\uffff");
    }
    return safe;
}

std::string or_else(const std::string& sentence, const char* otherwise) {
    return sentence.empty() ? otherwise : sentence;
}

enum class Result { passed, failed, error, skipped };

struct Case {
    std::string classname;
    std::string name;
    std::chrono::milliseconds time{0};
    Result result = Result::passed;
    std::string message = {};  ///< a sentence
    std::string text = {};     ///< the details
};

Case answer_case(const Graded& graded, const QuestionScore& question, const ItemScore& item, const Marking& marking) {
    Case one{fmt::format("{}.question {}", graded.submission.id, question.number), std::string(item.spec.name)};
    const bool of_question = find_override(graded, question.number, "") != nullptr;
    // If the instructor gave points to a whole question, they do not belong to single items.
    const bool passed = of_question ? is_passed(final_points(graded, question), question.max_points, question.verdict)
                                    : is_passed(final_points(graded, question, item), item.max_points, item.verdict);
    one.text = item_text(graded, question, item, marking) + override_text(find_override(graded, question.number, ""));
    if (graded.execution.outcome == Outcome::compile_error) {
        one.result = Result::skipped;
        one.message = does_not_compile;
        one.text.clear();
    } else if (!passed) {
        one.result = Result::failed;
        one.message = or_else(item_sentence(item, graded.execution.outcome, feedback_now(marking.assignment.rubric)),
                              "This answer did not get full points.");
    } else if (item.verdict == ItemVerdict::right && item.accepted_as.empty()) {
        one.text.clear();
    }
    return one;
}

/// The points for other scenes.
Case scenes_case(const Graded& graded) {
    Case one{graded.submission.id, "other scenes"};
    if (graded.execution.outcome == Outcome::compile_error) {
        one.result = Result::skipped;
        one.message = does_not_compile;
    } else if (!is_passed(final_scenes_points(graded), graded.score.variants->max_points, ItemVerdict::wrong)) {
        one.result = Result::failed;
        one.message = scenes_sentence(graded);
        one.text = scenes_text(graded);
    }
    return one;
}

std::vector<Case> cases_of(const Graded& graded, const Marking& marking) {
    const std::string& id = graded.submission.id;
    if (graded.execution.outcome == Outcome::not_graded) {
        Case whole{id, "is graded"};
        whole.text = submission_text(graded);
        if (!final_mark(graded)) {
            whole.result = Result::error;
            whole.message = or_else(graded.execution.explanation, "Not graded.");
        }
        return {whole};
    }
    Case compiles{id, "compiles", graded.execution.build.wall};
    Case runs{id, "runs", graded.execution.run.wall};
    if (graded.execution.outcome == Outcome::compile_error) {
        compiles.result = Result::failed;
        compiles.message = or_else(graded.execution.explanation, does_not_compile);
        compiles.text = submission_text(graded);
        runs.result = Result::skipped;
        runs.message = does_not_compile;
    } else if (graded.execution.outcome != Outcome::graded) {
        runs.result = Result::failed;
        runs.message = or_else(graded.execution.explanation, "The program did not finish.");
        runs.text = submission_text(graded);
    }
    std::vector<Case> cases{compiles, runs};
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) cases.push_back(answer_case(graded, question, item, marking));
    }
    if (graded.score.variants) cases.push_back(scenes_case(graded));
    return cases;
}

struct Counts {
    std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
    std::chrono::milliseconds time{0};

    void add(const Case& one) {
        ++tests;
        failures += one.result == Result::failed ? 1 : 0;
        errors += one.result == Result::error ? 1 : 0;
        skipped += one.result == Result::skipped ? 1 : 0;
        time += one.time;
    }
};

std::string seconds(std::chrono::milliseconds time) {
    return fmt::format("{:.3f}", static_cast<double>(time.count()) / 1000.0);
}

void set(pugi::xml_node node, const char* name, const std::string& value) {
    node.append_attribute(name).set_value(xml_text(value).c_str());
}

void set(pugi::xml_node node, const Counts& counts) {
    set(node, "tests", std::to_string(counts.tests));
    set(node, "failures", std::to_string(counts.failures));
    set(node, "errors", std::to_string(counts.errors));
    set(node, "skipped", std::to_string(counts.skipped));
    set(node, "time", seconds(counts.time));
}

void add_case(pugi::xml_node suite, const Case& one) {
    pugi::xml_node node = suite.append_child("testcase");
    set(node, "classname", one.classname);
    set(node, "name", one.name);
    set(node, "time", seconds(one.time));
    const auto add = [&](const char* name, const char* type) {
        pugi::xml_node result = node.append_child(name);
        set(result, "message", one.message);
        if (type != nullptr) set(result, "type", type);
        if (!one.text.empty()) result.text().set(xml_text(one.text).c_str());
    };
    switch (one.result) {
        case Result::passed:
            if (!one.text.empty()) node.append_child("system-out").text().set(xml_text(one.text).c_str());
            break;
        case Result::failed: add("failure", "marks"); break;
        case Result::error: add("error", "not graded"); break;
        case Result::skipped: add("skipped", nullptr); break;
    }
}

void add_properties(pugi::xml_node suite, const Graded& graded) {
    pugi::xml_node properties = suite.append_child("properties");
    const auto add = [&](const char* name, const std::string& value) {
        pugi::xml_node property = properties.append_child("property");
        set(property, "name", name);
        set(property, "value", value);
    };
    if (const auto mark = final_mark(graded)) add("points", fmt::format("{:.2f}", mark->points));
    add("max_points", fmt::format("{:.2f}", graded.score.max_points));
    add("outcome", std::string(to_string(graded.execution.outcome)));
    const auto& lms = graded.submission.lms;
    if (lms && lms->late) add("late", *lms->late ? "true" : "false");
}

}  // namespace

std::string junit(const Graded& graded, const Marking& marking) {
    const std::vector<Case> cases = cases_of(graded, own_marking(marking, graded.submission));
    Counts counts;
    for (const Case& each : cases) counts.add(each);
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    document.append_child(pugi::node_comment).set_value(" JUnit XML of raygrade ");
    pugi::xml_node suites = document.append_child("testsuites");
    set(suites, "name", marking.assignment.title);
    set(suites, counts);
    pugi::xml_node suite = suites.append_child("testsuite");
    set(suite, "name", graded.submission.id);
    set(suite, counts);
    add_properties(suite, graded);
    for (const Case& each : cases) add_case(suite, each);
    std::ostringstream text;
    document.save(text, "  ", pugi::format_indent, pugi::encoding_utf8);
    return std::move(text).str();
}

}  // namespace harness::report
