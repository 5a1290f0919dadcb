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

void declare_gallery(CLI::App& app, RunGallery run) {
    auto o = std::make_shared<GalleryOptions>();
    CLI::App* verb = app.add_subcommand("gallery", "Show the widgets of the user interface, each in all its states");
    verb->add_option("--page", o->page, "The page to show")
        ->option_text(gallery_page_names("|"))
        ->capture_default_str();
    verb->add_option("--theme", o->theme, "Colours of the user interface")
        ->option_text("dark|light")
        ->capture_default_str();
    verb->add_option("--scale", o->scale,
                     "Scale of the user interface, 0.75 to 3; default: that of the screen, for files 1")
        ->option_text("NUMBER")
        ->check(finite_number())
        ->check(CLI::Range(0.75, 3.0));
    verb->add_option("--size", o->size, "Size in pixels; of a window, at scale 1")
        ->option_text("WxH")
        ->capture_default_str();
    verb->add_flag("--bare", o->bare, "The page alone, without the list of pages and the switches");
    verb->add_flag("--reduced-motion", o->reduced_motion, "Nothing blinks or moves by itself");
    verb->add_option("--screenshot", o->screenshot, "Write a PNG instead of opening a window")->option_text("FILE");
    verb->add_option("--dump", o->dump,
                     "Write all widgets with names, values and places instead of opening a window: .json, or one line "
                     "per widget")
        ->option_text("FILE");
    verb->add_option("--focus", o->focus, "In these files the widget with this path has the keyboard")
        ->option_text("PATH");
    verb->add_option("--backend", o->backend, "For --screenshot: the OpenGL that draws; auto is EGL, else OSMesa")
        ->option_text("egl|osmesa|auto")
        ->capture_default_str();
    verb->add_option("--dump-on-close", o->dump_on_close, "Like --dump, but when the window is closed")
        ->option_text("FILE");
    verb->add_flag("--statistics", o->statistics,
                   "Print a line on stderr for every frame of the window, and why it was drawn");
    verb->footer("Example:\n  lapfx gallery --page Text --scale 2 --theme light --screenshot text.png");
    verb->callback([o, run = std::move(run)] { run(*o); });
}

void add_gallery(CLI::App& app) {
    declare_gallery(app, [](const GalleryOptions&) { start_program_of("gallery"); });
}

}  // namespace lapfx::commands
