// A class whose review is open, and somebody who uses its pages.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/given/serve/client.h"
#include "tests/scenario/scenario.h"

namespace scenario {

/// A program that prints question 5 twice: first with these numbers, which are read, and then, in line 6, rightly, for
/// 10 points.
std::string twice(const std::string& numbers, const std::string& title = "Question 6");

using Fields = std::vector<std::pair<std::string, std::string>>;

class Review : public testing::Test {
  protected:
    Review();
    ~Review() override {
        if (server > 0) end();
    }

    std::filesystem::path student(const std::string& id) const { return folder / "class" / id / "ray_cast.cpp"; }
    std::filesystem::path out() const { return folder / "out"; }
    Result run(const std::vector<std::string>& words) const { return raygrade(words, with_cache(folder / "cache")); }
    Result grade() const { return run({"grade", (folder / "class").string(), "--out", out().string(), "--apply"}); }
    nlohmann::json graded(const std::string& id) const { return submission_in(read_json(out() / "grades.json"), id); }
    double points(const std::string& id) const { return graded(id).at("points").get<double>(); }
    std::string feedback(const std::string& id) const {
        return read(out() / "feedback" / (id + ".md")) + read(out() / "feedback" / (id + ".html"));
    }

    void start();
    int end();

    harness::serve::HttpAnswer get(const std::string& path, const std::string& more = "") const {
        return harness::serve::ask(port, harness::serve::get(path, more));
    }
    std::string list() const { return get(root + "/").body; }
    std::string page(int number) const { return get(root + "/student/" + std::to_string(number)).body; }
    harness::serve::HttpAnswer post(const std::string& path, const Fields& fields, const std::string& more = "") const;
    /// The hidden fields that say which student, in which state.
    static Fields whose(const std::string& page);
    harness::serve::HttpAnswer decide(const std::string& page, const Fields& more) const {
        Fields fields = whose(page);
        fields.insert(fields.end(), more.begin(), more.end());
        return post("/decide", fields);
    }
    harness::serve::HttpAnswer accept(int number, const std::string& kind = "reading_doubtful") const {
        return decide(page(number), {{"kind", "accepted"}, {"about", kind}, {"for", "one"}});
    }
    harness::serve::HttpAnswer give(const std::string& page, const std::string& item, const std::string& given,
                                    const std::string& why = "a <slip>") const {
        return decide(page, {{"kind", "override"}, {"about", item}, {"points", given}, {"text", why}, {"for", "one"}});
    }
    /// The number at the end of the address to which a decision leads.
    static std::string decision(const harness::serve::HttpAnswer& answer);
    harness::serve::HttpAnswer undo(const std::string& number) const {
        return post("/undo", {{"number", number}, {"back", "ada"}});
    }
    /// What the page before a group's decision offers: the checkboxes' values.
    static std::vector<std::string> offered(const std::string& page);

    TemporaryFolder folder;
    pid_t server = 0;
    std::uint16_t port = 0;
    std::string root;
};

}  // namespace scenario
