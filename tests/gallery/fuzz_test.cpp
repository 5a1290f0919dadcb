// Random events over all pages. LAPFX_FUZZ_EVENTS is their number (30,000 if not given), LAPFX_FUZZ_SEED the seed (1).
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "gallery/gallery.h"
#include "ui/core/node.h"
#include "ui/support/harness.h"

namespace lapfx::gallery {
namespace {

using ui::Event;
using ui::EventKind;
using ui::Key;
using ui::Mods;
using ui::Node;

unsigned long from_environment(const char* name, unsigned long standard) {
    const char* text = std::getenv(name);
    return text == nullptr ? standard : std::strtoul(text, nullptr, 10);
}

class Fuzz {
  public:
    explicit Fuzz(unsigned long seed)
        : random_(seed), harness_([this](ui::Ui& u) { build(u, state_); }, {1100, 700}, 1, &state_.commands) {
        harness_.ui().redraw(now_);
    }

    /// Sends one event, or a few before the next frame, and then checks everything.
    void step() {
        if (chance(0.002)) rearrange();
        if (chance(0.02))
            harness_.clipboard().text = pick<std::string>({"", "12.5", "#ff8800", "a b\nc", "\xff\xfe", "é🙂"});
        const int events = chance(0.1) ? number(1, 6) : 1;
        for (int i = 1; i < events; ++i) harness_.ui().push(event());
        const Event last = event();
        harness_.send(last);
        look();
    }

    void let_go() {
        harness_.send({.kind = EventKind::focus_lost});
        for (const ui::Button button : {ui::Button::left, ui::Button::right, ui::Button::middle})
            EXPECT_EQ(harness_.ui().held(button), 0U);
        EXPECT_FALSE(harness_.output().pointer_locked);
    }

  private:
    bool chance(double share) { return std::uniform_real_distribution<>(0, 1)(random_) < share; }
    int number(int low, int high) { return std::uniform_int_distribution<>(low, high)(random_); }
    template <typename T>
    T pick(std::initializer_list<T> all) {
        return all.begin()[number(0, static_cast<int>(all.size()) - 1)];
    }

    void rearrange() {
        state_.page = number(0, static_cast<int>(pages().size()) - 1);
        state_.bare = chance(0.5);
        harness_.scale = pick({0.75F, 1.0F, 1.25F, 2.0F, 3.0F});
        harness_.size = {number(1, 1600), number(1, 1000)};
    }

    /// A place, mostly on a widget: events on empty space find few faults.
    glm::vec2 place() {
        const auto tree = harness_.ui().tree();
        if (chance(0.15) || tree.empty()) return {number(-200, 1800), number(-200, 1200)};
        const Node& node = tree[static_cast<std::size_t>(number(0, static_cast<int>(tree.size()) - 1))];
        return node.rect().at() + node.rect().size() * glm::vec2(number(0, 100), number(0, 100)) / 100.0F;
    }

    Key key() {
        if (chance(0.3)) return static_cast<Key>(number(' ', '`'));
        return pick({Key::escape, Key::enter, Key::tab,  Key::backspace, Key::insert,  Key::del,
                     Key::left,   Key::right, Key::up,   Key::down,      Key::page_up, Key::page_down,
                     Key::home,   Key::end,   Key::menu, Key::f1,        Key::f2,      Key::f6,
                     Key::space,  Key::enter, Key::tab,  Key::down,      Key::none,    Key::f12});
    }

    Event event() {
        const Mods mods = static_cast<Mods>(chance(0.7) ? 0 : number(0, 7));
        const ui::Button button = chance(0.8) ? ui::Button::left : pick({ui::Button::right, ui::Button::middle});
        switch (number(0, 15)) {
            case 0:
            case 1:
            case 2:
            case 3:
                return {.kind = EventKind::pointer, .mods = mods, .at = place()};
            case 4:
            case 5:
            case 6:
                return {.kind = EventKind::press, .button = button, .mods = mods, .at = place()};
            case 7:
            case 8:
                return {.kind = EventKind::release, .button = button, .mods = mods, .at = place()};
            case 9:
                return {.kind = EventKind::wheel, .mods = mods, .delta = {number(-1, 1), number(-3, 3)}};
            case 10:
            case 11:
            case 12:
                return {.kind = EventKind::key, .mods = mods, .key = key(), .repeat = chance(0.2)};
            case 13:
                return {.kind = EventKind::text,
                        .codepoint =
                            pick<char32_t>({'1', '9', '-', '.', 'a', 'k', '(', '*', ' ', 0xe9, 0x1f642, 0x301, 0})};
            case 14:
                return {.kind = EventKind::key_up, .key = key()};
            default:
                break;
        }
        if (chance(0.3)) return {.kind = EventKind::drop, .at = place(), .paths = "/a/b.mov\n/c.json"};
        if (chance(0.3)) return {.kind = EventKind::focus_lost};
        if (chance(0.1)) return {.kind = EventKind::pointer, .at = {NAN, INFINITY}};
        return {.kind = EventKind::pointer_out};
    }

    void look() {
        const ui::Ui& ui = harness_.ui();
        // Parts that are reused from the last frame are the same as drawn now, and every change is reported.
        std::swap(before_, now_);
        harness_.ui().redraw(now_);
        ASSERT_TRUE(same_picture(*harness_.output().list, now_)) << harness_.dump();
        if (!harness_.output().changed) {
            ASSERT_TRUE(same_picture(before_, now_)) << harness_.dump();
        }
        bool focus_lives = ui.focus() == 0;
        for (const Node& node : ui.tree()) {
            if (node.id == ui.focus() && node.id != 0) focus_lives = true;
            if (node.number == nullptr) continue;
            ASSERT_TRUE(std::isfinite(node.number->value)) << node.label << "\n" << harness_.dump();
            ASSERT_LE(node.number->minimum, node.number->maximum) << node.label;
        }
        ASSERT_TRUE(focus_lives) << harness_.dump();
        ASSERT_EQ(ui.duplicates(), 0U) << harness_.dump();
    }

    ui::DrawList before_, now_;
    std::mt19937 random_;
    ui::ImageStore images_;
    State state_{images_};
    ui::Harness harness_;
};

TEST(GalleryFuzz, KeepsItsHeadWhateverIsDone) {
    const unsigned long seed = from_environment("LAPFX_FUZZ_SEED", 1);
    const unsigned long count = from_environment("LAPFX_FUZZ_EVENTS", 30000);
    Fuzz fuzz(seed);
    for (unsigned long i = 0; i < count; ++i) {
        SCOPED_TRACE("event " + std::to_string(i) + ", seed " + std::to_string(seed));
        fuzz.step();
        if (testing::Test::HasFatalFailure()) return;
    }
    fuzz.let_go();
}

}  // namespace
}  // namespace lapfx::gallery
