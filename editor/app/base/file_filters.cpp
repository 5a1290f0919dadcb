#include "app/base/file_filters.h"

namespace lapfx::app {

ui::FileFilter mesh_filter() {
    return {"Meshes", extensions(Content::mesh)};
}

ui::FileFilter document_filter() {
    return {"Presets and scenes", extensions(Content::document)};
}

ui::FileFilter picture_filter() {
    return {"Images", extensions(Content::picture)};
}

std::vector<ui::FileFilter> clip_filters(std::string videos) {
    return {{std::move(videos), extensions(Content::video)}, picture_filter()};
}

std::vector<ui::FileFilter> open_filters() {
    std::vector<ui::FileFilter> kinds{document_filter(), mesh_filter()};
    for (ui::FileFilter& filter : clip_filters("Videos")) kinds.push_back(std::move(filter));
    ui::FileFilter all{"Everything lapfx opens", {}};
    for (const ui::FileFilter& kind : kinds)
        all.extensions.insert(all.extensions.end(), kind.extensions.begin(), kind.extensions.end());
    kinds.insert(kinds.begin(), std::move(all));
    return kinds;
}

ui::FileFilter written_filter(std::string name, Content content) {
    return {std::move(name), extensions(content, true)};
}

}  // namespace lapfx::app
