#include "ui/text/fonts.h"

#include <algorithm>

#include "ui/text/run_cache.h"
#include "ui/text/shaper.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {

float Run::x_of(std::size_t byte) const {
    const auto after = std::upper_bound(stops.begin(), stops.end(), byte,
                                        [](std::size_t value, const CaretStop& stop) { return value < stop.byte; });
    return after == stops.begin() ? 0 : std::prev(after)->x;
}

std::size_t Run::byte_at(float x) const {
    const auto after = std::lower_bound(stops.begin(), stops.end(), x,
                                        [](const CaretStop& stop, float value) { return stop.x < value; });
    if (after == stops.begin()) return 0;
    if (after == stops.end()) return stops.empty() ? 0 : stops.back().byte;
    const auto before = std::prev(after);
    return x - before->x < after->x - x ? before->byte : after->byte;
}

std::size_t Run::bytes_within(float most) const {
    const auto after = std::upper_bound(stops.begin(), stops.end(), most,
                                        [](float value, const CaretStop& stop) { return value < stop.x; });
    return after == stops.begin() ? 0 : std::prev(after)->byte;
}

struct Fonts::Implementation {
    explicit Implementation(const FontOptions& options) : faces(options) {}

    Faces faces;
    Glyphs glyphs;
    Shaper shaper{faces, glyphs};
    RunCache runs;
};

namespace {

/// The text cut to at most max_run_bytes, before a code point rather than in the middle of it.
std::string_view limited(std::string_view text) {
    return text.substr(0, code_point_at(text, max_run_bytes));
}

}  // namespace

Fonts::Fonts(const FontOptions& options) : implementation_(std::make_unique<Implementation>(options)) {}
Fonts::~Fonts() = default;

const Run& Fonts::run(std::string_view text, const TextStyle& style) {
    Implementation& self = *implementation_;
    text = limited(text);
    const StyleKey key(style);
    if (const Run* known = self.runs.find(text, key.bits())) return *known;
    Run& run = self.runs.add(text, key.bits());
    self.shaper.shape(text, key, run);
    run.metrics = self.faces.base(key.base).metrics(key.size());
    return run;
}

LineMetrics Fonts::metrics(const TextStyle& style) {
    const StyleKey key(style);
    return implementation_->faces.base(key.base).metrics(key.size());
}

void Fonts::next_frame() {
    Implementation& self = *implementation_;
    if (self.glyphs.full()) {
        // What is still wanted comes back as it is asked for. Runs that lack glyphs go with all the others.
        self.glyphs.clear();
        self.runs.clear();
    }
    self.runs.next_frame();
}

bool Fonts::full() const {
    return implementation_->glyphs.full();
}

const Atlas& Fonts::atlas() const {
    return implementation_->glyphs.atlas();
}

void Fonts::clear_dirty() {
    implementation_->glyphs.clear_dirty();
}

std::string Fonts::file_for(char32_t codepoint, const TextStyle& style) {
    const Face* face = implementation_->faces.face_of(codepoint, StyleKey(style).base);
    return face == nullptr ? std::string() : face->file();
}

}  // namespace lapfx::ui
