#include "panels/event_form.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "panels/table_rows.h"
#include "panels/titles.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"

namespace lapfx::panels {

namespace {

constexpr double near_place = 200;  // mm, of dragging

const Parameter& row_of(std::string_view key) {
    return *scene_table().find("events")->find_row(key);
}

class EventForm {
  public:
    EventForm(ui::Ui& ui, const Edited& edited, const app::Stroke& stroke)
        : ui_(ui),
          edited_(edited),
          stroke_(stroke),
          first_(edited.document.scene().events[stroke.events.front()]),
          last_(edited.document.scene().events[stroke.events.back()]) {}

    /// Columns side by side; in a narrow panel two above two.
    void build(bool narrow) {
        // In a group of its own, because the scene has a row Duration, too.
        ui::Node& all = ui_.open(ui::Role::group, "Event", ui::Axis::y);
        all.size[0] = ui::grow();
        all.gap = ui_.em(0.25F);
        if (narrow) {
            {
                const ui::Row row(ui_, row_options);
                whens();
            }
            const ui::Row row(ui_, row_options);
            wheres();
        } else {
            const ui::Row row(ui_, row_options);
            whens();
            wheres();
        }
        ui_.close();
    }

  private:
    static constexpr ui::BoxOptions row_options{.width = ui::grow(), .gap = 0.8F, .cross = ui::ChildAlign::start};

    void whens() {
        pair(1, [&] { action(), power(); });
        pair(1, [&] { start(), strength(); });
    }
    void wheres() {
        pair(1, [&] { length(), pieces(); });
        pair(1.7F, [&] { place(), to(); });
    }
    template <typename F>
    void pair(float weight, F&& rows) {
        const ui::Column column(ui_, {.width = ui::grow(weight), .gap = 0.25F});
        rows();
    }
    template <typename F>
    void take(const ui::Edit& edit, std::string_view name, F&& change) {
        edited_.document.take(edit, name, [&](document::Content& c) { change(c.scene.events); });
    }
    ui::ParamOptions options(std::string_view key, double most) const {
        ui::ParamOptions o = param_options(row_of(key));
        o.maximum = most;
        return o;
    }

    void action() {
        int chosen = static_cast<int>(stroke_.action);
        const ui::Edit edit =
            ui::combo(ui_, "Action", chosen, action_titles(), {.tip = row_of("action").help, .caption = true});
        take(edit, "Action", [&](std::vector<ToolContact>& events) {
            for (const std::size_t i : stroke_.events) events[i].action = static_cast<ToolAction>(chosen);
        });
    }
    void start() {
        double value = stroke_.start;
        const ui::Edit edit =
            ui::param(ui_, "Start", value, ui::seconds(options("time", edited_.document.scene().duration)));
        take(edit, "Event time", [&](std::vector<ToolContact>& events) { app::move_stroke(events, stroke_, value); });
    }
    void length() {
        double value = stroke_.end - stroke_.start;
        const ui::Edit edit = ui::param(ui_, "Duration", value, ui::seconds(options("duration", 10)));
        take(edit, "Event duration", [&](std::vector<ToolContact>& events) {
            app::stretch_stroke(events, stroke_, stroke_.start, stroke_.start + value);
        });
    }
    /// The event as it was saved. Events have no names, so the saved one with the same action and time is taken. Null:
    /// it is new.
    const ToolContact* saved() const {
        const std::vector<ToolContact>& events = edited_.saved.content().scene.events;
        const auto found = std::find_if(events.begin(), events.end(), [&](const ToolContact& event) {
            return event.action == first_.action && event.time == first_.time;
        });
        return found != events.end() ? &*found : nullptr;
    }
    void number(std::string_view name, std::string_view key, double ToolContact::*member, bool counts) {
        double value = first_.*member;
        const ToolContact* const before = saved();
        const double initial = ToolContact{}.*member;
        ui_.push_disabled(!counts);
        ui::ParamOptions o = options(key, key == "power" ? 1 : 3);
        o.standard = before != nullptr ? before->*member : initial;
        o.initial = initial;
        const ui::Edit edit = ui::param(ui_, name, value, o);
        ui_.pop_disabled();
        take(edit, ui_.join({"Event ", key}), [&](std::vector<ToolContact>& events) {
            for (const std::size_t i : stroke_.events) events[i].*member = value;
        });
    }
    void power() { number("Power", "power", &ToolContact::power, row_of(stroke_.action).hot); }
    void strength() { number("Strength", "strength", &ToolContact::strength, divides(stroke_.action)); }
    void pieces() {
        if (stroke_.events.size() < 2) return;
        char text[48];
        std::snprintf(text, sizeof text, "A path of %zu segments", stroke_.events.size());
        ui::label(ui_, text, {.tone = ui::Tone::dim});
    }
    ui::ParamOptions place_options(std::string_view key) const {
        ui::ParamOptions o = options(key, near_place);
        o.minimum = -near_place;
        return o;
    }
    void place() {
        double values[] = {first_.position.x, first_.position.y, first_.position.z};
        const ui::Edit edit = ui::vector_param(ui_, "Position", values, place_options("position"));
        const glm::dvec3 wanted(values[0], values[1], values[2]);
        take(edit, "Event position", [&](std::vector<ToolContact>& events) {
            const glm::dvec3 by = wanted - events[stroke_.events.front()].position;
            // A single straight contact keeps its end, a path keeps its shape.
            if (stroke_.events.size() > 1) return app::shift_stroke(events, stroke_, by);
            ToolContact& event = events[stroke_.events.front()];
            if (event.to == event.position) event.to = wanted;
            event.position = wanted;
        });
    }
    void to() {
        double values[] = {last_.to.x, last_.to.y, last_.to.z};
        const ui::Edit edit = ui::vector_param(ui_, "To", values, place_options("to"));
        take(edit, "Event end", [&](std::vector<ToolContact>& events) {
            events[stroke_.events.back()].to = {values[0], values[1], values[2]};
        });
    }

    ui::Ui& ui_;
    const Edited& edited_;
    const app::Stroke& stroke_;
    const ToolContact first_, last_;
};

}  // namespace

bool is_selected(std::span<const std::size_t> selected, const app::Stroke& stroke) {
    return std::any_of(stroke.events.begin(), stroke.events.end(),
                       [&](std::size_t i) { return std::binary_search(selected.begin(), selected.end(), i); });
}

void event_form(ui::Ui& ui, const Edited& edited, std::span<const std::size_t> selected,
                std::span<const app::Stroke> strokes, bool narrow) {
    const auto found =
        std::find_if(strokes.begin(), strokes.end(), [&](const auto& stroke) { return is_selected(selected, stroke); });
    if (found != strokes.end()) return EventForm(ui, edited, *found).build(narrow);
    ui::label(ui,
              "Choose a tool and hold it on the organ: what it does is recorded here. Select an event to edit it here.",
              {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
}

}  // namespace lapfx::panels
