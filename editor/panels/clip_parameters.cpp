#include "panels/clip_parameters.h"

namespace lapfx::panels {

const Table& clip_table() {
    static const Table& table = *preset_table().find("smoke")->find("clips");
    return table;
}

const Table& keying_table() {
    static const Table& table = *preset_table().find("smoke")->find("keying");
    return table;
}

ui::FileRequest clip_request(std::string title, bool many) {
    return {.task = many ? ui::FileTask::open_many : ui::FileTask::open,
            .title = std::move(title),
            .filters = {{"Smoke videos", {".mp4", ".mov", ".webm", ".mkv", ".avi", ".m4v", ".mpg", ".ogv", ".gif"}},
                        {"Images", {".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tif"}}}};
}

}  // namespace lapfx::panels
