// Notes: text of many lines, wrapped at the width there is, scrolled up and down.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct TextAreaOptions {
    std::string_view placeholder = {};
    std::string_view tip = {};
    Size width = {SizeKind::grow, 1};
    float lines = 5;  ///< that are seen at once
    std::size_t bytes = 1 << 20;
    bool read_only = false;
    bool monospace = false;
};

/// As text_field(), but Enter makes a line and Ctrl+Enter commits. Three presses take a line.
Edit text_area(Ui& ui, std::string_view label, std::string& text, const TextAreaOptions& options = {});

}  // namespace lapfx::ui
