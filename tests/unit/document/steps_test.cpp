#include "document/steps.h"

#include <gtest/gtest.h>

namespace lapfx::document {
namespace {

void longer(Document& document) {
    document.change("Longer", [](Content& c) { c.scene.duration += 1; });
}

TEST(Steps, AreInEffectUntilTheyAreUndone) {
    Document document;
    EXPECT_EQ(newest_step(document), 0U);
    EXPECT_FALSE(WatchedStep(document));
    EXPECT_FALSE(WatchedStep(document).in_effect(document));
    longer(document);
    const std::uint64_t step = newest_step(document);
    EXPECT_NE(step, 0U);
    WatchedStep first(document);
    EXPECT_TRUE(first);
    document.change("Nothing", [](Content&) {});
    EXPECT_EQ(newest_step(document), step) << "what changes nothing is no step";
    document.change("Brighter", [](Content& c) { c.scene.camera.exposure *= 2; });
    EXPECT_NE(newest_step(document), step);
    WatchedStep second(document);
    EXPECT_TRUE(first.in_effect(document));
    document.undo();
    EXPECT_TRUE(first.in_effect(document));
    EXPECT_FALSE(second.in_effect(document));
    document.redo();
    EXPECT_TRUE(second.in_effect(document));
    document.undo(), document.undo();
    document.change("Shorter", [](Content& c) { c.scene.duration -= 1; });
    document.change("Darker", [](Content& c) { c.scene.camera.exposure /= 2; });
    EXPECT_FALSE(first.in_effect(document)) << "there are as many steps, but others";
    EXPECT_FALSE(second.in_effect(document));
}

TEST(Steps, ThatTheHistoryHasForgottenStayInEffect) {
    Document document;
    longer(document);
    WatchedStep first(document);
    longer(document);
    WatchedStep second(document);
    for (std::size_t i = 0; i < Document::most_steps; ++i) {
        longer(document);
        EXPECT_TRUE(first.in_effect(document)) << "after " << i;
        EXPECT_TRUE(second.in_effect(document)) << "after " << i;
    }
    ASSERT_EQ(document.steps().size(), Document::most_steps);
    while (document.done() > 0) document.undo();
    EXPECT_TRUE(first.in_effect(document)) << "nothing undoes it any more";
    EXPECT_TRUE(second.in_effect(document));
    longer(document);
    EXPECT_TRUE(first.in_effect(document)) << "with another history behind it";
    document.open({});
    EXPECT_FALSE(first.in_effect(document)) << "it was of another document";
}

TEST(Steps, ThatWereUndoneAreNotTakenForForgottenOnes) {
    Document document;
    longer(document);
    WatchedStep first(document);
    document.undo();
    EXPECT_FALSE(first.in_effect(document));
    for (std::size_t i = 0; i < Document::most_steps + 5; ++i) {
        longer(document);
        EXPECT_FALSE(first.in_effect(document)) << "it comes before all that there are, after " << i;
    }
}

}  // namespace
}  // namespace lapfx::document
