#include "ui/support/harness.h"

#include <stdexcept>

#include "ui/core/tree.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {

Fonts& Harness::fonts() {
    static Fonts fonts({.family = "Inter", .hinting = Hinting::slight});
    return fonts;
}

Harness::Harness(std::function<void(Ui&)> build, glm::ivec2 frame_size, float frame_scale, Shortcuts* shortcuts,
                 ImageStore* images)
    : size(frame_size),
      scale(frame_scale),
      build_(std::move(build)),
      ui_(fonts(),
          {.clipboard = &clipboard_, .images = images != nullptr ? images : &images_, .shortcuts = shortcuts}) {
    frame();
}

Harness& Harness::frame(double seconds) {
    time += seconds;
    const auto build = [this] { output_ = &ui_.frame({.size = size, .scale = scale, .time = time}, build_); };
    if (around_)
        around_(time, build);
    else
        build();
    return *this;
}

Harness& Harness::around(std::function<void(double, const std::function<void()>&)> frame) {
    around_ = std::move(frame);
    return this->frame();
}

Harness& Harness::settle() {
    for (int i = 0; i < 20; ++i) {
        if (output_->wake_at > time + 0.1) return *this;
        frame();
    }
    throw std::runtime_error("asks for frames without end: " + std::string(ui_.wake_reasons().back().reason));
}

Harness& Harness::send(Event event) {
    event.time = time;
    if (event.kind != EventKind::pointer && event.kind != EventKind::press && event.kind != EventKind::release &&
        event.kind != EventKind::drop)
        event.at = pointer_;
    pointer_ = event.at;
    ui_.push(std::move(event));
    return frame();
}

glm::vec2 Harness::reach(std::string_view path, glm::vec2 at) {
    ui_.reveal(node(path).id);
    frame();
    const Node& target = node(path);
    const glm::vec2 place = target.rect().at() + target.rect().size() * at;
    if (!target.clip.contains(place)) throw std::runtime_error(std::string(path) + " is clipped away\n" + dump());
    for (const Node& other : ui_.tree()) {
        if (other.layer > target.layer && other.overlay && other.rect().contains(place) && other.role != Role::tooltip)
            throw std::runtime_error(std::string(path) + " is covered by " + std::string(other.label) + "\n" + dump());
    }
    return place;
}

Harness& Harness::move(glm::vec2 to) {
    return send({.kind = EventKind::pointer, .at = to});
}

Harness& Harness::move_to(std::string_view path, glm::vec2 at) {
    return move(reach(path, at));
}

Harness& Harness::click(std::string_view path, const Click& click) {
    const glm::vec2 at = reach(path, click.at);
    move(at);
    for (int i = 0; i < click.clicks; ++i) {
        send({.kind = EventKind::press, .button = click.button, .mods = click.mods, .at = at});
        send({.kind = EventKind::release, .button = click.button, .mods = click.mods, .at = at});
    }
    return frame(click.clicks > 1 ? 1.0 / 60 : 0.5);  // the next click does not count as a double click then
}

Harness& Harness::press(std::string_view path, glm::vec2 at, Mods mods) {
    const glm::vec2 place = reach(path, at);
    move(place);
    return send({.kind = EventKind::press, .mods = mods, .at = place});
}

Harness& Harness::drag_by(glm::vec2 px, Mods mods) {
    const glm::vec2 from = pointer_;
    for (int i = 1; i <= 4; ++i)
        send({.kind = EventKind::pointer, .mods = mods, .at = from + px * (static_cast<float>(i) / 4)});
    return *this;
}

Harness& Harness::release(Mods mods) {
    send({.kind = EventKind::release, .mods = mods, .at = pointer_});
    return frame(0.5);
}

Harness& Harness::drag(std::string_view path, glm::vec2 px, Mods mods) {
    return press(path, {0.5F, 0.5F}, mods).drag_by(px, mods).release(mods);
}

Harness& Harness::wheel(std::string_view path, glm::vec2 notches, Mods mods) {
    move_to(path);
    return send({.kind = EventKind::wheel, .mods = mods, .delta = notches});
}

Harness& Harness::key(Key key, Mods mods) {
    send({.kind = EventKind::key, .mods = mods, .key = key});
    return send({.kind = EventKind::key_up, .mods = mods, .key = key});
}

Harness& Harness::type(std::string_view utf8) {
    while (!utf8.empty()) {
        const Decoded c = decode(utf8);
        if (c.codepoint < 128) send({.kind = EventKind::key, .key = key_of(static_cast<char>(c.codepoint))});
        send({.kind = EventKind::text, .codepoint = c.codepoint});
        if (c.codepoint < 128) send({.kind = EventKind::key_up, .key = key_of(static_cast<char>(c.codepoint))});
        utf8.remove_prefix(c.bytes);
    }
    return *this;
}

Harness& Harness::drop(std::string_view path, const std::string& files) {
    return send({.kind = EventKind::drop, .at = reach(path, {0.5F, 0.5F}), .paths = files});
}

Harness& Harness::focus(std::string_view path) {
    for (std::size_t i = 0; i < ui_.tree().size(); ++i) {
        if (node(path).id == ui_.focus()) return *this;
        key(Key::tab);
    }
    throw std::runtime_error(std::string(path) + " cannot be reached by Tab\n" + dump());
}

const Node& Harness::node(std::string_view path) const {
    return ui_.tree()[find(ui_.tree(), path)];
}

double Harness::value(std::string_view path) const {
    const Node& n = node(path);
    if (n.number == nullptr) throw std::runtime_error(std::string(path) + " has no value\n" + dump());
    return n.number->value;
}

std::string Harness::text(std::string_view path) const {
    return std::string(node(path).text);
}
std::string Harness::tip(std::string_view path) const {
    return std::string(node(path).tip);
}
bool Harness::is(std::string_view path, Is state) const {
    return has(node(path).is, state);
}
Rect Harness::rect(std::string_view path) const {
    return node(path).rect();
}
bool Harness::exists(std::string_view path) const {
    return ui::exists(ui_.tree(), path);
}
std::string Harness::dump() const {
    return dump_text(ui_.tree());
}

std::string Harness::focused() const {
    for (std::uint32_t i = 0; i < ui_.tree().size(); ++i) {
        if (ui_.focus() != 0 && ui_.tree()[i].id == ui_.focus()) return path_of(ui_.tree(), i);
    }
    return "";
}

}  // namespace lapfx::ui
