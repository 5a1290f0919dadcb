#include "panels/clip_shapes.h"

#include <algorithm>
#include <array>

#include "app/clips/keying_bench.h"
#include "lapfx/authoring/clip_roles.h"
#include "panels/clip_parameters.h"
#include "panels/parts.h"
#include "panels/place_handle.h"
#include "panels/table_rows.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/section.h"

namespace lapfx::panels {

namespace {

using document::Content;

constexpr double least_side = 0.005;  // a mask is at least this part of the frame wide and high
constexpr double most_cut = 0.95;     // the table's rule allows no more

/// What is drawn below the handles, px of the screen.
struct ShapesLook {
    ui::Rect whole, kept;
    std::array<ui::Rect, most_masks + 1> masks;
    int count;
    bool cropped;
};

ui::Rect rect_of(const ui::View& view, glm::dvec2 low, glm::dvec2 high) {
    const glm::dvec2 size(view.size);
    const glm::vec2 from(view.to_screen(low * size)), to(view.to_screen(high * size));
    return {from.x, from.y, to.x - from.x, to.y - from.y};
}

void draw_shapes(ui::Painter& painter, const ui::Node&, const ShapesLook& look) {
    const ui::Theme& t = painter.theme();
    const ui::Color shade = with_alpha(t.canvas, 0.6F);
    if (look.cropped) {
        const ui::Rect &w = look.whole, &k = look.kept;
        painter.fill({w.x, w.y, w.w, k.y - w.y}, shade);
        painter.fill({w.x, k.bottom(), w.w, w.bottom() - k.bottom()}, shade);
        painter.fill({w.x, k.y, k.x - w.x, k.h}, shade);
        painter.fill({k.right(), k.y, w.right() - k.right(), k.h}, shade);
    }
    painter.frame(look.kept, ui::canvas_ink(t, 0.5F), painter.hairline());
    for (int i = 0; i < look.count; ++i) {
        const ui::Rect& mask = look.masks[static_cast<std::size_t>(i)];
        painter.fill(mask, with_alpha(t.error, 0.35F));
        painter.frame(mask, ui::canvas_ink(t), painter.hairline());
    }
}

/// What handles are made of, copied before any of them changes the clip.
struct ShapesBefore {
    ClipCrop crop;
    ClipRole role;
    glm::dvec2 source;
    std::array<ClipMask, most_masks> masks{};
    std::size_t count;

    explicit ShapesBefore(const SmokeClip& clip)
        : crop(clip.crop),
          role(clip.role),
          source(clip.source_x, clip.source_y),
          count(std::min(clip.masks.size(), most_masks)) {
        std::copy_n(clip.masks.begin(), count, masks.begin());
    }
};

class Shapes {
  public:
    Shapes(ui::Ui& ui, const ClipShapes& of, const ui::View& view)
        : ui_(ui), bench_(of.bench), edited_(of.edited), view_(view), number_(of.number), clip_(*of.bench.clip()) {}

    void build() {
        app::BenchLook& look = bench_.look;
        ShapesLook shown{
            .whole = view_.rect(), .kept = {}, .masks = {}, .count = 0, .cropped = clip_.crop != ClipCrop{}};
        shown.kept = rect_of(view_, {clip_.crop.left, clip_.crop.top}, {1 - clip_.crop.right, 1 - clip_.crop.bottom});
        for (std::size_t i = 0; i < clip_.count; ++i) {
            const ClipMask& mask = clip_.masks[i];
            shown.masks[static_cast<std::size_t>(shown.count++)] =
                rect_of(view_, {mask.x, mask.y}, {mask.x + mask.width, mask.y + mask.height});
        }
        ui::Node& below = ui_.leaf(ui::Role::none, "##shapes",
                                   look.draws_mask ? ui::Sense::hover | ui::Sense::press : ui::Sense::none);
        below.size[0] = ui::fraction(1), below.size[1] = ui::fraction(1);
        below.placed = true;
        below.placement = ui_.arena().make(ui::Placement{});
        if (look.draws_mask) draw_mask(below, shown);
        ui_.draw_with<draw_shapes>(below, shown);
        if (look.draws_mask) return;
        crop_handles();
        for (std::size_t i = 0; i < clip_.count; ++i) mask_handles(i);
        if (!row_of(clip_.role).fills_view) source_handle();
    }

  private:
    ui::HandleMoves handle(std::string_view label, std::string_view tip, glm::dvec2 place, ui::Cursor cursor) {
        return put_place(ui_, view_, label, tip, place, cursor);
    }
    void knob(ui::Color color, float size) {
        ui_.draw_with<ui::draw_knob>(ui_.last(), ui::KnobLook{.color = color, .size = glm::vec2(size)});
    }
    template <typename F>
    void take(const ui::Edit& edit, std::string_view step, const F& set) {
        edited_.document.take(edit, step, [&](Content& c) {
            if (number_ < c.preset.smoke.clips.size()) set(c.preset.smoke.clips[number_]);
        });
    }
    const SmokeClip& saved() const { return edited_.saved.clip(number_); }

    void source_handle() {
        glm::dvec2 place = clip_.source;
        const ui::HandleMoves moves =
            handle("Source", "Where the smoke starts: this point of the clip is placed at the tool tip", place,
                   ui::Cursor::move);
        knob(ui_.theme().accent, 1.0F);
        ui::Edit edit = edit_place(
            ui_, view_, moves, [](glm::dvec2 p) { return glm::clamp(p, 0.0, 1.0); }, place);
        static const SmokeClip standard;
        const SmokeClip& from = moves.initial ? standard : saved();
        if (const glm::dvec2 back(from.source_x, from.source_y); (moves.reset || moves.initial) && back != place)
            place = back, edit = ui::Edit::once();
        take(edit, "Source", [&](SmokeClip& c) { c.source_x = place.x, c.source_y = place.y; });
    }

    void crop_handles() {
        edge("Crop left", &ClipCrop::left, &ClipCrop::right, 0, false);
        edge("Crop top", &ClipCrop::top, &ClipCrop::bottom, 1, false);
        edge("Crop right", &ClipCrop::right, &ClipCrop::left, 0, true);
        edge("Crop bottom", &ClipCrop::bottom, &ClipCrop::top, 1, true);
    }
    /// In the middle of a side; it moves across it alone.
    void edge(std::string_view label, double ClipCrop::*side, double ClipCrop::*other, int axis, bool far) {
        const ClipCrop& crop = clip_.crop;
        glm::dvec2 place(0.5 * (crop.left + 1 - crop.right), 0.5 * (crop.top + 1 - crop.bottom));
        const auto of = [&](double cut) { return far ? 1 - cut : cut; };
        place[axis] = of(crop.*side);
        const ui::HandleMoves moves = handle(label, "Everything outside this edge is left out", place,
                                             axis == 0 ? ui::Cursor::resize_x : ui::Cursor::resize_y);
        knob(ui::canvas_ink(ui_.theme()), 0.6F);
        const double most = std::min(0.9, std::max(most_cut - crop.*other, 0.0));
        const glm::dvec2 still = place;
        ui::Edit edit = edit_place(
            ui_, view_, moves,
            [&](glm::dvec2 p) {
                glm::dvec2 kept = still;
                kept[axis] = of(std::clamp(of(p[axis]), 0.0, most));
                return kept;
            },
            place);
        double cut = rounded_place(of(place[axis]));
        const double back = moves.initial ? ClipCrop{}.*side : saved().crop.*side;
        if ((moves.reset || moves.initial) && back != crop.*side && back <= most) cut = back, edit = ui::Edit::once();
        take(edit, label, [&](SmokeClip& c) { c.crop.*side = cut; });
    }

    void mask_handles(std::size_t index) {
        const ClipMask mask = clip_.masks[index];
        const std::string_view name = ui_.join({"Mask ", ui_.copy(std::to_string(index + 1))});
        const glm::dvec2 low(mask.x, mask.y), high = low + glm::dvec2(mask.width, mask.height);
        const auto set = [&](const ui::Edit& edit, glm::dvec2 from, glm::dvec2 to) {
            take(edit, name, [&](SmokeClip& c) {
                if (index < c.masks.size()) c.masks[index] = {from.x, from.y, to.x - from.x, to.y - from.y};
            });
        };
        glm::dvec2 corner = low;
        const glm::dvec2 least(least_side);
        bool removed = false;
        const auto moves_of = [&](std::string_view part, glm::dvec2 at) {
            const ui::HandleMoves moves =
                handle(ui_.join({name, part}), "Mask: nothing inside it counts as smoke. Delete removes it", at,
                       ui::Cursor::move);
            knob(ui::canvas_ink(ui_.theme()), part.empty() ? 0.8F : 0.6F);
            removed |= moves.reset;
            return moves;
        };
        ui::Edit edit = edit_place(
            ui_, view_, moves_of(" upper left", low),
            [&](glm::dvec2 p) { return glm::clamp(p, glm::dvec2(0), high - least); }, corner);
        set(edit, corner, high);
        corner = high;
        edit = edit_place(
            ui_, view_, moves_of(" lower right", high),
            [&](glm::dvec2 p) { return glm::clamp(p, low + least, glm::dvec2(1)); }, corner);
        set(edit, low, corner);
        const glm::dvec2 half = 0.5 * (high - low);
        corner = low + half;
        edit = edit_place(
            ui_, view_, moves_of("", corner), [&](glm::dvec2 p) { return glm::clamp(p, half, 1.0 - half); }, corner);
        set(edit, corner - half, corner + half);
        if (removed)
            edited_.document.change("Remove mask", [&](Content& c) {
                auto& masks = c.preset.smoke.clips[number_].masks;
                if (index < masks.size()) masks.erase(masks.begin() + static_cast<std::ptrdiff_t>(index));
            });
    }

    /// A drag makes a mask, when it ends.
    void draw_mask(ui::Node& node, ShapesLook& shown) {
        const ui::Response r = ui_.respond(node);
        if (r.hovered) ui_.set_cursor(ui::Cursor::crosshair);
        if (!r.held && !r.released && !r.cancelled) return;
        const auto place = [&](glm::vec2 at) {
            return glm::clamp(view_.to_picture(at) / glm::dvec2(view_.size), 0.0, 1.0);
        };
        const glm::dvec2 a = place(r.pressed_at), b = place(r.pointer), low = glm::min(a, b), high = glm::max(a, b);
        if (r.held) {
            shown.masks[static_cast<std::size_t>(shown.count++)] = rect_of(view_, low, high);
            return;
        }
        bench_.look.draws_mask = false;
        if (r.cancelled || high.x - low.x < least_side || high.y - low.y < least_side) return;
        if (clip_.count >= most_masks) return;
        edited_.document.change("Add mask", [&](Content& c) {
            c.preset.smoke.clips[number_].masks.push_back({rounded_place(low.x), rounded_place(low.y),
                                                           rounded_place(high.x - low.x),
                                                           rounded_place(high.y - low.y)});
        });
    }

    ui::Ui& ui_;
    app::KeyingBench& bench_;
    const Edited& edited_;
    const ui::View& view_;
    std::size_t number_;
    const ShapesBefore clip_;
};

/// Which clip a mask is drawn on.
struct MaskDrawing {
    std::size_t clip = 0;
};

void mask_rows(ui::Ui& ui, app::KeyingBench& bench, const Edited& edited, std::size_t number) {
    app::BenchLook& look = bench.look;
    const std::size_t count = bench.clip()->masks.size();
    {
        const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        ui.push_disabled(count >= most_masks && !look.draws_mask);  // it can always be switched off
        if (ui::button(ui, "Draw mask",
                       {.tip = "Drag a rectangle on the source picture: nothing inside it counts as smoke",
                        .on = look.draws_mask})) {
            look.draws_mask = !look.draws_mask;
            look.shapes = true;
            if (!look.grid) look.view = static_cast<int>(app::BenchView::source);
        }
        ui.pop_disabled();
        ui.push_disabled(count >= most_masks);
        if (ui::button(ui, "Add mask",
                       {.icon = ui::Icon::plus, .tip = "Adds a mask in the middle; drag it into place"}))
            edited.document.change("Add mask", [&](Content& c) {
                c.preset.smoke.clips[number].masks.push_back({.x = 0.4, .y = 0.4, .width = 0.2, .height = 0.2});
            });
        ui.pop_disabled();
    }
    static const ClipMask standard;
    const Table& table = *clip_table().find("masks");
    for (std::size_t i = 0; i < bench.clip()->masks.size(); ++i) {
        ui.push_seed(i);
        const std::string_view name = ui.join({"Mask ", ui.copy(std::to_string(i + 1))});
        {
            const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
            ui::label(ui, name, {.width = ui::grow()});
            if (ui::icon_button(ui, ui::Icon::cross, "Remove mask", {.quiet = true}))
                edited.document.change("Remove mask", [&](Content& c) {
                    auto& masks = c.preset.smoke.clips[number].masks;
                    masks.erase(masks.begin() + static_cast<std::ptrdiff_t>(i));
                });
        }
        const OwnerOf owner = [number, i](Content& c) -> void* {
            auto& clips = c.preset.smoke.clips;
            return number < clips.size() && i < clips[number].masks.size() ? &clips[number].masks[i] : nullptr;
        };
        const auto& saved = edited.saved.clip(number).masks;
        table_rows(ui, edited, table, owner,
                   {.prefix = name, .standard = &standard, .saved = i < saved.size() ? &saved[i] : &standard});
        ui.pop_seed();
    }
}

}  // namespace

void ClipShapes::build(ui::Ui& ui, const ui::View& view, void* with) {
    const ClipShapes& of = *static_cast<ClipShapes*>(with);
    if (of.bench.clip() == nullptr || view.area.empty() || !of.bench.look.shapes) return;
    Shapes(ui, of, view).build();
}

void follow_mask_drawing(ui::Ui& ui, app::KeyingBench& bench, std::size_t number) {
    bool& on = bench.look.draws_mask;
    std::size_t& clip = ui.memory<MaskDrawing>(ui.id_of("mask drawing")).clip;
    on &= clip == number && !ui.key_down(ui::Key::escape);
    clip = number;
}

void frame_rows(ui::Ui& ui, app::KeyingBench& bench, const Edited& edited, std::size_t number,
                ui::CommandTable& commands) {
    const ui::Section section(ui, "Frame");
    if (!section) return;
    static const SmokeClip standard;
    const SmokeClip& saved = edited.saved.clip(number);
    ui::toggle(ui, "Handles on the source", bench.look.shapes,
               {.tip = "Source, crop and masks can be dragged on the source picture"});
    const OwnerOf clip = [number](Content& c) -> void* {
        return number < c.preset.smoke.clips.size() ? &c.preset.smoke.clips[number] : nullptr;
    };
    const OwnerOf crop = [number](Content& c) -> void* {
        return number < c.preset.smoke.clips.size() ? &c.preset.smoke.clips[number].crop : nullptr;
    };
    for (const char* key : {"source_x", "source_y"})
        table_row(ui, edited, *clip_table().find_row(key), clip, {.standard = &standard, .saved = &saved});
    ui::command_button(ui, commands, "clip.source");
    for (const Parameter& row : clip_table().find("crop")->rows)
        table_row(ui, edited, row, crop,
                  {.name = ui.join({"Crop ", row.key}), .standard = &standard.crop, .saved = &saved.crop});
    table_row(ui, edited, *clip_table().find_row("edge_fade"), clip, {.standard = &standard, .saved = &saved});
    mask_rows(ui, bench, edited, number);
}

}  // namespace lapfx::panels
