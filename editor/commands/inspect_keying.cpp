// Suggested keying of a clip, for people and as JSON.
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "commands/inspect.h"
#include "commands/say.h"
#include "lapfx/authoring/printable.h"
#include "lapfx/authoring/suggest.h"
#include "lapfx/preset.h"

namespace lapfx::commands {

namespace {

/// The lines for the clip's entry in a preset, as write_preset() would write them; keys without a suggestion keep their
/// defaults.
std::string preset_lines(const KeyingSuggestion& found) {
    Preset preset;
    SmokeClip& suggested = preset.smoke.clips.emplace_back();
    suggested.file = "clip";
    found.apply(suggested);
    const auto written = nlohmann::ordered_json::parse(write_preset(preset));
    const auto& clip = written.at("smoke").at("clips").at(0);
    nlohmann::ordered_json keying;
    for (const char* key : {"luma_low", "luma_high", "key_color", "chroma_low", "chroma_high", "spill"})
        keying[key] = clip.at("keying").at(key);
    std::string lines = "\"polarity\": " + clip.at("polarity").dump();
    if (suggested.crop != ClipCrop{}) lines += ",\n\"crop\": " + clip.at("crop").dump();
    if (suggested.edge_fade > 0.0) lines += ",\n\"edge_fade\": " + clip.at("edge_fade").dump();
    if (!suggested.masks.empty()) lines += ",\n\"masks\": " + clip.at("masks").dump();
    return lines + ",\n\"keying\": " + keying.dump(2) + "\n";
}

}  // namespace

void inspect_keying(const std::filesystem::path& file) {
    const KeyingSuggestion found = suggest_keying(file);
    if (found.alpha) {  // nothing to paste: it would have no effect
        std::cout << "  keying              " << printable(found.reason) << '\n';
        return;
    }
    const bool doubtful = found.confidence < 0.5;
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", found.confidence);
    std::cout << "  keying              " << printable(found.reason) << '\n'
              << "  confidence          " << text << (doubtful ? ", check it before use\n" : "\n")
              << preset_lines(found);
    if (doubtful)
        warn(file.string() + ": this keying is a guess; check the clip with it before you use it in a preset");
}

}  // namespace lapfx::commands
