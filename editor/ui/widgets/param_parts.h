// What params are made of; of widgets/param*.cpp alone.
#pragma once

#include "ui/widgets/field.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/param.h"

namespace lapfx::ui {

inline constexpr float param_inner = 0.45F;  // em between a field's edge and its text
inline constexpr Sense number_sense = Sense::hover | Sense::press | Sense::context | Sense::focus | Sense::focus_wheel |
                                      Sense::command_wheel | Sense::arrows_x | Sense::arrows_y | Sense::pages |
                                      Sense::extremes | Sense::erase | Sense::digits | Sense::copying |
                                      Sense::hover_keys;

inline constexpr Sense entry_sense = Sense::hover | Sense::press | Sense::focus | Sense::editing;

/// What lasts of the one number that is dragged, stepped or typed into: one is enough for the whole UI.
struct NumberState {
    Id held = 0;  ///< pressed or dragged
    std::uint8_t clicks = 0;
    bool on_label = false, dragging = false, began = false;
    float travel = 0;             ///< px since the press, until the drag begins
    double raw = 0;               ///< where the drag stands, not rounded
    double start = 0, shown = 0;  ///< the value before the drag: kept, and as it was shown
    Id stepping = 0;              ///< whose arrow key is down: its repeats are one edit
    Key step_key = Key::none;
    Id wheeled = 0;  ///< whose wheel has gone less than a notch, by so much
    float wheel = 0;
    Id typing = 0;  ///< whose entry is open
    NumberEntry entry;
    std::uint32_t tabbed_at = 0;  ///< build in which an open entry was left
    Id opens = 0;                 ///< who opens in the next build: Tab came to it from an open entry
    Id menu_of = 0, range_of = 0;
    ParamLimits range_shown{};  ///< of the fields that set the range
};

/// Null: nothing has to do with `id` in this build.
NumberState* number_state(Ui& ui, Id id);

/// One number in one build: events to edits.
class NumberGesture {
  public:
    /// `field`: what is dragged of it, as it was laid out last; `way`: px of the whole range.
    NumberGesture(Ui& ui, Id id, const ParamOptions& options, double& value, const Rect& field, float way)
        : ui_(ui), id_(id), o_(options), value_(value), field_(field), way_(way) {}
    Edit take(NumberState& state, const Response& response);

  private:
    bool set(double shown);
    void once(NumberState& s, double shown);
    void enter(NumberState& s, double shown);
    double shown() const { return value_ * o_.display; }
    void open(NumberState& s);
    void type(NumberState& s, const Response& r);
    void close(NumberState& s, bool keep);
    void press(NumberState& s, const Response& r);
    void move(NumberState& s, float pixels, Mods mods);
    void keys(NumberState& s, const Response& r);
    void step(NumberState& s, const Event& event, double count);
    void end_steps(NumberState& s);
    void wheel(NumberState& s, const Response& r);
    void show_cursor(const NumberState& s, const Response& r) const;

    Ui& ui_;
    Id id_;
    const ParamOptions& o_;
    double& value_;
    Rect field_;
    float way_;
    Edit edit_;
};

void copy_number(Ui& ui, const ParamOptions& options, double shown);
/// What the clipboard has, if it is a number that can stand here.
std::optional<double> number_to_paste(Ui& ui, const ParamOptions& options, double shown);
/// What becomes of a number that was entered, where it is beyond the hard limits: "allowed are 0 to 60 mm/s: 60 mm/s is
/// taken"; empty: it is allowed.
std::string beyond_limits(const ParamOptions& options, double shown);
ExpressionContext context_of(const ParamOptions& options, double shown);

/// The open menu and the fields for the range, if they are those of `id`.
Edit param_menu(Ui& ui, NumberState& state, Id id, const Response& response, std::string_view label, double& value,
                const ParamOptions& options, ParamActions* actions);

/// What number and unit look like; strings in the frame's arena.
struct NumberText {
    std::string_view number, unit;
    std::string_view whole;  ///< "12.5 mm/s"
    friend bool operator==(const NumberText&, const NumberText&) = default;
};
/// Along the soft range, 0 to 1.
float place_of_param(const ParamOptions& options, double shown);
NumberText number_text(Ui& ui, const ParamOptions& options, double shown);
/// What the semantic tree has of a number, and its states.
void describe_number(Ui& ui, Node& node, const NumberState* state, const ParamOptions& options, double shown,
                     const NumberText& text);

struct LabelLook {
    std::string_view text = {};
    bool changed = false, locked = false, disabled = false;
    friend bool operator==(const LabelLook&, const LabelLook&) = default;
};
/// Draws the label, the padlock and the dot in the label's column.
void draw_param_label(Painter& painter, Rect column, const LabelLook& look);
/// Draws a mark at `place` px of the field, along its lower edge.
void draw_param_mark(Painter& painter, const Rect& field, float place, float width, Color color);
void draw_number(Painter& painter, Rect inside, const NumberText& text, Align align, bool disabled);

}  // namespace lapfx::ui
