#include "panels/clip_parameters.h"

#include "app/base/file_filters.h"
#include "lapfx/preset.h"

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
            .filters = app::clip_filters("Smoke videos")};
}

}  // namespace lapfx::panels
