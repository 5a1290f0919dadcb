#include "ui/text/shaper.h"

#include <algorithm>
#include <cmath>

#include "ui/value/utf8.h"

namespace lapfx::ui {

namespace {

char32_t shown(char32_t codepoint) {
    if (codepoint == U'\t') return U' ';
    return codepoint < 0x20 || (codepoint >= 0x7f && codepoint < 0xa0) ? replacement : codepoint;
}

/// Joiners, variation selectors, marks of direction and the like: HarfBuzz hides them, so no font needs them.
bool ignorable(char32_t c) {
    return c == 0xad || c == 0x34f || c == 0x61c || (c >= 0x180b && c <= 0x180f) || (c >= 0x200b && c <= 0x200f) ||
           (c >= 0x202a && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || (c >= 0xfe00 && c <= 0xfe0f) ||
           c == 0xfeff || (c >= 0xe0000 && c <= 0xe0fff);
}

bool common(hb_script_t script) {
    return script == HB_SCRIPT_COMMON || script == HB_SCRIPT_INHERITED || script == HB_SCRIPT_UNKNOWN;
}

Rect around(std::span<const Instance> glyphs) {
    if (glyphs.empty()) return {};
    Rect all{glyphs[0].x, glyphs[0].y, 0, 0};
    float right = all.x, bottom = all.y;
    for (const Instance& glyph : glyphs) {
        all.x = std::min(all.x, glyph.x), all.y = std::min(all.y, glyph.y);
        right = std::max(right, glyph.x + glyph.w), bottom = std::max(bottom, glyph.y + glyph.h);
    }
    all.w = right - all.x, all.h = bottom - all.y;
    return all;
}

}  // namespace

Shaper::Shaper(Faces& faces, Glyphs& glyphs) : faces_(faces), glyphs_(glyphs), buffer_(hb_buffer_create()) {
    letters_.reserve(256);
}

void Shaper::shape(std::string_view text, StyleKey style, Run& run) {
    read(text);
    choose_faces(style.base);
    choose_scripts();
    pen_ = 0;
    run.stops.push_back({0, 0});
    for (std::size_t first = 0, last = 0; first < letters_.size(); first = last) {
        const Letter& letter = letters_[first];
        for (last = first + 1;
             last < letters_.size() && letters_[last].face == letter.face && letters_[last].script == letter.script;) {
            ++last;
        }
        if (letter.face != nullptr) {
            place(first, last, style, run);
        } else {
            for (std::size_t i = first; i < last; ++i) place_box(letters_[i], style, run);
        }
    }
    run.width = std::max(static_cast<float>(pen_), run.stops.back().x);
    run.ink = around(run.glyphs);
    if (!text.empty()) run.stops.push_back({static_cast<std::uint32_t>(text.size()), run.width});
}

void Shaper::read(std::string_view text) {
    letters_.clear();
    CharacterBreaks breaks;
    for (std::size_t at = 0; at < text.size();) {
        const Decoded decoded = decode(text.substr(at));
        letters_.push_back({shown(decoded.codepoint), static_cast<std::uint32_t>(at), nullptr, HB_SCRIPT_COMMON,
                            breaks.before(decoded.codepoint)});
        at += decoded.bytes;
    }
}

void Shaper::choose_faces(std::uint8_t base) {
    // A letter and its marks come from one face if any has them all: only then do the marks find their places.
    constexpr std::size_t most_looked_at = 8;  // endless towers of marks would take for ever
    for (std::size_t first = 0, last = 0; first < letters_.size(); first = last) {
        for (last = first + 1; last < letters_.size() && !letters_[last].starts_cluster;) ++last;
        const std::size_t looked_at = std::min(last, first + most_looked_at);
        const auto has_all = [&](const Face& face) {
            return std::all_of(letters_.begin() + first, letters_.begin() + looked_at, [&](const Letter& letter) {
                return ignorable(letter.codepoint) || face.has(letter.codepoint);
            });
        };
        Face* whole = nullptr;
        if (has_all(faces_.base(base))) whole = &faces_.base(base);
        for (std::size_t i = first; i < looked_at && whole == nullptr; ++i) {
            Face* face = faces_.face_of(letters_[i].codepoint, base);
            if (face != nullptr && has_all(*face)) whole = face;
        }
        for (std::size_t i = first; i < last; ++i) {
            const bool hidden = i > first && ignorable(letters_[i].codepoint);
            letters_[i].face = whole != nullptr && i < looked_at ? whole
                               : hidden                          ? letters_[i - 1].face
                                                                 : faces_.face_of(letters_[i].codepoint, base);
        }
    }
}

void Shaper::choose_scripts() {
    // Digits, spaces and signs go with the letters before them, at the start of the text with those after.
    hb_unicode_funcs_t* unicode = hb_unicode_funcs_get_default();
    hb_script_t current = HB_SCRIPT_INVALID;
    for (Letter& letter : letters_) {
        letter.script = hb_unicode_script(unicode, letter.codepoint);
        if (current == HB_SCRIPT_INVALID && !common(letter.script)) current = letter.script;
    }
    if (current == HB_SCRIPT_INVALID) current = HB_SCRIPT_LATIN;
    for (Letter& letter : letters_) {
        if (common(letter.script)) {
            letter.script = current;
        } else {
            current = letter.script;
        }
    }
}

void Shaper::apply_features(Face& face, hb_script_t script, bool tabular) {
    // No ligatures and no contextual forms: every character stays as it was typed and keeps its place for the caret. No
    // kerning in tabular text: it would move the digits again.
    const auto feature = [](hb_tag_t tag, bool on) {
        return hb_feature_t{tag, on ? 1U : 0U, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
    };
    const hb_feature_t features[] = {
        feature(HB_TAG('l', 'i', 'g', 'a'), false), feature(HB_TAG('c', 'l', 'i', 'g'), false),
        feature(HB_TAG('c', 'a', 'l', 't'), false), feature(HB_TAG('k', 'e', 'r', 'n'), !tabular),
        feature(HB_TAG('t', 'n', 'u', 'm'), tabular)};
    hb_buffer_set_content_type(buffer_.get(), HB_BUFFER_CONTENT_TYPE_UNICODE);
    hb_buffer_set_direction(buffer_.get(), HB_DIRECTION_LTR);
    hb_buffer_set_script(buffer_.get(), script);
    hb_buffer_set_language(buffer_.get(), hb_language_get_default());
    hb_buffer_set_flags(buffer_.get(), HB_BUFFER_FLAG_DO_NOT_INSERT_DOTTED_CIRCLE);
    hb_shape(face.shaping(), buffer_.get(), features, std::size(features));
}

float Shaper::widest_digit(Face& face) {
    if (face.widest_digit < 0) {
        hb_buffer_clear_contents(buffer_.get());
        for (char digit = '0'; digit <= '9'; ++digit)
            hb_buffer_add(buffer_.get(), static_cast<unsigned char>(digit), 0);
        apply_features(face, HB_SCRIPT_LATIN, true);
        unsigned count = 0;
        const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer_.get(), &count);
        for (unsigned i = 0; i < count; ++i) face.widest_digit = std::max(face.widest_digit, positions[i].x_advance);
    }
    return static_cast<float>(face.widest_digit);
}

void Shaper::place(std::size_t first, std::size_t last, StyleKey style, Run& run) {
    Face& face = *letters_[first].face;
    const double scale = face.scale(style.size());
    const int phases = face.phases(style.size());
    const float digit_width = style.tabular ? widest_digit(face) : 0;
    hb_buffer_clear_contents(buffer_.get());
    for (std::size_t i = first; i < last; ++i) {
        hb_buffer_add(buffer_.get(), letters_[i].codepoint, static_cast<unsigned>(i));
    }
    apply_features(face, letters_[first].script, style.tabular);

    unsigned count = 0;
    const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(buffer_.get(), &count);
    const hb_glyph_position_t* positions = hb_buffer_get_glyph_positions(buffer_.get(), &count);
    double widening = 0;  // of the digit that the glyphs belong to: half before them, half after
    for (unsigned i = 0; i < count; ++i) {
        const Letter& letter = letters_[infos[i].cluster];
        if (i == 0 || infos[i].cluster != infos[i - 1].cluster) {
            add_stop(letter, run);
            const bool digit = style.tabular && letter.codepoint >= U'0' && letter.codepoint <= U'9';
            widening = digit ? (static_cast<double>(digit_width) - positions[i].x_advance) * scale : 0;
            pen_ += widening / 2;
        }
        const double steps = std::floor((pen_ + positions[i].x_offset * scale) * phases + 0.5);
        const int x = static_cast<int>(std::floor(steps / phases)), phase = static_cast<int>(steps) - x * phases;
        const int y = static_cast<int>(std::floor(-positions[i].y_offset * scale + 0.5));
        if (const Glyph* glyph = glyphs_.find(face, infos[i].codepoint, style.quarters, phase)) add(*glyph, x, y, run);
        pen_ += positions[i].x_advance * scale;
        if (i + 1 == count || infos[i + 1].cluster != infos[i].cluster) pen_ += widening / 2;
    }
}

void Shaper::place_box(const Letter& letter, StyleKey style, Run& run) {
    add_stop(letter, run);
    if (ignorable(letter.codepoint)) return;
    const int x = static_cast<int>(std::floor(pen_ + 0.5));
    if (const Glyph* glyph = glyphs_.box(letter.codepoint, style.quarters)) add(*glyph, x, 0, run);
    pen_ += Glyphs::box_advance(letter.codepoint, style.quarters);
}

void Shaper::add_stop(const Letter& letter, Run& run) {
    if (!letter.starts_cluster || letter.byte == 0) return;
    run.stops.push_back({letter.byte, std::max(static_cast<float>(pen_), run.stops.back().x)});
}

void Shaper::add(const Glyph& glyph, int x, int y, Run& run) {
    if (glyph.width == 0) return;
    Instance& instance = run.glyphs.emplace_back();
    instance.x = static_cast<float>(x + glyph.left), instance.y = static_cast<float>(y - glyph.top);
    instance.w = static_cast<float>(glyph.width), instance.h = static_cast<float>(glyph.height);
    instance.kind = InstanceKind::glyph;
    instance.uv[0] = glyph.u, instance.uv[1] = glyph.v;
    instance.uv[2] = static_cast<std::uint16_t>(glyph.u + glyph.width);
    instance.uv[3] = static_cast<std::uint16_t>(glyph.v + glyph.height);
}

}  // namespace lapfx::ui
