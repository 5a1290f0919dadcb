// A param that changes by 1 mm/s for each px, with another one below it, for the tests of params.
#pragma once

#include <gmock/gmock.h>
#include <cmath>
#include <numbers>
#include "ui/core/node.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/param.h"

namespace lapfx::ui {

/// Counts what the edits of a param reported.
struct Edits {
    int began = 0, changed = 0, committed = 0, cancelled = 0;
    void add(const Edit& e) {
        began += e.began, changed += e.changed, committed += e.committed, cancelled += e.cancelled;
    }
};

/// Records the chords that no widget wanted.
struct Chords : Shortcuts {
    std::vector<Key> keys;
    bool press(Key key, Mods) override {
        keys.push_back(key);
        return false;
    }
};

/// "Speed", 1 mm/s for each px, and "Size" below it.
class Param : public testing::Test {
  protected:
    Param() { ui.frame(); }

    void build(Ui& u) {
        Column column(u, {.width = px(640)});
        u.push_disabled(disabled);
        edits.add(param(u, "Speed", speed, options, &actions));
        u.pop_disabled();
        param(u, "Size", size, {.maximum = 100, .step = 1, .standard = 10});
        button(u, "Else");
    }
    glm::vec2 field_center() { return ui.rect("Speed").at() + ui.rect("Speed").size() * glm::vec2(0.7F, 0.5F); }
    std::string said() {  ///< in a tooltip
        for (const Node& node : ui.ui().tree())
            if (node.role == Role::tooltip) return std::string(node.text);
        return {};
    }
    std::string menu(std::string_view item) { return "Speed menu/" + std::string(item); }

    double speed = 100, size = 20;
    bool disabled = false;
    ParamOptions options{.minimum = 0,
                         .maximum = 352,  // the width of the field in px
                         .hard_minimum = -1000,
                         .hard_maximum = 1000,
                         .step = 5,
                         .unit = "mm/s",
                         .standard = 100,
                         .decimals = -1,
                         .tip = "How fast blood flows"};
    ParamActions actions;
    Edits edits;
    Chords chords;
    Harness ui{[this](Ui& u) { build(u); }, {640, 480}, 1, &chords};
};

}  // namespace lapfx::ui
