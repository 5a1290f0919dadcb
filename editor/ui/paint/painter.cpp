#include "ui/paint/painter.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "ui/value/utf8.h"

namespace lapfx::ui {

namespace {

constexpr std::uint32_t most_clips = 256;  // a batch has no more: an instance's index has 8 bits
constexpr std::string_view ellipsis = "\xE2\x80\xA6";

std::uint8_t whole_byte(float value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}
std::uint16_t whole_word(float value) {
    return static_cast<std::uint16_t>(std::clamp(value + 0.5F, 0.0F, 65535.0F));
}

void put_color(std::uint16_t (&uv)[4], int at, Color c) {
    uv[at] = static_cast<std::uint16_t>(c.r | c.g << 8);
    uv[at + 1] = static_cast<std::uint16_t>(c.b | c.a << 8);
}

}  // namespace

Painter::Painter(DrawList& list, Fonts& fonts, const Theme& theme, float scale)
    : list_(list), fonts_(fonts), theme_(theme), scale_(scale), clips_(list.clip_stack), elided_(list.elided) {}

TextStyle Painter::text_style(float relative_size, Weight weight) const {
    return {.size = em(relative_size), .weight = weight};
}

TextStyle Painter::number_style() const {
    return {.size = em(1), .tabular = true};
}

// --- nodes ---

bool Painter::drawn_plainly(std::uint32_t& first) {
    first = node_.instances;
    if (pictures_ || list_.clears.size() != node_.clears) return false;
    const std::size_t opened = list_.batches.size() - node_.batches;
    if (opened > 1 || (opened == 1 && list_.batches.back().first != first)) return false;
    if (first == instances()) return true;
    const std::uint8_t clip = clip_index();
    return std::all_of(list_.instances.begin() + first, list_.instances.end(),
                       [clip](const Instance& i) { return i.clip == clip; });
}

std::uint32_t Painter::copy(std::span<const Instance> from) {
    if (from.empty()) return instances();
    const std::uint8_t clip = clip_index();
    const std::uint32_t first = instances();
    Instance* to = list_.instances.add(from);
    for (const Instance* end = to + from.size(); to != end; ++to) to->clip = clip;
    return first;
}

bool Painter::keep_places(std::span<const Instance> of) {
    if (of.empty()) return true;
    if (of.front().clip != clip_index()) return false;
    list_.instances.leave(of.size());
    return true;
}

// --- batches and clips ---

void Painter::start(glm::ivec2 size) {
    list_.reset(size);
    clips_.clear();
    clips_.push_back({.rect = {0, 0, static_cast<float>(size.x), static_cast<float>(size.y)}});
}

void Painter::set_clip(const Rect& rect) {
    if (clips_.back().rect != rect) clips_.back() = {.rect = rect};
}

void Painter::push_clip(const Rect& rect) {
    const ClipLevel& outer = clips_.back();
    const Rect inner = intersect(rect, outer.rect);
    clips_.push_back(inner == outer.rect ? ClipLevel(outer) : ClipLevel{.rect = inner});
}

void Painter::pop_clip() {
    assert(clips_.size() > 1);
    clips_.pop_back();
}

/// Leaves a batch open that shows these images; 0: whatever it shows.
void Painter::need_batch(ImageHandle first, ImageHandle second) {
    pictures_ |= first != 0 || second != 0;
    if (!list_.batches.empty()) {
        ImageHandle(&open)[2] = list_.batches.back().images;
        const bool fits =
            (first == 0 || open[0] == 0 || open[0] == first) && (second == 0 || open[1] == 0 || open[1] == second);
        if (fits) {
            if (first != 0) open[0] = first;
            if (second != 0) open[1] = second;
            return;
        }
    }
    const auto count = static_cast<std::uint32_t>(list_.instances.size());
    if (!list_.batches.empty()) list_.batches.back().count = count - list_.batches.back().first;
    list_.batches.push_back(
        {.first = count, .first_clip = static_cast<std::uint32_t>(list_.clips.size()), .images = {first, second}});
}

/// The index of clip() in the table of the open batch. Opens a batch if there is none, or none with room.
std::uint8_t Painter::enter_clip() {
    ClipLevel& clip = clips_.back();
    if (list_.batches.empty()) need_batch(0, 0);
    if (list_.batches.back().clips == most_clips) {
        const Batch full = list_.batches.back();
        const auto count = static_cast<std::uint32_t>(list_.instances.size());
        list_.batches.back().count = count - full.first;
        list_.batches.push_back({.first = count,
                                 .first_clip = static_cast<std::uint32_t>(list_.clips.size()),
                                 .images = {full.images[0], full.images[1]}});
    }
    Batch& batch = list_.batches.back();
    clip.batch = list_.batches.size();
    clip.index = static_cast<std::uint8_t>(batch.clips++);
    list_.clips.push_back(clip.rect);
    return clip.index;
}

Instance& Painter::add(InstanceKind kind, Color color) {
    const std::uint8_t clip = clip_index();
    Instance& instance = list_.instances.add();
    instance.color = color;
    instance.kind = kind;
    instance.clip = clip;
    return instance;
}

void Painter::finish(const ImageStore* images) {
    assert(clips_.size() == 1);
    if (!list_.batches.empty()) {
        Batch& last = list_.batches.back();
        last.count = static_cast<std::uint32_t>(list_.instances.size()) - last.first;
    }
    list_.serials.push_back(fonts_.atlas().serial);
    for (const Batch& batch : list_.batches) {
        for (const ImageHandle image : batch.images) {
            const StoredImage* stored = images != nullptr ? images->find(image) : nullptr;
            if (stored != nullptr) list_.serials.push_back(stored->serial);
        }
    }
}

// --- shapes ---

namespace {

void place(Instance& instance, const Rect& rect) {
    instance.x = rect.x, instance.y = rect.y, instance.w = rect.w, instance.h = rect.h;
}

}  // namespace

void Painter::clear(const Rect& rect, Color color) {
    color.a = 255;
    list_.clears.push_back({rect, color});
}

void Painter::ground(const Rect& rect, Color color) {
    node_.bottom ? clear(intersect(rect, clip()), color) : fill(rect, color);
}

void Painter::fill(const Rect& rect, Color color, float radius) {
    if (color.a == 0 || hidden(rect)) return;
    Instance& instance = add(InstanceKind::fill, color);
    place(instance, rect);
    instance.radius = whole_byte(radius);
}

/// What is filled and framed, as most controls are, is one instance: half the pixels to shade, and no fill shines
/// through the smooth outer edge of its frame.
bool Painter::frame_last_fill(const Rect& rect, Color color, std::uint8_t border, std::uint8_t radius) {
    if (list_.batches.empty() || clips_.back().batch != list_.batches.size()) return false;
    if (list_.instances.size() == list_.batches.back().first || list_.instances.size() == node_.instances) return false;
    Instance& last = list_.instances.back();
    const bool same = last.kind == InstanceKind::fill && last.border == 0 && last.radius == radius &&
                      last.clip == clips_.back().index && last.x == rect.x && last.y == rect.y && last.w == rect.w &&
                      last.h == rect.h;
    if (!same) return false;
    put_color(last.uv, 0, last.color);
    last.uv[2] = 1;
    last.color = color;
    last.border = border;
    return true;
}

void Painter::frame(const Rect& rect, Color color, float width, float radius) {
    if (color.a == 0 || hidden(rect)) return;
    const float border = std::max(1.0F, whole(width));
    if (2 * border >= std::min(rect.w, rect.h)) return fill(rect, color, radius);
    if (frame_last_fill(rect, color, whole_byte(border), whole_byte(radius))) return;
    // A large one would have its whole empty middle shaded for nothing: four bars then.
    if (radius < 0.5F && rect.w * rect.h > 64 * 64) {
        Rect inside = rect;
        fill(inside.cut_top(border), color);
        fill(inside.cut_bottom(border), color);
        fill(inside.cut_left(border), color);
        fill(inside.cut_right(border), color);
        return;
    }
    Instance& instance = add(InstanceKind::fill, color);
    place(instance, rect);
    instance.radius = whole_byte(radius);
    instance.border = whole_byte(border);
}

void Painter::shadow(const Rect& rect, Color color, float softness, float radius) {
    if (color.a == 0 || hidden({rect.x - softness, rect.y - softness, rect.w + 2 * softness, rect.h + 2 * softness}))
        return;
    Instance& instance = add(InstanceKind::shadow, color);
    place(instance, rect);
    instance.uv[0] = whole_word(softness);
    instance.radius = whole_byte(radius);
}

void Painter::line(glm::vec2 from, glm::vec2 to, float width, Color color) {
    const glm::vec2 low = glm::min(from, to) - (width / 2 + 1), high = glm::max(from, to) + (width / 2 + 1);
    if (color.a == 0 || hidden({low.x, low.y, high.x - low.x, high.y - low.y})) return;
    Instance& instance = add(InstanceKind::line, color);
    instance.x = from.x, instance.y = from.y, instance.w = to.x, instance.h = to.y;
    instance.uv[0] = whole_word(width * 64);
}

void Painter::polyline(std::span<const glm::vec2> points, float width, Color color) {
    for (std::size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i], width, color);
}

void Painter::gradient(const Rect& rect, Color from, Color to, bool vertical) {
    if (hidden(rect)) return;
    Instance& instance = add(InstanceKind::gradient, from);
    place(instance, rect);
    put_color(instance.uv, 0, to);
    instance.uv[2] = vertical ? 1 : 0;
}

void Painter::checker(const Rect& rect, Color light, Color dark, float square) {
    if (hidden(rect)) return;
    Instance& instance = add(InstanceKind::checker, light);
    place(instance, rect);
    instance.uv[0] = whole_word(std::max(1.0F, square));
    put_color(instance.uv, 2, dark);
}

// --- pictures ---

void Painter::image(const Rect& rect, ImageHandle image, bool nearest, Color tint) {
    if (image == 0 || tint.a == 0 || hidden(rect)) return;
    need_batch(image, 0);
    Instance& instance = add(InstanceKind::image, tint);
    place(instance, rect);
    const bool turned = image < own_images;
    instance.uv[1] = turned ? 65535 : 0;
    instance.uv[2] = 65535;
    instance.uv[3] = turned ? 0 : 65535;
    instance.border = nearest ? 1 : 0;
}

void Painter::compare(const Rect& rect, ImageHandle first, ImageHandle second, const CompareLook& look) {
    if (first == 0 || second == 0 || hidden(rect)) return;
    need_batch(first, second);
    Instance& instance = add(InstanceKind::compare, {255, 255, 255, 255});
    place(instance, rect);
    const float turns = look.angle / (2 * std::numbers::pi_v<float>);
    instance.uv[0] = whole_word(look.position * 65535);
    instance.uv[1] = static_cast<std::uint16_t>(std::lround((turns - std::floor(turns)) * 65536));
    instance.uv[2] = glm::packHalf1x16(std::clamp(look.gain, 0.1F, 100.0F));
    instance.uv[3] = whole_word(look.mix * 65535);
    instance.radius = static_cast<std::uint8_t>(look.mode);
    instance.border = static_cast<std::uint8_t>((look.nearest ? 1 : 0) | (first < own_images ? 2 : 0) |
                                                (second < own_images ? 4 : 0));
}

// --- text ---

float Painter::text(const Rect& rect, std::string_view text, const TextStyle& style, Color color, Align align) {
    if (text.empty() || hidden(rect)) return 0;
    return this->text(rect, text, fonts_.run(text, style), style, color, align);
}

float Painter::text(const Rect& rect, std::string_view text, const Run& whole_run, const TextStyle& style, Color color,
                    Align align) {
    if (text.empty() || hidden(rect)) return 0;
    const Run* run = &whole_run;
    // Layout rounds to whole px, so half a px too much is no reason to cut.
    if (run->width > rect.w + 0.5F) {
        const float dots = fonts_.run(ellipsis, style).width;
        if (dots > rect.w) return 0;
        std::string_view kept = text.substr(0, run->bytes_within(rect.w - dots));
        while (kept.ends_with(' ')) kept.remove_suffix(1);
        elided_.assign(kept).append(ellipsis);
        run = &fonts_.run(elided_, style);
    }
    const LineMetrics& metrics = run->metrics;
    const float space = rect.w - run->width;
    const float left = align == Align::start ? 0 : align == Align::center ? space / 2 : space;
    const float top = whole((rect.h - metrics.ascent - metrics.descent) / 2);
    this->run(*run, {whole(rect.x + std::max(0.0F, left)), rect.y + top + metrics.ascent}, color);
    return run->width;
}

float Painter::path(const Rect& rect, std::string_view text, const TextStyle& style, Color color) {
    if (text.empty() || hidden(rect)) return 0;
    const Run& whole_run = fonts_.run(text, style);
    const float dots = fonts_.run(ellipsis, style).width;
    if (whole_run.width <= rect.w + 0.5F || dots > rect.w) return this->text(rect, text, whole_run, style, color);
    // So much of its beginning goes, then the rest of that folder, if there is another one.
    std::size_t from = whole_run.bytes_within(whole_run.width - (rect.w - dots));
    const auto kept_width = [&] {
        elided_.assign(ellipsis).append(text.substr(from));
        return fonts_.run(elided_, style).width;
    };
    while (from < text.size() && (continues(text[from]) || kept_width() > rect.w)) ++from;
    if (const std::size_t folder = text.find_first_of("/\\", from); folder + 1 < text.size() && folder != text.npos)
        from = folder;
    elided_.assign(ellipsis).append(text.substr(from));
    return this->text(rect, elided_, fonts_.run(elided_, style), style, color);
}

void Painter::run(const Run& run, glm::vec2 baseline, Color color) {
    if (run.glyphs.empty() || color.a == 0) return;
    const float left = whole(baseline.x), top = whole(baseline.y);
    const Rect& visible = clip();
    const float x = left + run.ink.x, y = top + run.ink.y, right = x + run.ink.w, bottom = y + run.ink.h;
    const bool inside = x >= visible.x && y >= visible.y && right <= visible.right() && bottom <= visible.bottom();
    const auto outside = [&](const Instance& g, glm::vec2 by) {
        return !Rect{g.x + by.x, g.y + by.y, g.w, g.h}.overlaps(visible);
    };
    // A run of which nothing is seen must not enter its clip: when it is kept, it does not either.
    if (!inside && std::all_of(run.glyphs.begin(), run.glyphs.end(), [&](const Instance& g) {
            return outside(g, {left, top});
        }))
        return;
    const std::uint8_t clip = clip_index();
    Instance* const first = list_.instances.add(run.glyphs.size());
    Instance* end = first;
    for (const Instance& from : run.glyphs) {
        Instance& glyph = *end++;
        glyph.x = from.x + left, glyph.y = from.y + top, glyph.w = from.w, glyph.h = from.h;
        std::memcpy(glyph.uv, from.uv, sizeof glyph.uv);
        glyph.color = color;
        glyph.radius = from.radius, glyph.border = from.border, glyph.kind = from.kind, glyph.clip = clip;
    }
    if (inside) return;
    Instance* const kept = std::remove_if(first, end, [&](const Instance& g) { return outside(g, {0, 0}); });
    list_.instances.shorten(static_cast<std::size_t>(kept - list_.instances.data()));
}

}  // namespace lapfx::ui
