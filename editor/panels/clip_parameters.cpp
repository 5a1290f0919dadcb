#include "panels/clip_parameters.h"

#include <algorithm>

#include "app/base/file_filters.h"

namespace lapfx::panels {

const Table& clip_table() {
    static const Table& table = *preset_table().find("smoke")->find("clips");
    return table;
}

const Table& keying_table() {
    static const Table& table = *preset_table().find("smoke")->find("keying");
    return table;
}

bool is_threshold(std::string_view key) {
    return key.starts_with("luma_") || key.starts_with("chroma_") || key == "key_color";
}

NotTaken not_taken(const SmokeParameters& smoke, const app::ClipShelf& shelf, std::string_view key) {
    constexpr std::string_view keying = "smoke.keying.";
    if (!key.starts_with(keying) || shelf.selected >= smoke.clips.size()) return {};
    const app::ClipFacts& facts = shelf.of(shelf.selected);
    if (is_threshold(key.substr(keying.size())) && facts.known && facts.report.alpha)
        return {
            ": own opacity, no thresholds",
            "The selected clip has its own opacity, which is used instead of thresholds. Click to see it in Keying"};
    if (!smoke.clips[shelf.selected].own_keying) return {};
    const bool none =
        std::all_of(smoke.clips.begin(), smoke.clips.end(), [](const SmokeClip& c) { return c.own_keying; });
    return {
        ": change its own keying",
        none ? "Every clip has its own keying: what is set here changes nothing. Click for the one of the selected clip"
             : "The selected clip has its own keying. What is set here is for the clips without one. Click for "
               "the one that it takes"};
}

ui::FileRequest clip_request(std::string title, bool many) {
    return {.task = many ? ui::FileTask::open_many : ui::FileTask::open,
            .title = std::move(title),
            .filters = app::clip_filters("Smoke videos")};
}

}  // namespace lapfx::panels
