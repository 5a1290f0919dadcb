#include "app/tuning/key_titles.h"

#include <gtest/gtest.h>

#include "app/tuning/parameters.h"

namespace lapfx::app {
namespace {

TEST(KeyTitles, AreThoseOfTheWindow) {
    EXPECT_EQ(title_of("smoke.haze.ventilation"), "Haze: Ventilation");
    EXPECT_EQ(title_of("camera.exposure"), "Camera: Exposure");
    EXPECT_EQ(title_of("organ.color"), "Organ: Colour");
    EXPECT_EQ(title_of("events.2.time"), "Event 3: Time");
    EXPECT_EQ(title_of("curves.emission"), "Emission");
    for (const char* none : {"", "smoke", "smoke.haze.nothing", "events.x.time", "events.1.nothing", "0.5"})
        EXPECT_EQ(title_of(none), "") << none;
    for (const ParameterEntry& entry : parameters().entries()) EXPECT_EQ(title_of(entry.key), entry.title);
}

TEST(KeyTitles, ReplaceKeysAndArrowsInSentencesAndNothingElse) {
    EXPECT_EQ(
        with_titles("smoke.haze.ventilation: not determined, the veil never falls; 4 s of clearing would tell it"),
        "Haze: Ventilation: not determined, the veil never falls; 4 s of clearing would tell it");
    EXPECT_EQ(with_titles("it does the same to the curves as smoke.plume.density; hold one of both"),
              "it does the same to the curves as Plume: Density; hold one of both");
    EXPECT_EQ(with_titles("camera.exposure: 1.9 -> 2.4, the tissue was 1.26 times as bright."),
              "Camera: Exposure: 1.9 \u2192 2.4, the tissue was 1.26 times as bright.");
    EXPECT_EQ(with_titles("a longer bleeding.speed."), "a longer Bleeding: Speed.");
    for (const char* as_it_is : {"", ".", "blood: from 1.2 s, strength 0.40", "organ", "\xc3\xa4 name.of_none \xff"})
        EXPECT_EQ(with_titles(as_it_is), as_it_is);
}

}  // namespace
}  // namespace lapfx::app
