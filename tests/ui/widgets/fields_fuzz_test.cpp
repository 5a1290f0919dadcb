// Random input to all fields: nothing breaks, and every edit that began also ends.
#include <random>

#include "ui/support/harness.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/color_field.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/text_field.h"

namespace lapfx::ui {
namespace {

struct Gestures {
    const char* name;
    bool open = false;
    void take(const Edit& edit) {
        // In one build, an edit may end and the next one begin, or an edit may begin and end.
        const bool ends = edit.committed || edit.cancelled;
        if (edit.began) {
            EXPECT_TRUE(!open || ends) << name << ": began twice";
        }
        if (ends) {
            EXPECT_TRUE(open || edit.began) << name << ": ended without a begin";
        }
        if (edit.changed) {
            EXPECT_TRUE(open || edit.began) << name << ": changed without a begin";
        }
        open = edit.began ? !ends || open : open && !ends;
    }
};

struct Fields {
    std::string text = "text", search = "search";
    int mode = 1, view = 0;
    Color key = rgb(0x2f9e44);
    Gestures gestures[5] = {{"text"}, {"search"}, {"mode"}, {"view"}, {"key"}};

    void build(Ui& u) {
        static constexpr std::string_view modes[] = {"Normal", "Screen", "Add", "Multiply", "",   "Add", "\xff",
                                                     "8",      "9",      "10",  "11",       "12", "13"};
        gestures[0].take(text_field(u, "Text", text));
        gestures[1].take(search_field(u, "Search", search));
        gestures[2].take(combo(u, "Mode", mode, modes));
        gestures[3].take(segmented(u, "View", view, std::span(modes).first(3)));
        gestures[4].take(color_field(u, "Key", key, {.alpha = true}));
    }
};

Event random_event(std::mt19937& random, glm::vec2 size) {
    static constexpr Key keys[] = {Key::enter,     Key::escape, Key::tab,    Key::backspace, Key::del,
                                   Key::left,      Key::right,  Key::up,     Key::down,      Key::page_up,
                                   Key::page_down, Key::home,   Key::end,    Key::space,     key_of('A'),
                                   key_of('C'),    key_of('V'), key_of('X'), key_of('Z'),    key_of('Y')};
    static constexpr char32_t letters[] = {'a', ' ', 'w', '1', '#', 'f', 0xe9, 0x301, 0x6f22, 0x1F600, '\n', 7};
    const auto any = [&](auto& from) { return from[random() % std::size(from)]; };
    Event event;
    event.mods = static_cast<Mods>(random() % 8 < 5 ? 0 : random() % 4);
    event.at = size * glm::vec2(static_cast<float>(random() % 1000), static_cast<float>(random() % 1000)) / 1000.0F;
    switch (random() % 12) {
        case 0:
        case 1:
            event.kind = EventKind::press;
            if (random() % 8 == 0) event.button = Button::right;
            break;
        case 2:
        case 3:
            event.kind = EventKind::release;
            if (random() % 8 == 0) event.button = Button::right;
            break;
        case 4:
        case 5:
            event.kind = EventKind::pointer;
            break;
        case 6:
            event.kind = random() % 10 == 0 ? EventKind::focus_lost : EventKind::wheel;
            event.delta = {0, static_cast<float>(random() % 5) - 2};
            break;
        case 7:
        case 8:
            event.kind = EventKind::text;
            event.codepoint = any(letters);
            break;
        default:
            event.kind = EventKind::key;
            event.key = any(keys);
    }
    return event;
}

TEST(FieldsFuzz, EveryEditEndsAndAllValuesStayInRange) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        std::mt19937 random(seed);
        Fields fields;
        Harness ui([&](Ui& u) { fields.build(u); }, {300, 420});
        for (int i = 0; i < 6000; ++i) {
            for (std::size_t n = random() % 3; n > 0; --n) {
                Event event = random_event(random, glm::vec2(ui.size));
                event.time = ui.time;
                ui.ui().push(std::move(event));
            }
            ui.frame(random() % 20 == 0 ? 1.0 : 0.01);
            ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", frame " << i << "\n" << ui.dump();
            ASSERT_TRUE(fields.mode >= 0 && fields.mode < 13);
            ASSERT_TRUE(fields.view >= 0 && fields.view < 3);
            ASSERT_EQ(ui.ui().duplicates(), 0U);
            if (fields.text.size() > 2000) fields.text = "short";
            if (ui.clipboard().text.size() > 200) ui.clipboard().text = "pasted";
        }
        ui.ui().push({.kind = EventKind::focus_lost, .time = ui.time});
        for (int i = 0; i < 4; ++i) ui.key(Key::escape).key(Key::tab);
        ui.ui().set_focus(0);
        ui.frame();
        ui.frame();
        for (const Gestures& each : fields.gestures) EXPECT_FALSE(each.open) << each.name << " never ended";
    }
}

}  // namespace
}  // namespace lapfx::ui
