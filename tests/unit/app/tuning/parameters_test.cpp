// The list of parameters and their text on the clipboard.
#include "app/tuning/parameters.h"

#include "app/tuning/parameter_text.h"
#include "app/tuning/parameter_words.h"
#include "document/tables.h"
#include "ui/widgets/combo.h"
#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx::app {
namespace {

TEST(Parameters, KeysAndPointersLeadToTheSameValueAsInTheTable) {
    Preset preset;
    for (const ParameterEntry& entry : parameters().entries()) {
        const FoundParameter place = find_parameter(preset_table(), &preset, entry.key);
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

std::vector<std::string> found(std::string_view query) {
    std::vector<std::string> keys;
    for (const ParameterEntry& entry : parameters().entries())
        if (ui::contains_words(entry.words, query)) keys.push_back(entry.key);
    return keys;
}

TEST(Parameters, EverydayWordsFindThem) {
    constexpr std::pair<std::string_view, std::string_view> asked[] = {
        {"blood size", "bleeding.max_extent"},
        {"blood spread", "bleeding.max_extent"},
        {"blood amount", "bleeding.max_extent"},
        {"blood transparent", "bleeding.opacity"},
        {"blood colour dark", "bleeding.color_deep"},
        {"artery", "bleeding.pulse_rate"},
        {"heartbeat", "bleeding.pulse_strength"},
        {"shiny", "bleeding.gloss"},
        {"green screen", "smoke.keying.key_color"},
        {"chroma key", "smoke.keying.chroma_low"},
        {"brightness", "smoke.keying.luma_low"},
        {"blur", "smoke.keying.feather"},
        {"smoke opacity", "smoke.plume.density"},
        {"smoke amount", "smoke.plume.density"},
        {"fog", "smoke.haze.accumulation"},
        {"veil clear", "smoke.haze.ventilation"},
        {"sparks", "smoke.particles.rate"},
        {"burn black", "cautery.char_temperature"},
        {"SPEED", "bleeding.speed"},
    };
    for (const auto& [query, key] : asked) {
        const std::vector<std::string> keys = found(query);
        EXPECT_NE(std::find(keys.begin(), keys.end(), key), keys.end()) << query << " does not find " << key;
        EXPECT_LT(keys.size(), parameters().entries().size() / 2) << query << " finds too many";
    }
}

/// Whether a row or a group of this document has the key.
bool known(const Table& root, std::string_view key) {
    const Table* at = &root;
    for (;;) {
        const std::size_t dot = std::min(key.find('.'), key.size());
        const std::string_view name = key.substr(0, dot);
        const Table* const next = at->find(name);
        if (dot == key.size()) return next != nullptr || at->find_row(name) != nullptr;
        if (next == nullptr) return false;
        at = next;
        key.remove_prefix(dot + 1);
    }
}

TEST(Parameters, EverydayWordsAreOfKeysThatAre) {
    for (const auto& [key, words] : parameter_words()) {
        const bool scene = key.starts_with("scene.");
        EXPECT_TRUE(known(scene ? scene_table() : preset_table(), scene ? key.substr(6) : key)) << key;
        EXPECT_FALSE(words.empty()) << key;
    }
    for (const ParameterEntry& entry : parameters().entries()) {
        if (entry.row->key == "name") continue;
        EXPECT_FALSE(everyday_words(entry.key).empty()) << entry.key << ": what do people call it?";
    }
    for (const Table& group : scene_table().tables)
        for (const Parameter& row : group.rows) {
            if (group.list != nullptr || row.kind == Kind::path) continue;
            const std::string key = "scene." + std::string(group.key) + '.' + std::string(row.key);
            EXPECT_FALSE(everyday_words(key).empty()) << key;
        }
}

TEST(Parameters, TooltipsLackNothing) {
    for (const ParameterEntry& entry : parameters().entries()) {
        const Parameter& row = *entry.row;
        const std::string& tip = entry.tip;
        EXPECT_GT(row.help.size(), 20U) << entry.key;
        EXPECT_TRUE(tip.starts_with(row.help)) << tip;
        EXPECT_NE(tip.find('\n' + entry.key), std::string::npos) << tip;
        if (entry.key == row.key) continue;  // name, description and tags are texts
        EXPECT_NE(tip.find(" by default"), std::string::npos) << tip;
        if (row.kind != Kind::number && row.kind != Kind::integer && row.kind != Kind::vector) continue;
        EXPECT_NE(tip.find(" to "), std::string::npos) << tip;
        EXPECT_NE(tip.find(row.unit.empty() ? "no unit" : ' ' + std::string(row.unit)), std::string::npos) << tip;
    }
}

/// The paper's word for every parameter that has one.
TEST(Parameters, TooltipsTellThePapersTerm) {
    constexpr std::pair<std::string_view, std::string_view> terms[] = {
        {"bleeding.speed", "bleeding speed"},
        {"bleeding.max_extent", "upper threshold"},
        {"bleeding.threshold", "predefined threshold"},
        {"bleeding.noise_scale", "Perlin noise"},
        {"bleeding.color_deep", "colour gradient"},
        {"bleeding.noise_strength", "paper's figure 7b"},
        {"bleeding.gravity_bias", "as in the paper"},
        {"bleeding.coagulation_time", "within a short period"},
        {"bleeding.color_thin", "colour gradient"},
        {"bleeding.thickness", "bump mapping"},
        {"bleeding.gloss", "wet surface"},
        {"vessels.vessel_low", "band pass"},
        {"vessels.vessel_high", "band pass"},
        {"vessels.vessel_strength", "as in the paper"},
        {"vessels.fat_low", "paper's future work"},
        {"vessels.fat_high", "paper's future work"},
        {"vessels.smoothing", "Gaussian filter"},
        {"vessels.region", "region of influence"},
        {"vessels.vessel_threshold", "density threshold"},
        {"cautery.cut_temperature", "temperature threshold"},
        {"cautery.model", "bio-heat equation"},
        {"cautery.heat_rate", "proportional to"},
        {"cautery.heat_spread", "radial expansion"},
        {"cautery.diffusivity", "bio-heat equation"},
        {"cautery.perfusion", "bio-heat equation"},
        {"smoke.keying.luma_low", "luminance threshold"},
        {"smoke.keying.luma_high", "luminance threshold"},
        {"smoke.keying.key_color", "its filter"},
        {"smoke.keying.chroma_low", "chroma threshold"},
        {"smoke.keying.chroma_high", "chroma threshold"},
        {"smoke.keying.noise_scale", "Perlin noise"},
        {"smoke.keying.noise_strength", "Perlin noise"},
        {"smoke.plume.fat_gain", "future work"},
        {"smoke.haze.accumulation", "environmental smoke"},
        {"smoke.haze.ventilation", "ventilation capacity"},
        {"smoke.particles.rate", "fat particles"},
    };
    for (const auto& [key, term] : terms) {
        const ParameterEntry& entry = parameters()[parameters().find(key)];
        EXPECT_NE(entry.tip.find(term), std::string::npos) << entry.tip;
        EXPECT_NE(entry.tip.find("paper"), std::string::npos) << entry.tip;
    }
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
                  "clipboard: /vessels: \"vessels\" is not in the text; it contains no group of parameters"});
    EXPECT_EQ(faults("{\"bleeding\": null}").size(), 1U);
    EXPECT_EQ(faults(std::string(1 << 16, '[')).size(), 1U);
    EXPECT_EQ(faults("\xff\xfe").size(), 1U);
    EXPECT_EQ(faults("").size(), 1U);
}

}  // namespace
}  // namespace lapfx::app
