// Commands of the reference.

#include "app/base/layouts.h"
#include "app/editor.h"
#include "app/reference/plate.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/letters.h"
#include "panels/panels.h"
#include "panels/parts.h"

namespace lapfx::panels {

namespace {

using app::Reference;

void add_mark_commands(app::Editor& editor) {
    char digit = '1';
    for (const Parameter& row : Reference::mark_table().rows) {
        editor.commands.add({.id = "reference.mark_" + std::string(row.key),
                             .title = "Mark: " + lower_first(std::string(row.name)) + " here",
                             .group = "Reference",
                             .chord = {ui::key_of(digit++), ui::Mods::alt},
                             .run = [&editor, &row] { editor.reference().mark(row); },
                             .enabled =
                                 [&editor] {
                                     const Reference& reference = editor.reference();
                                     return reference.video() != nullptr && reference.time() >= 0 &&
                                            reference.time() <= reference.video()->info().duration;
                                 },
                             .tip = "Marks the present frame of the reference; the mark is moved on the timeline",
                             .missing = "the reference has no frame at this time"});
    }
    editor.commands.add({.id = "reference.clear_marks",
                         .title = "Clear marks",
                         .group = "Reference",
                         .run = [&editor] { editor.reference().clear_marks(); },
                         .enabled = [&editor] { return editor.reference().any_mark(); },
                         .tip = "Nothing of the reference is marked any more. One alone: Delete on the timeline",
                         .missing = "nothing is marked"});
}

}  // namespace

void add_reference_commands(app::Editor& editor) {
    using ui::key_of;
    using ui::Mods;
    const auto compared = [&editor] {
        return editor.reference().video() != nullptr || !editor.reference().comparison().compares_video();
    };
    editor.commands.add({.id = "reference.open",
                         .title = "Open reference video",
                         .group = "Reference",
                         .chord = {key_of('V'), Mods::command | Mods::shift},
                         .run =
                             [&editor] {
                                 editor.layouts().bring_to_front("Reference");
                                 ask_for_video(editor.reference(), editor.chooser());
                             },
                         .tip = "The surgery video to match"});
    editor.commands.add({.id = "reference.sample",
                         .title = "Sample reference",
                         .group = "Reference",
                         .run =
                             [&editor] {
                                 editor.layouts().bring_to_front("Reference");
                                 editor.reference().choose_sample();
                             },
                         .tip = "A video that comes with lapfx, of another operation than the sample scene's"});
    editor.commands.add({.id = "reference.next_way",
                         .title = "Next way of comparing",
                         .group = "Reference",
                         .chord = {key_of('M'), Mods::none},
                         .run =
                             [&editor] {
                                 if (editor.layouts().seen("Reference"))
                                     return editor.reference().comparison().next_way();
                                 editor.layouts().bring_to_front("Reference");
                             },
                         .enabled = compared,
                         .tip = "Reference, side by side, wipe, difference, onion; shows the panel first",
                         .missing = "there is no reference that can be shown"});
    editor.commands.add({.id = "reference.scopes",
                         .title = "Scopes of both pictures",
                         .group = "Reference",
                         .chord = {key_of('M'), Mods::shift},
                         .run =
                             [&editor] {
                                 bool& on = editor.reference().comparison().scopes_look.on;
                                 on = !on || !editor.layouts().seen("Reference");
                                 editor.layouts().bring_to_front("Reference");
                             },
                         .enabled = compared,
                         .checked = [&editor] { return editor.reference().comparison().scopes_look.on; },
                         .tip = "Levels, waveform and colours of the pictures that are compared, next to each other",
                         .missing = "there is no reference that can be shown"});
    editor.commands.add({.id = "reference.counted",
                         .title = "Counted blood and smoke",
                         .group = "Reference",
                         .run =
                             [&editor] {
                                 bool& on = editor.reference().shown().shows_counted;
                                 on = !on || !editor.layouts().seen("Reference");
                                 editor.layouts().bring_to_front("Reference");
                             },
                         .enabled = [&editor] { return editor.reference().video() != nullptr; },
                         .checked = [&editor] { return editor.reference().shown().shows_counted; },
                         .tip = "Draws over the reference what was measured in it, as it plays",
                         .missing = "there is no reference that can be shown"});
    editor.commands.add({.id = "reference.align",
                         .title = "Align start here",
                         .group = "Reference",
                         .run = [&editor] { editor.reference().align(); },
                         .enabled = [&editor] { return editor.reference().held(); },
                         .tip = "The frame that is held belongs to the current time of the scene",
                         .missing = "no frame of the reference is held"});
    editor.commands.add(
        {.id = "reference.plate_here",
         .title = "Plate from this frame",
         .group = "Reference",
         .run =
             [&editor] {
                 const app::Reference& reference = editor.reference();
                 app::plate_from(editor.document, reference.video()->time_of(reference.frame()));
             },
         .enabled = [&editor] { return editor.reference().video() != nullptr; },
         .tip = "The frame of the reference that is shown stands in for the organ: choose one without smoke",
         .missing = "there is no reference that can be shown"});
    editor.commands.add(
        {.id = "reference.propose_look",
         .title = "Propose look",
         .group = "Reference",
         .run =
             [&editor] {
                 editor.layouts().bring_to_front("Reference");
                 editor.reference().look().propose();
             },
         .enabled = [&editor] { return editor.reference().video() != nullptr; },
         .tip = "Finds vignette, exposure and colours by the frame of the reference that is shown; nothing changes "
                "until they are taken. Best on a clear frame of tissue",
         .missing = "there is no reference that can be shown"});
    const auto proposed = [&editor] { return editor.reference().look().proposed(); };
    editor.commands.add({.id = "reference.take_look",
                         .title = "Take look",
                         .group = "Reference",
                         .run = [&editor] { editor.reference().look().take(); },
                         .enabled = proposed,
                         .tip = "Takes the look that is proposed into scene and preset, as one undo step",
                         .missing = "no look is proposed"});
    editor.commands.add({.id = "reference.leave_look",
                         .title = "Leave look",
                         .group = "Reference",
                         .run = [&editor] { editor.reference().look().leave(); },
                         .enabled = proposed,
                         .tip = "Forgets the look that is proposed; scene and preset stay as they are",
                         .missing = "no look is proposed"});
    editor.commands.add(
        {.id = "reference.take_circle",
         .title = "Take the circle",
         .group = "Reference",
         .run = [&editor] { editor.reference().look().take_circle(); },
         .enabled = [&editor] { return editor.reference().video() != nullptr; },
         .tip = "Places the reference so that the round view of its endoscope lies on the preview's, and turns the "
                "vignette on",
         .missing = "there is no reference that can be shown"});
    add_mark_commands(editor);
    editor.commands.add({.id = "reference.remove",
                         .title = "Remove reference",
                         .group = "Reference",
                         .run = [&editor] { editor.reference().remove(); },
                         .enabled = [&editor] { return editor.reference().named(); },
                         .tip = "The scene then has no reference; its file stays",
                         .missing = "the scene has no reference"});
}

}  // namespace lapfx::panels
