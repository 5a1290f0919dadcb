// lapfx gallery: the UI toolkit's widgets in a window, as a picture, or as the tree that tests and screen readers see.
// What shows them is a program of its own, lapfx_gallery (tests/gallery), so that the product is built without it.
#include "commands/gallery.h"

#include <memory>
#include <utility>

#include "commands/command.h"
#include "commands/gallery_pages.h"
#include "commands/options.h"
#include "commands/start_beside.h"

namespace lapfx::commands {

std::string gallery_page_names(const std::string& separator) {
    std::string names;
    for (const std::string_view page : gallery_pages) names += (names.empty() ? "" : separator) + std::string(page);
    return names;
}

Verb gallery_verb(RunGallery run) {
    const auto o = std::make_shared<GalleryOptions>();
    Verb verb{.name = "gallery",
              .help = "Show the widgets of the user interface, each in all its states",
              .footer = "Example:\n  lapfx gallery --page Text --scale 2 --theme light --screenshot text.png",
              .run = [o, run = std::move(run)] { run(*o); }};
    verb.option("--page", gallery_page_names("|"), "The page to show", &o->page, {.shows_default = true});
    verb.option("--theme", "dark|light", "Colours of the user interface", &o->theme, {.shows_default = true});
    verb.option("--scale", "NUMBER", "Scale of the user interface, 0.75 to 3; default: that of the screen, for files 1",
                &o->scale, {.range = Range{0.75, 3.0}});
    verb.option("--size", "WxH", "Size in pixels; of a window, at scale 1", &o->size, {.shows_default = true});
    verb.flag("--bare", "The page alone, without the list of pages and the switches", &o->bare);
    verb.flag("--reduced-motion", "Nothing blinks or moves by itself", &o->reduced_motion);
    verb.option("--screenshot", "FILE", "Write a PNG instead of opening a window", &o->screenshot);
    verb.option("--dump", "FILE",
                "Write all widgets with names, values and places instead of opening a window: .json, or one line "
                "per widget",
                &o->dump);
    verb.option("--focus", "PATH", "In these files the widget with this path has the keyboard", &o->focus);
    verb.option("--backend", "egl|osmesa|auto", "For --screenshot: the OpenGL that draws; auto is EGL, else OSMesa",
                &o->backend, {.shows_default = true});
    verb.option("--dump-on-close", "FILE", "Like --dump, but when the window is closed", &o->dump_on_close);
    verb.flag("--statistics", "Print a line on stderr for every frame of the window, and why it was drawn",
              &o->statistics);
    return verb;
}

Verb gallery_verb() {
    return gallery_verb([](const GalleryOptions&) { start_program_of("gallery"); });
}

}  // namespace lapfx::commands
