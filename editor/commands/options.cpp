#include "commands/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <regex>

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
    static const std::regex pattern(R"((\d{1,5})x(\d{1,5}))");
    std::smatch match;
    if (!std::regex_match(text, match, pattern))
        throw wrong_option("--size", "\"" + text + "\" is not WIDTHxHEIGHT in pixels, such as 1280x1024");
    const glm::ivec2 size(std::stoi(match[1]), std::stoi(match[2]));
    if (const std::string fault = output::size_fault(size); !fault.empty()) throw wrong_option("--size", fault);
    return size;
}

CLI::Validator number_above_0() {
    return {[](const std::string& text) {
                double value = 0.0;
                return CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0.0
                           ? ""
                           : "\"" + text + "\" is not a number above 0";
            },
            "NUMBER"};
}

CLI::Validator whole_number() {
    return {[](const std::string& text) {
                std::uint32_t value = 0;
                const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
                return code == std::errc() && end == text.data() + text.size()
                           ? ""
                           : "\"" + text + "\" is not a whole number from 0 to 4294967295";
            },
            "NUMBER"};
}

CLI::Validator finite_number() {
    return {[](const std::string& text) {
                double value = 0.0;
                return CLI::detail::lexical_cast(text, value) && std::isfinite(value)
                           ? ""
                           : "\"" + text + "\" is not a number";
            },
            "NUMBER"};
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
