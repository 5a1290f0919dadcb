#include "commands/help_tour.h"

#include "lapfx/tool.h"

namespace lapfx::commands {

namespace {

HelpSection section(std::string title, std::vector<std::string> paragraphs) {
    return {.title = std::move(title), .paragraphs = std::move(paragraphs), .facts_title = {}, .rows = {}};
}

HelpSection looking() {
    return section(
        "Look", {"The sample scene plays: a hook burns fat and a ligament next to the stomach. Space stops it, and the "
                 "timeline scrubs.",
                 "The View shows what the endoscope sees. Drag orbits, middle drag pans, the wheel zooms, Home shows "
                 "the whole organ, and E goes back to the endoscope. V, T and G show vessels, fat and the bleed value "
                 "(see lapfx help overlays)."});
}

HelpSection tuning() {
    return section(
        "Tune",
        {"Drag any value under Preset: the next frame shows it. The values used most are on top, under Favourites. "
         "Double click types a value (12/2, 0.5 cm); Backspace returns to the saved value, Shift+Backspace to the "
         "default; Ctrl+Z undoes. Ctrl+F finds a parameter by name, by meaning or by an everyday word (fog).",
         "The menu of a row locks it. Ctrl+R randomises all values that are not locked, as far as the dice says.",
         "Shift+A keeps the preset as snapshot A, and A shows it again. Snapshots has a picture of each, says in words "
         "what differs, and puts any two of snapshots, preview and reference beside each other. Curves bend cautery "
         "power, bleeding and smoke over time."});
}

/// "1 to cauterise (2 cut, 3 coagulate, 0 look around)"
std::string tool_keys() {
    std::string keys;
    for (const ToolActionRow& row : tool_actions) {
        const bool first = &row == &tool_actions[0];
        keys += std::string(1, row.shortcut) + (first ? " to " : " ") + std::string(row.key) + (first ? " (" : ", ");
    }
    return keys + "0 look around)";
}

HelpSection working() {
    return section("Work on the organ",
                   {"Press " + tool_keys() +
                    " and hold the left button on the organ. Each stroke becomes an event on the timeline, where it "
                    "can be moved and stretched, and its values typed. What each tool does: lapfx help tool."});
}

HelpSection bringing() {
    return section(
        "Bring your own",
        {"Drop an organ, smoke clips, a surgery video, presets or scenes into the window, or name them: "
         "lapfx my_organ.glb my_smoke.mp4. A dialog puts the unit and orientation of an organ right, and finds a "
         "texture that was renamed. What can be read: lapfx help files.",
         "Ctrl+2 opens the keying bench, which separates the smoke of a clip from its background. Its handles on the "
         "picture and on the plots set source, crop, masks and thresholds. Ctrl+K suggests thresholds, as is done for "
         "each clip that comes in. Shift+S shows the selected clip alone."});
}

HelpSection comparing() {
    return section(
        "Compare",
        {"U lays the reference over the view, translucent, to place the camera by. Ctrl+3 puts the preview next to the "
         "reference, with zoom and time linked: M changes between wipe, difference and onion skin, holding F flickers, "
         "and Shift+M shows the scopes of both, and figures of regions drawn over them.",
         "Move reference moves, scales and turns the reference until the same tissue lies at the same place in both, "
         "or lays the circle of its endoscope on the preview's; a plate goes with it. Of a video that is stored "
         "squeezed, the aspect is proposed with which that circle is round.",
         "Propose look finds exposure, vignette and colours by the frame that is shown; Take look takes them. The "
         "eyedropper of a colour takes it from either picture, and gives the field the colour with which the preview "
         "shows it there.",
         "Alt+1 to Alt+4 mark where smoke starts, peaks and clears and where blood starts; I and O choose the part "
         "that plays."});
}

HelpSection measuring() {
    return section(
        "Measure and fit",
        {"Measure tells how much blood and smoke the reference shows, frame by frame, with an interval, and begins by "
         "itself. Where a video bleeds from its beginning, Paint blood (Ctrl+Shift+B) over some of it and Paint other "
         "over what is none: then all that looks like it counts. Amounts lays the curves of the reference and of the "
         "preview, measured alike, over each other, and "
         "says how far their colours are apart. Counted draws what was counted over the reference. Plate (P) puts a "
         "clear frame of it in place of the organ, so that both pictures show the same tissue.",
         "Fit (Ctrl+Shift+F) finds values with which both curves agree. It works beside you on what may change, within "
         "locks, draws its best curve so far, and says for each value how sure it is or why the video does not tell "
         "it. Colours has it match those of blood and smoke, and exposure and tint of the tissue, too. Take takes it "
         "all, tools at their times too, as one undo step; strokes that the reference does not show are (silenced) on "
         "the timeline then, and their power and strength bring them back. Export report... writes curves, values and "
         "pictures as a page for a browser."});
}

HelpSection exporting() {
    return section(
        "Export",
        {"Ctrl+E writes the preset, a bundle with its clips, a picture, a sequence or a video, with the code of lapfx "
         "render, and reads back what it wrote (lapfx help outputs). Beside the reference, with curves makes the page "
         "that one sends to a colleague.",
         "Ctrl+S saves the preset; for one that came with lapfx it asks for another name. After a crash the editor "
         "offers the work that was not saved."});
}

HelpSection window() {
    return section(
        "The window",
        {"Ctrl+P finds every command and parameter, and F1 shows all keys. Ctrl+1 to Ctrl+4 are the layouts Tune, Key, "
         "Compare and Stage; drag panels by their tabs.",
         "Everything also works by keyboard: Tab, arrows, F6 from panel to panel, F10 or Alt with a letter for the "
         "menus. Esc closes the newest notice; Window > All notices lists every notice so far.",
         "In a small window (below 820 x 420 at scale 1, below 1640 x 840 at scale 2) all panels are tabs of one "
         "group, and More... has the tools that do not fit."});
}

}  // namespace

std::vector<HelpSection> tour_sections() {
    return {looking(), tuning(), working(), bringing(), comparing(), measuring(), exporting(), window()};
}

}  // namespace lapfx::commands
