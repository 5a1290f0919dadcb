#include "commands/options.h"

#include <algorithm>
#include <iostream>

#include "commands/say.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/organ_report.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/smoke_notes.h"
#include "lapfx/authoring/touch_notes.h"
#include "output/files.h"
#include "output/render_job.h"

namespace lapfx::commands {

Error wrong_option(const std::string& option, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = "", .place = option, .reason = reason}};
}

glm::ivec2 parse_size(const std::string& text) {
    const std::size_t by = std::min(text.find('x'), text.size());
    const std::string width = text.substr(0, by), height = text.substr(std::min(by + 1, text.size()));
    const auto is_side = [](const std::string& digits) {
        return !digits.empty() && digits.size() <= 5 && digits.find_first_not_of("0123456789") == std::string::npos;
    };
    if (!is_side(width) || !is_side(height))
        throw wrong_option("--size", "\"" + text + "\" is not WIDTHxHEIGHT in pixels, such as 1280x1024");
    const glm::ivec2 size(std::stoi(width), std::stoi(height));
    if (const std::string fault = output::size_fault(size); !fault.empty()) throw wrong_option("--size", fault);
    return size;
}

void check_picture_name(const std::string& option, const std::string& file) {
    const FileFormat* const format = format_named(file);
    if (format == nullptr || format->content != Content::picture || !format->written)
        throw wrong_option(option, "\"" + file + "\" is not a .png");
}

void check_output(const std::string& option, const std::filesystem::path& output) {
    if (output.empty()) return;
    output::require_replaceable(output);
    claim_output(option, output);
}

void print_warnings(const Preview& preview) {
    for (const std::string& warning : report(preview.organ()).warnings) warn(warning);
}

void print_plate_note(const Scene& scene, const Preview& preview) {
    if (scene.plate.use) note("plate: " + preview.organ().name);
}

void print_smoke_notes(const Scene& scene, const Preset& preset) {
    if (std::none_of(scene.events.begin(), scene.events.end(), [](const ToolContact& c) { return c.hot(); })) return;
    for (const std::string& text : smoke_notes(preset.smoke)) note(text);
}

void print_touch_notes(const Scene& scene, const Preview& preview) {
    for (const std::string& text : touch_notes(preview.organ(), scene.events)) note(text);
}

void print_clip_warnings(const Preview& preview) {
    for (const ClipStatus& clip : preview.clips())
        if (!clip.warning.empty()) warn(clip.file + ": " + clip.warning);
}

void warn_after_end(const Scene& scene, double at) {
    if (at > scene.duration)
        std::cerr << "lapfx: warning: --at " << at << " s is after the scene's end at " << scene.duration << " s\n";
}

}  // namespace lapfx::commands
