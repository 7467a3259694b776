#include "harness/match/label.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace harness {
namespace {

const reference::ItemSpec& item(int question, std::string_view name) {
    const auto items = reference::default_items();
    return *std::find_if(items.begin(), items.end(),
                         [&](const auto& i) { return i.question == question && i.name == name; });
}

LabelFit fit(std::string_view label, int question, std::string_view name) {
    return fit_label(label, "", item(question, name));
}

TEST(FitLabel, IgnoresNegatedWords) {
    EXPECT_EQ(fit("N before normalizing", 7, "normal"), LabelFit::forbidden);
    EXPECT_EQ(fit("N (not normalized)", 7, "normal"), LabelFit::forbidden);
    EXPECT_EQ(fit("DEBUG: t", 6, "t"), LabelFit::forbidden);
}

TEST(FitLabel, KnowsTheHandoutsNames) {
    EXPECT_EQ(fit("Pixel in VCS", 1, "P_VCS"), LabelFit::exact);
    EXPECT_EQ(fit("the discriminant d", 6, "d"), LabelFit::exact);
    EXPECT_EQ(fit("right-hand side", 8, "rhs"), LabelFit::exact);
    EXPECT_EQ(fit("The smaller positive root is t", 6, "t"), LabelFit::exact);
    EXPECT_EQ(fit("N normalized", 9, "normal"), LabelFit::exact);
}

TEST(FitLabel, RanksAHintBelowAName) {
    EXPECT_LT(fit("t1", 6, "t"), fit("t", 6, "t"));
    EXPECT_EQ(fit("t minus", 6, "t"), LabelFit::weak);
    EXPECT_LT(fit("root 2", 6, "t"), fit("t (chosen)", 6, "t"));
    EXPECT_LT(fit("sqrt(d)", 6, "t"), LabelFit::none);
}

TEST(FitLabel, IsOfWhatStandsBeforeAPlace) {
    EXPECT_EQ(fit("norm at hit", 7, "normal"), LabelFit::weak);
    EXPECT_EQ(fit("surface normal at the hit point", 7, "normal"), LabelFit::named);
    EXPECT_EQ(fit("the ray hits the sphere at point P_s", 6, "hit"), LabelFit::named);
    EXPECT_EQ(fit("value at hit", 6, "hit"), LabelFit::exact);
    EXPECT_EQ(fit("hit point on the sphere", 6, "hit"), LabelFit::named);
    EXPECT_EQ(fit("hit at t", 6, "t"), LabelFit::named);
}

TEST(FitLabel, RecognisesOperandsInAFormula) {
    EXPECT_EQ(fit("S + t*V", 6, "t"), LabelFit::foreign);
}

TEST(FitLabel, IsNotOfAnItemThatIsReckonedWith) {
    EXPECT_EQ(fit("1-u", 8, "u"), LabelFit::foreign);
    EXPECT_EQ(fit("2 * A", 8, "matrix"), LabelFit::foreign);
}

TEST(FitValue, UsesTheWordsAfterAValueOnlyIfNonePrecedeIt) {
    PrintedValue value;
    value.after = "t";
    EXPECT_EQ(fit_value(value, item(6, "t"), reference::default_items()), LabelFit::exact);
    EXPECT_EQ(fit_value(value, item(6, "d"), reference::default_items()), LabelFit::foreign);
    value.label = "d";
    EXPECT_EQ(fit_value(value, item(6, "d"), reference::default_items()), LabelFit::exact);
}

TEST(ListedItems, AreReadFromALabelThatOnlyListsThem) {
    const std::vector<reference::ItemSpec> items = {item(8, "t"), item(8, "u"), item(8, "v")};
    EXPECT_EQ(listed_items("(u, v, t)", items), (std::vector<std::size_t>{1, 2, 0}));
    EXPECT_EQ(listed_items("the values of t, u and v", items), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(listed_items("uvt", items), (std::vector<std::size_t>{1, 2, 0}));
    EXPECT_EQ(listed_items("values tuv", items), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_TRUE(listed_items("utu", items).empty());
    EXPECT_TRUE(listed_items("t", items).empty());
    EXPECT_TRUE(listed_items("t, t", items).empty());
}

}  // namespace
}  // namespace harness
