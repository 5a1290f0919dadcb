// The options of `lapfx gallery`: declared once, for `lapfx` and for the program that shows it (tests/gallery).
#pragma once

#include <functional>
#include <string>

#include "commands/command_line.h"

namespace lapfx::commands {

struct GalleryOptions {
    std::string screenshot, dump, dump_on_close, page = "Overview", theme = "dark", size = "1280x800", backend = "auto",
                                                 focus;
    float scale = 0;
    bool bare = false, reduced_motion = false, statistics = false;
};

/// The names of all pages in their order, with `separator` between them.
std::string gallery_page_names(const std::string& separator);

using RunGallery = std::function<void(const GalleryOptions& options)>;

/// The verb, which calls `run`.
Verb gallery_verb(RunGallery run);

}  // namespace lapfx::commands
