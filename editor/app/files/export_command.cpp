#include "app/files/export_command.h"

#include <array>
#include <charconv>

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

/// In quotes for a shell, where it needs them.
std::string quoted(const std::string& text) {
    if (!text.empty() &&
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./%") ==
            std::string::npos)
        return text;
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

/// The shortest text that reads back as the same number: even a slightly earlier time would change some pixels.
std::string number(double value) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
}

}  // namespace

std::string render_command(const ExportForm& form, const document::Document& document, Overlay overlay,
                           const fs::path& reference) {
    std::vector<Fault> faults;
    const auto refuse = [&faults](const char* reason) {
        faults.push_back({.file = "", .place = "", .reason = reason});
    };
    if (!form.renders()) refuse("lapfx render makes pictures, sequences and videos");
    if (document.scene_file().empty() || document.scene_unsaved())
        refuse("the scene is not saved: a command line reads it from its file");
    if (document.preset_unsaved()) refuse("the preset is not saved: a command line reads it from its file");
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    std::error_code error;
    const auto path = [&](const fs::path& file) {
        return quoted(fs::absolute(file, error).lexically_normal().string());
    };
    std::string line = "lapfx render " + path(document.scene_file());
    if (!document.preset_file().empty()) line += " --preset " + path(document.preset_file());
    line += " --size " + std::to_string(form.px().x) + "x" + std::to_string(form.px().y);
    if (form.what() == OutputKind::picture)
        line += " --at " + number(form.at);
    else
        line += " --fps " + number(form.fps) + " --from " + number(form.from) + " --to " + number(form.to);
    if (form.overlay && overlay != Overlay::none) line += " --overlay " + std::string(row_of(overlay).key);
    if (form.what() == OutputKind::video) {
        const output::CodecRow& codec = output::row_of(form.coded());
        line += " --codec " + std::string(codec.key);
        if (!codec.lossless)
            line += " --quality " + std::string(output::row_of(static_cast<output::Quality>(form.quality)).key);
    }
    if (!reference.empty()) line += " --beside " + path(reference);
    if (form.amounts) line += " --amounts " + path(form.amounts_file);
    return line + " -o " + path(form.file());
}

}  // namespace lapfx::app
