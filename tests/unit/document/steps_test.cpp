#include "document/steps.h"

#include <gtest/gtest.h>

namespace lapfx::document {
namespace {

TEST(Steps, AreInEffectUntilTheyAreUndone) {
    Document document;
    EXPECT_EQ(newest_step(document), 0U);
    EXPECT_FALSE(in_effect(document, 0));
    document.change("Longer", [](Content& c) { c.scene.duration += 1; });
    const std::uint64_t longer = newest_step(document);
    EXPECT_NE(longer, 0U);
    document.change("Nothing", [](Content&) {});
    EXPECT_EQ(newest_step(document), longer) << "what changes nothing is no step";
    document.change("Brighter", [](Content& c) { c.scene.camera.exposure *= 2; });
    const std::uint64_t brighter = newest_step(document);
    EXPECT_NE(brighter, longer);
    EXPECT_TRUE(in_effect(document, longer));
    document.undo();
    EXPECT_TRUE(in_effect(document, longer));
    EXPECT_FALSE(in_effect(document, brighter));
    document.redo();
    EXPECT_TRUE(in_effect(document, brighter));
    document.undo(), document.undo();
    document.change("Shorter", [](Content& c) { c.scene.duration -= 1; });
    document.change("Darker", [](Content& c) { c.scene.camera.exposure /= 2; });
    EXPECT_FALSE(in_effect(document, longer)) << "there are as many steps, but others";
    EXPECT_FALSE(in_effect(document, brighter));
}

}  // namespace
}  // namespace lapfx::document
