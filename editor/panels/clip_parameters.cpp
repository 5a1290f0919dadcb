#include "panels/clip_parameters.h"

#include "app/file_filters.h"
#include "app/tuning.h"

namespace lapfx::panels {

const Table& clip_table() {
    static const Table& table = *preset_table().find("smoke")->find("clips");
    return table;
}

const Table& keying_table() {
    static const Table& table = *preset_table().find("smoke")->find("keying");
    return table;
}

const SmokeClip& saved_clip(app::Editor& editor, std::size_t number) {
    static const SmokeClip standard;
    editor.tuning().follow();
    const SmokeClip* const saved = editor.tuning().saved_clip(number);
    return saved != nullptr ? *saved : standard;
}

const KeyingParameters& saved_keying(app::Editor& editor, std::size_t number) {
    const SmokeParameters& smoke = editor.document.preset().smoke;
    const SmokeClip& saved = saved_clip(editor, number);
    const bool own = number < smoke.clips.size() && smoke.clips[number].own_keying && saved.own_keying;
    return own ? saved.keying : editor.tuning().saved().preset.smoke.keying;
}

ui::FileRequest clip_request(std::string title, bool many) {
    return {.task = many ? ui::FileTask::open_many : ui::FileTask::open,
            .title = std::move(title),
            .filters = app::clip_filters("Smoke videos")};
}

}  // namespace lapfx::panels
