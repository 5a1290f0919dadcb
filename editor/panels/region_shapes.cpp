#include "panels/region_shapes.h"

#include <algorithm>

#include "panels/place_handle.h"
#include "ui/core/node.h"

namespace lapfx::panels {

namespace {

using document::Content;

constexpr double least_side = 0.01;  // the table allows no smaller part of the picture

/// Not finer than places are, and never below what the table allows.
double side_between(double low, double high) {
    return std::clamp(rounded_place(high - low), least_side, 1.0);
}

struct FramesLook {
    std::array<ui::Rect, most_compared_regions> frames;
    std::array<std::string_view, most_compared_regions> names;
    std::size_t count = 0, chosen = 0;
};

void draw_frames(ui::Painter& painter, const ui::Node&, const FramesLook& look) {
    const ui::Theme& t = painter.theme();
    for (std::size_t i = 0; i < look.count; ++i) {
        const ui::Color ink = i == look.chosen ? t.accent : ui::canvas_ink(t, 0.75F);
        painter.frame(look.frames[i], ink, (i == look.chosen ? 2 : 1) * painter.hairline());
        const ui::Rect label{look.frames[i].x + painter.em(0.6F), look.frames[i].y + painter.em(0.1F), painter.em(2),
                             painter.em(1.4F)};
        painter.text(label, look.names[i], painter.text_style(0.9F, ui::Weight::bold), ink, ui::Align::start);
    }
}

class Shapes {
  public:
    Shapes(ui::Ui& ui, const RegionShapes& of, const ui::View& view)
        : ui_(ui), look_(of.look), edited_(of.edited), view_(view) {
        const std::vector<ComparedRegion>& all = edited_.document.scene().reference.regions;
        count_ = std::min(all.size(), most_compared_regions);
        std::copy_n(all.begin(), count_, regions_.begin());
    }

    void build() {
        draw();
        for (std::size_t i = 0; i < count_; ++i)
            if (handles(i)) return;  // what comes after has another number now
    }

  private:
    void draw() {
        ui::Node& below = ui_.leaf(ui::Role::none, "##frames", ui::Sense::none);
        below.size[0] = ui::fraction(1), below.size[1] = ui::fraction(1);
        below.placed = true;
        below.placement = ui_.arena().make(ui::Placement{});
        FramesLook look;
        look.count = count_, look.chosen = look_.region;
        for (std::size_t i = 0; i < count_; ++i) {
            const glm::vec2 low = on_screen(low_of(i)), high = on_screen(high_of(i));
            look.frames[i] = {low.x, low.y, high.x - low.x, high.y - low.y};
            look.names[i] = ui_.copy(std::to_string(i + 1));
        }
        ui_.draw_with<draw_frames>(below, look);
    }
    glm::vec2 on_screen(glm::dvec2 place) const { return glm::vec2(view_.to_screen(place * glm::dvec2(view_.size))); }
    glm::dvec2 low_of(std::size_t i) const { return {regions_[i].x, regions_[i].y}; }
    glm::dvec2 high_of(std::size_t i) const {
        return glm::min(low_of(i) + glm::dvec2(regions_[i].width, regions_[i].height), 1.0);
    }

    /// One gesture of a handle leads to a rectangle. Gives whether the region was removed.
    bool take(std::size_t i, const ui::HandleMoves& moves, const ui::Edit& edit, glm::dvec2 low, glm::dvec2 high) {
        if (moves.held || moves.reset) look_.region = i;
        if (moves.reset) {
            edited_.document.change("Remove region", [&](Content& c) {
                auto& all = c.scene.reference.regions;
                if (i < all.size()) all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
            });
            look_.region = i > 0 ? i - 1 : 0;
            return true;
        }
        edited_.document.take(edit, "Region", [&](Content& c) {
            auto& all = c.scene.reference.regions;
            if (i < all.size()) all[i] = {low.x, low.y, side_between(low.x, high.x), side_between(low.y, high.y)};
        });
        return false;
    }
    void knob(float size) {
        ui_.draw_with<ui::draw_knob>(ui_.last(),
                                     ui::KnobLook{.color = ui::canvas_ink(ui_.theme()), .size = glm::vec2(size)});
    }

    bool handles(std::size_t i) {
        const std::string_view name = ui_.join({"Region ", ui_.copy(std::to_string(i + 1))});
        const glm::dvec2 low = low_of(i), high = high_of(i), half = 0.5 * (high - low);
        glm::dvec2 place = low + half;
        ui::HandleMoves moves = put_place(ui_, view_, name, "A region of both pictures. Delete removes it", place);
        knob(0.9F);
        ui::Edit edit = edit_place(
            ui_, view_, moves, [&](glm::dvec2 p) { return glm::clamp(p, half, 1.0 - half); }, place);
        if (take(i, moves, edit, place - half, place + half)) return true;
        place = low;
        moves = put_place(ui_, view_, ui_.join({name, " upper left"}), "A corner of a region", place);
        knob(0.6F);
        edit = edit_place(
            ui_, view_, moves, [&](glm::dvec2 p) { return glm::clamp(p, glm::dvec2(0), high - least_side); }, place);
        if (take(i, moves, edit, place, high)) return true;
        place = high;
        moves = put_place(ui_, view_, ui_.join({name, " lower right"}), "A corner of a region", place);
        knob(0.6F);
        edit = edit_place(
            ui_, view_, moves, [&](glm::dvec2 p) { return glm::clamp(p, low + least_side, glm::dvec2(1)); }, place);
        return take(i, moves, edit, low, place);
    }

    ui::Ui& ui_;
    app::ScopesLook& look_;
    const Edited& edited_;
    const ui::View& view_;
    // Copied before any handle changes them.
    std::array<ComparedRegion, most_compared_regions> regions_;
    std::size_t count_ = 0;
};

}  // namespace

void RegionShapes::build(ui::Ui& ui, const ui::View& view, void* with) {
    if (view.area.empty()) return;
    Shapes(ui, *static_cast<RegionShapes*>(with), view).build();
}

}  // namespace lapfx::panels
