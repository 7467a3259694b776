// What certainty costs: which methods are compared, and what is said of them.
#include "harness/report/accuracy/price.h"

#include <gmock/gmock.h>

#include "harness/report/accuracy/report.h"

namespace {

using namespace harness::report;
using reference::accuracy::Measurement;
using reference::accuracy::Primitive;
using reference::accuracy::Row;
using testing::HasSubstr;
using testing::Not;

Row row(const std::string& kernel, const std::string& scalar, double ns) {
    return {Primitive::sphere, kernel, scalar, "a book", "benign", false, 1000, ns, ns - 1, ns + 1};
}
Row certain(Row row) {
    row.certain = true;
    return row;
}
Row decision(Row row) {
    row.gives_t = false;
    return row;
}
Measurement measured(std::vector<Row> rows) {
    return {1, 1000, 5, "g++ 12", "-O2", "", std::move(rows)};
}

TEST(Prices, CompareTheCertainMethodWithTheFastestThatRoundsInItsShape) {
    const auto found = prices(measured({row("slow", "double", 20), row("fast", "double", 8), row("fast", "float", 2),
                                        decision(row("sign", "double", 3)), certain(row("proven", "double", 12)),
                                        certain(row("careful", "double", 90))}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].certain, "proven");
    EXPECT_EQ(found[0].rival, "fast");
    EXPECT_DOUBLE_EQ(found[0].times(), 1.5);
    EXPECT_DOUBLE_EQ(found[0].least_times(), 11.0 / 9);
    EXPECT_DOUBLE_EQ(found[0].most_times(), 13.0 / 7);
}

TEST(Prices, ComeFromBenignRaysAlone) {
    auto hard = row("fast", "double", 1);
    hard.hard = true;
    hard.distribution = "grazing";
    EXPECT_THAT(prices(measured({hard, certain(row("proven", "double", 12))})).size(), 0U);
}

TEST(Prices, AreNotClaimedWhereNothingCertainWasMeasured) {
    const AccuracyFindings findings{measured({row("fast", "double", 8)}), {}};
    EXPECT_THAT(accuracy_html(findings), Not(HasSubstr("class=\"price\"")));
    EXPECT_THAT(accuracy_text(findings), Not(HasSubstr("Never to be wrong")));
}

}  // namespace
