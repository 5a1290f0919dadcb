// Typing into a number: a text in a field that is an expression all the while. Shared by all that shows numbers
// (param.h).
#pragma once

#include "ui/value/expression.h"
#include "ui/widgets/editing.h"

namespace lapfx::ui {

/// What it looks like in one frame.
struct EntryLook {
    std::string_view text;
    std::size_t caret = 0, from = 0, to = 0;  ///< bytes; selected is from..to
    float scroll = 0;                         ///< px
    bool caret_shown = true, wrong = false;
};
/// Field, text, selection and caret.
void draw_entry(Painter& painter, const Rect& field, const EntryLook& look);

class NumberEntry {
  public:
    enum class Outcome : std::uint8_t { goes_on, taken, given_up };

    /// Begins with `text`, all of it selected.
    void open(Ui& ui, std::string_view text);
    /// Keys, text and pointer of this build for the node `id`, whose text stands in `field`. What is wrong is not
    /// taken.
    Outcome take(Ui& ui, Id id, const Rect& field, const ExpressionContext& context);
    /// A typed character or a key that is about text.
    void type(Ui& ui, const Event& event);
    /// Evaluates the text if it is another one, and brings the caret into sight.
    void refresh(Ui& ui, const Rect& field, const ExpressionContext& context);

    bool modified() const { return text_ != begun_with_; }
    bool valid() const { return reason_.empty(); }
    double value() const { return value_; }
    const std::string& text() const { return text_; }
    const std::string& reason() const { return reason_; }  ///< why it cannot be taken; else empty
    /// For draw_entry(), in the frame's arena; asks for the frame in which the caret blinks.
    EntryLook look(Ui& ui) const;

  private:
    void pointer(Ui& ui, const Event& event, const Rect& field);
    void evaluate_once(const ExpressionContext& context);

    Editing editing_;
    std::string text_, begun_with_, evaluated_, reason_;
    double value_ = 0;
    float scroll_ = 0;
    bool evaluated_once_ = false, selecting_ = false;
};

}  // namespace lapfx::ui
