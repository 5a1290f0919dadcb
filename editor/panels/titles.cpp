#include "panels/titles.h"

#include "lapfx/tool.h"
#include "lapfx/view.h"

namespace lapfx::panels {

std::span<const std::string_view> action_titles() {
    static constexpr auto titles = titles_of(tool_actions);
    return titles;
}

std::span<const std::string_view> overlay_titles() {
    static constexpr auto titles = titles_of(overlays);
    return titles;
}

}  // namespace lapfx::panels
