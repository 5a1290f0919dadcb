#include "ui/value/closed_list.h"

#include <cstdint>

#include "ui/paint/painter.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

enum class Fruit : std::uint8_t { apple, pear, plum };
struct Row {
    Fruit value;
};

constexpr Row all[] = {{Fruit::apple}, {Fruit::pear}, {Fruit::plum}};
constexpr Row last_missing[] = {{Fruit::apple}, {Fruit::pear}};
constexpr Row swapped[] = {{Fruit::apple}, {Fruit::plum}, {Fruit::pear}};
constexpr Row twice[] = {{Fruit::apple}, {Fruit::pear}, {Fruit::pear}};
constexpr Row too_many[] = {{Fruit::apple}, {Fruit::pear}, {Fruit::plum}, {static_cast<Fruit>(3)}};
static_assert(is_whole(all));
static_assert(!is_whole(last_missing));
static_assert(!is_whole(swapped));
static_assert(!is_whole(twice));
static_assert(!is_whole(too_many));

TEST(ClosedList, NamesAreThoseOfTheirValues) {
    EXPECT_EQ(name_of(Role::text_field), "text field");
    EXPECT_EQ(name_of(Role::link), "link");
    EXPECT_EQ(name_of(Icon::chevron_right), "chevron right");
    EXPECT_EQ(name_of(Icon::sort_down), "sort down");
    EXPECT_TRUE(arrows_move_focus(Role::menu));
    EXPECT_FALSE(arrows_move_focus(Role::slider));
}

}  // namespace
}  // namespace lapfx::ui
