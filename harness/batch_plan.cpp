#include "harness/batch_plan.h"

#include <algorithm>

#include "harness/include_block.h"

namespace harness {
namespace {

/// The runs of each submission.
std::vector<std::string> variants(const Workshop& workshop) {
    std::vector<std::string> variants{"first"};
    for (int i = 2; i <= workshop.repetitions; ++i) variants.push_back("repetition " + std::to_string(i));
    if (workshop.sanitize) variants.emplace_back("sanitized");
    return variants;
}

void look_into_store(BatchPlan& plan, const std::vector<Submission>& submissions, const Workshop& workshop) {
    plan.keys.resize(submissions.size());
    plan.is_kept.resize(submissions.size(), false);
    if (!workshop.store) return;
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        if (submissions[i].problem) continue;
        for (const std::string& variant : variants(workshop))
            plan.keys[i].push_back(execution_key(submissions[i].source, workshop, variant));
        plan.is_kept[i] =
            !workshop.fresh && std::all_of(plan.keys[i].begin(), plan.keys[i].end(),
                                           [&](const std::string& key) { return workshop.store->contains(key); });
    }
}

HeaderLines header_lines(const std::string& source) {
    HeaderLines lines;
    for (const Directive& directive : include_block(source)) lines.push_back(directive.text);
    return lines;
}

void share_headers(BatchPlan& plan, const std::vector<Submission>& submissions, const Workshop& workshop) {
    std::vector<std::size_t> to_compile;
    std::vector<HeaderLines> blocks;
    for (std::size_t i = 0; i < submissions.size(); ++i) {
        if (plan.is_kept[i] || submissions[i].problem || !workshop.headers) {
            plan.at_once.push_back(i);
            continue;
        }
        to_compile.push_back(i);
        blocks.push_back(header_lines(submissions[i].source));
    }
    if (to_compile.empty()) return;
    HeaderPlan header_plan = plan_headers(blocks, workshop.headers->made());
    plan.headers = std::move(header_plan.headers);
    plan.with_header.resize(plan.headers.size());
    for (std::size_t i = 0; i < to_compile.size(); ++i) {
        auto& group = header_plan.header_of[i] ? plan.with_header[*header_plan.header_of[i]] : plan.at_once;
        group.push_back(to_compile[i]);
    }
}

}  // namespace

BatchPlan plan_batch(const std::vector<Submission>& submissions, const Workshop& workshop) {
    BatchPlan plan;
    look_into_store(plan, submissions, workshop);
    share_headers(plan, submissions, workshop);
    return plan;
}

}  // namespace harness
