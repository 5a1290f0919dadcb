// The list of parameters and their text on the clipboard.
#include "app/parameters.h"

#include "app/parameter_text.h"
#include "unit/preset/support.h"

namespace lapfx::app {
namespace {

TEST(Parameters, KeysAndPointersLeadToTheSameValueAsInTheTable) {
    Preset preset;
    for (const ParameterEntry& entry : parameters().entries()) {
        const Place place = find_parameter(preset_table(), &preset, entry.key);
        EXPECT_EQ(place.row, entry.row) << entry.key;
        EXPECT_EQ(place.owner, entry.owner(preset)) << entry.key;
        EXPECT_EQ(place.pointer, entry.pointer);
    }
}

TEST(Parameters, BoundsWithARuleBetweenThemArePairs) {
    std::vector<std::string> names;
    for (const ParameterEntry& entry : parameters().entries()) {
        if (entry.high == no_entry) continue;
        names.push_back(entry.range_title);
        EXPECT_EQ(&parameters()[parameters()[entry.high].low], &entry);
        EXPECT_NE(entry.words.find(parameters()[entry.high].key), std::string::npos) << "found by either";
    }
    EXPECT_EQ(names, (std::vector<std::string>{"Vessels: Vessel", "Vessels: Fat", "Keying: Luma", "Keying: Chroma"}));
}

TEST(Parameters, TextOfAValueIsReadAsThatValue) {
    Preset from, to;
    from.bleeding.color_thin = {0.1, 0.2, 0.35};  // no 8-bit colour
    from.cautery.model = HeatModel::bioheat;
    from.bleeding.noise_octaves = 5;
    from.smoke.haze.extinction = {0.125, 1e-3, 2};
    from.tags = "one, two";
    for (const ParameterEntry& entry : parameters().entries())
        set_parameter(preset_table(), &to, entry.key, text_of(*entry.row, entry.row->get(entry.owner(from))));
    EXPECT_EQ(write_preset(to), write_preset(from));
}

TEST(ParameterText, AGroupIsTheOnlyThingThatChanges) {
    Preset a = test::full_preset(), b = test::full_preset();
    a.smoke.keying.luma_low = 33;
    a.bleeding.speed = 7;
    a.smoke.clips.clear();
    const std::string_view keying[] = {"smoke.keying"};
    const Preset pasted = paste_parameters(b, copy_parameters(a, keying));
    b.smoke.keying.luma_low = 33;
    EXPECT_EQ(write_preset(pasted), write_preset(b));
    EXPECT_EQ(write_preset(paste_parameters(b, copy_parameters(a, {}))), write_preset(a)) << "all, clips too";
}

TEST(ParameterText, AWholePresetGivesTheGroupThatIsAskedFor) {
    Preset a, b;
    a.bleeding.speed = 7;
    a.smoke.haze.suction = 3;
    EXPECT_EQ(write_preset(paste_parameters(b, write_preset(a), "bleeding")), [&] {
        b.bleeding.speed = 7;
        return write_preset(b);
    }());
}

TEST(ParameterText, EveryFaultIsToldWithItsPlace) {
    const auto faults = [](std::string_view text, std::string_view group = {}) {
        return test::faults_of([&] { paste_parameters(Preset{}, text, group); });
    };
    EXPECT_EQ(faults("{\"bleeding\": {\"speed\": -3, \"gloss\": \"much\"}}").size(), 2U);
    EXPECT_EQ(faults("{}", "vessels"),
              std::vector<std::string>{
                  "clipboard: /vessels: \"vessels\" is not in the text; it holds no group of parameters"});
    EXPECT_EQ(faults("{\"bleeding\": null}").size(), 1U);
    EXPECT_EQ(faults(std::string(1 << 16, '[')).size(), 1U);
    EXPECT_EQ(faults("\xff\xfe").size(), 1U);
    EXPECT_EQ(faults("").size(), 1U);
}

}  // namespace
}  // namespace lapfx::app
