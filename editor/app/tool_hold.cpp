#include "app/tool_hold.h"

#include <algorithm>
#include <cmath>

#include "app/editor.h"
#include "app/events.h"

namespace lapfx::app {

void ToolHold::begin(Editor& editor, const glm::dvec3& place) {
    const ToolInHand& tool = editor.tool;
    if (on_ || !tool.action || !editor.preview.ready()) return;
    if (editor.timeline.time >= last_event_time) return;
    editor.document.commit();
    editor.preview.put_tool(*tool.action, row_of(*tool.action).hot ? tool.power : 1.0,
                            divides(*tool.action) ? tool.strength : 1.0, editor.timeline.time, place);
    on_ = editor.preview.tool_on();
    began_ = editor.timeline.time;
    speed_before_ = editor.timeline.speed;
    until_ = 0;
    place_ = place;
    if (on_) editor.timeline.speed = 1;
}

void ToolHold::begin_for(Editor& editor, const glm::dvec3& place, double seconds) {
    begin(editor, place);
    if (on_) until_ = began_ + seconds;
}

void ToolHold::move(Editor& editor, const glm::dvec3& place) {
    if (on_) place_ = place;
    if (on_) editor.preview.move_tool(editor.timeline.time, place);
}

void ToolHold::stop(Editor& editor) {
    on_ = false;
    editor.timeline.speed = speed_before_;
}

void ToolHold::end(Editor& editor) {
    if (!on_) return;
    if (until_ > 0) editor.timeline.time = std::min(editor.timeline.time, until_);
    const std::vector<ToolContact> made = simplified(editor.preview.take_tool_off(editor.timeline.time));
    stop(editor);
    if (made.empty()) return;
    const std::size_t there = editor.document.scene().events.size();
    if (there + made.size() > most_events) {
        editor.toasts.add({.kind = ui::ToastKind::error,
                           .text = "Not recorded: a scene has at most 4096 events; delete some on the timeline"});
        return;
    }
    editor.document.change(std::string(row_of(made.front().action).title), [&](document::Content& c) {
        c.scene.events.insert(c.scene.events.end(), made.begin(), made.end());
        const double last = std::min(std::ceil(made.back().end() * 10) / 10, last_event_time);
        c.scene.duration = std::max(c.scene.duration, last);
    });
    editor.selected.clear();
    for (std::size_t i = 0; i < made.size(); ++i) editor.selected.push_back(there + i);
}

void ToolHold::cancel(Editor& editor) {
    if (!on_) return;
    editor.preview.take_tool_off(editor.timeline.time);
    stop(editor);
    editor.seek(began_);
}

void ToolHold::update(Editor& editor, bool held) {
    if (!on_) return;
    if (until_ > 0 ? editor.timeline.time >= until_ : !held) return end(editor);
    editor.preview.move_tool(editor.timeline.time, place_);
}

}  // namespace lapfx::app
