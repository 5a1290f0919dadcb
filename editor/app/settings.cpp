#include "app/settings.h"

#include <algorithm>

namespace lapfx::app {

void Settings::note_recent(const std::string& file) {
    constexpr std::size_t most = 12;
    std::erase(recent, file);
    recent.insert(recent.begin(), file);
    if (recent.size() > most) recent.resize(most);
}

}  // namespace lapfx::app
