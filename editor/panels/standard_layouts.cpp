#include "panels/standard_layouts.h"

namespace lapfx::panels {

namespace {

using ui::Axis;
using ui::dock_split;
using ui::dock_tabs;
using ui::DockLayout;

DockLayout tune() {
    return dock_split(Axis::x, 0.70F,
                      dock_split(Axis::y, 0.73F, dock_tabs({"View", "Reference", "Measure"}),
                                 dock_tabs({"Timeline", "Amounts", "Curves", "Library"})),
                      dock_tabs({"Preset", "Clips", "Scene", "Keying", "Fit", "Snapshots", "History"}));
}

DockLayout key() {
    return dock_split(Axis::x, 0.64F,
                      dock_split(Axis::y, 0.74F, dock_tabs({"Keying", "Reference", "Measure"}),
                                 dock_tabs({"Timeline", "Amounts", "Curves", "Library"})),
                      dock_split(Axis::y, 0.45F, dock_tabs({"View"}),
                                 dock_tabs({"Clips", "Preset", "Scene", "Fit", "Snapshots", "History"})));
}

DockLayout compare() {
    return dock_split(
        Axis::x, 0.72F,
        dock_split(Axis::y, 0.58F, dock_tabs({"Reference", "Measure", "View", "Keying"}),
                   dock_split(Axis::x, 0.5F, dock_tabs({"Timeline", "Curves", "Library"}), dock_tabs({"Amounts"}))),
        dock_split(Axis::y, 0.66F, dock_tabs({"Preset", "Clips", "Scene", "Fit"}),
                   dock_tabs({"Snapshots", "History"})));
}

DockLayout stage() {
    return dock_split(
        Axis::x, 0.70F,
        dock_split(Axis::y, 0.62F, dock_tabs({"View", "Reference", "Measure", "Keying"}),
                   dock_split(Axis::x, 0.55F, dock_tabs({"Timeline", "Library"}), dock_tabs({"Curves", "Amounts"}))),
        dock_tabs({"Scene", "Preset", "Clips", "Fit", "Snapshots", "History"}));
}

}  // namespace

std::vector<app::StandardLayout> standard_layouts() {
    return {{"Tune", tune}, {"Key", key}, {"Compare", compare}, {"Stage", stage}};
}

}  // namespace lapfx::panels
