#include "ui/widgets/table.h"

#include <gmock/gmock.h>

#include <numeric>

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;

constexpr float row = 25;  // px at scale 1

constexpr TableColumn columns[] = {
    {.title = "Name", .width = 10, .tip = "Of the file"},
    {.title = "Length", .width = 6, .align = Align::end},
    {.title = "Kind", .width = 5, .sortable = false},
};

/// `count` clips; clip i is called "Clip i" and is (i * 7) % 100 s long.
struct Clips {
    explicit Clips(std::size_t n) : order(n), ui([this](Ui& u) { build(u); }, {400, 275}) {
        std::iota(order.begin(), order.end(), std::size_t{0});
        ui.frame();
    }
    static std::size_t length(std::size_t clip) { return clip * 7 % 100; }
    void build(Ui& u) {
        char text[32];
        const auto cell = [&](std::size_t line, std::size_t column) {
            if (column == 2) return TableCell{.text = "video", .tone = Tone::dim};
            const bool name = column == 0;
            const std::size_t value = name ? order[line] : length(order[line]);
            const int size = std::snprintf(text, sizeof text, name ? "Clip %zu" : "%zu s", value);
            return TableCell{.text = {text, static_cast<std::size_t>(size)}, .number = !name};
        };
        const auto key = [&](std::size_t line) { return static_cast<std::uint64_t>(order[line]); };
        const RowList::KeyOf key_of = key;
        u.push_disabled(disabled);
        const TableEvents e =
            table(u, "Clips", state, columns, order.size(), cell, {.multiple = multiple, .key_of = &key_of});
        u.pop_disabled();
        if (e.sorted) sort();
        sorted += e.sorted ? 1 : 0;
        selected += e.selected ? 1 : 0;
        if (e.opened != no_row) opened = order[e.opened];
        if (e.context != no_row) context = order[e.context];
    }
    void sort() {
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            if (state.sort_column == 1) a = length(a), b = length(b);
            return state.descending ? a > b : a < b;
        });
    }
    std::vector<std::size_t> order;
    TableState state;
    bool multiple = true, disabled = false;
    int sorted = 0, selected = 0;
    std::size_t opened = no_row, context = no_row;
    Harness ui;
};

TEST(Table, RowsAndCellsAreInTheTree) {
    Clips t(1000);
    EXPECT_EQ(t.ui.node("Clips").role, Role::table);
    EXPECT_EQ(t.ui.node("Clips/Clip 3").role, Role::row);
    EXPECT_EQ(t.ui.text("Clips/Clip 3/Length"), "21 s");
    EXPECT_EQ(t.ui.rect("Clips/Name").y, 0);
    EXPECT_EQ(t.ui.rect("Clips/Clip 0").y, row);
    EXPECT_EQ(t.ui.rect("Clips/Clip 3/Length").x, 140);
    EXPECT_TRUE(t.ui.exists("Clips/Clip 9"));
    EXPECT_FALSE(t.ui.exists("Clips/Clip 10")) << "250 px are left for rows";
    EXPECT_EQ(t.ui.tip("Clips/Name"), "Of the file");
    EXPECT_EQ(t.ui.ui().duplicates(), 0U);
    EXPECT_TRUE(faults_of(t.ui.ui().tree()).empty());
}

TEST(Table, TheHeaderStaysWhenRowsScrollAndGoesSidewaysWithThem) {
    Clips t(1000);
    t.ui.wheel("Clips/Clip 2", {0, -1});
    EXPECT_EQ(t.ui.rect("Clips/Name").y, 0);
    EXPECT_FALSE(t.ui.exists("Clips/Clip 2"));
    t.ui.size = {200, 275};
    t.ui.frame().wheel("Clips/Clip 5", {0, -1}, Mods::shift);
    EXPECT_EQ(t.ui.rect("Clips/Name").x, -75);
    EXPECT_EQ(t.ui.rect("Clips/Clip 5").x, -75);
}

TEST(Table, AClickOnAHeaderSortsAndAnotherTurnsTheOrder) {
    Clips t(100);
    t.ui.click("Clips/Length");
    EXPECT_EQ(t.state.sort_column, 1);
    EXPECT_FALSE(t.state.descending);
    EXPECT_EQ(t.ui.text("Clips/Length"), "ascending");
    EXPECT_EQ(t.ui.rect("Clips/Clip 43").y, 2 * row) << "43 * 7 % 100 is 1";
    t.ui.click("Clips/Length");
    EXPECT_EQ(t.ui.text("Clips/Length"), "descending");
    EXPECT_EQ(t.sorted, 2);
    t.ui.click("Clips/Name");
    EXPECT_FALSE(t.state.descending);
    EXPECT_EQ(t.ui.text("Clips/Length"), "");
    t.ui.click("Clips/Kind");
    EXPECT_EQ(t.sorted, 3) << "by this one it cannot be sorted";
}

TEST(Table, SelectionStaysWithItsRowsWhenTheyAreSorted) {
    Clips t(100);
    t.ui.click("Clips/Clip 1").click("Clips/Name").click("Clips/Name");
    EXPECT_THAT(t.state.selection.keys, ElementsAre(1));
    t.ui.focus("Clips").key(Key::home).key(Key::end);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(0));
    EXPECT_TRUE(t.ui.is("Clips/Clip 0", Is::selected));
}

TEST(Table, PressesSelectOneMoreOrARange) {
    Clips t(100);
    t.ui.click("Clips/Clip 2");
    EXPECT_THAT(t.state.selection.keys, ElementsAre(2));
    EXPECT_EQ(t.ui.focused(), "Clips");
    t.ui.click("Clips/Clip 5", {.mods = Mods::shift});
    EXPECT_THAT(t.state.selection.keys, ElementsAre(2, 3, 4, 5));
    EXPECT_TRUE(t.ui.is("Clips/Clip 3", Is::selected)) << "rows above the one pressed are drawn so at once";
    t.ui.click("Clips/Clip 3", {.mods = Mods::command});
    EXPECT_THAT(t.state.selection.keys, ElementsAre(2, 4, 5));
    t.ui.click("Clips/Clip 8", {.mods = Mods::command});
    EXPECT_THAT(t.state.selection.keys, ElementsAre(2, 4, 5, 8));
    t.ui.click("Clips/Clip 7");
    EXPECT_THAT(t.state.selection.keys, ElementsAre(7));
}

TEST(Table, WhereOnlyOneCanBeSelectedModifiersDoNothing) {
    Clips t(100);
    t.multiple = false;
    t.ui.click("Clips/Clip 2").click("Clips/Clip 5", {.mods = Mods::shift});
    EXPECT_THAT(t.state.selection.keys, ElementsAre(5));
    t.ui.click("Clips/Clip 6", {.mods = Mods::command});
    EXPECT_THAT(t.state.selection.keys, ElementsAre(6));
}

TEST(Table, APressBesideAllRowsSelectsNone) {
    Clips t(3);
    t.ui.click("Clips/Clip 1").click("Clips", {.at = {0.5F, 0.9F}});
    EXPECT_TRUE(t.state.selection.keys.empty());
}

TEST(Table, KeysMoveTheSelectionAndScrollAlong) {
    Clips t(1000);
    t.ui.focus("Clips").key(Key::down);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(0));
    t.ui.key(Key::page_down);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(10));
    EXPECT_EQ(t.ui.rect("Clips/Clip 10").bottom(), 275);
    t.ui.key(Key::end).key(Key::up, Mods::shift);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(998, 999));
    EXPECT_EQ(t.ui.rect("Clips/Clip 999").bottom(), 275);
    t.ui.key(Key::home);
    EXPECT_EQ(t.ui.rect("Clips/Clip 0").y, row) << "below the header, not under it";
    t.ui.key(Key::space);
    EXPECT_TRUE(t.state.selection.keys.empty());
}

TEST(Table, EnterAndADoubleClickOpen) {
    Clips t(100);
    t.ui.click("Clips/Clip 4", {.clicks = 2});
    EXPECT_EQ(t.opened, 4U);
    t.ui.key(Key::down).key(Key::enter);
    EXPECT_EQ(t.opened, 5U);
}

TEST(Table, TheRightButtonAndTheMenuKeyAskForAMenu) {
    Clips t(100);
    t.ui.right_click("Clips/Clip 4");
    EXPECT_EQ(t.context, 4U);
    EXPECT_THAT(t.state.selection.keys, ElementsAre(4));
    t.context = no_row;
    t.ui.key(Key::down).key(Key::menu);
    EXPECT_EQ(t.context, 5U);
    t.ui.click("Clips/Clip 7", {.mods = Mods::shift}).right_click("Clips/Clip 6");
    EXPECT_THAT(t.state.selection.keys, ElementsAre(5, 6, 7)) << "one that is selected leaves the others so";
}

TEST(Table, ColumnsAreResizedByTheirEdges) {
    Clips t(100);
    t.ui.press("Clips/width of Name").drag_by({28, 0});
    EXPECT_FLOAT_EQ(t.state.widths[0], 12);
    EXPECT_EQ(t.ui.rect("Clips/Clip 3/Length").x, 168) << "in the frame of the event";
    t.ui.key(Key::escape).release();
    EXPECT_FLOAT_EQ(t.state.widths[0], 10);
    t.ui.drag("Clips/width of Name", {-1000, 0});
    EXPECT_FLOAT_EQ(t.state.widths[0], 2);
    EXPECT_EQ(t.sorted, 0) << "the edge is no header";
}

TEST(Table, ADoubleClickOnAnEdgeFitsWhatIsSeen) {
    Clips t(100);
    t.ui.click("Clips/width of Kind", {.clicks = 2});
    const float fitted = t.state.widths[2];
    EXPECT_GT(fitted, 2);
    EXPECT_LT(fitted, 5);
    EXPECT_GE(t.ui.rect("Clips/Clip 3/Kind").w, t.ui.ui().text_width("video") + 14);
}

TEST(Table, HeadersAreUsedByKeys) {
    Clips t(100);
    t.ui.focus("Clips/Name").key(Key::right);
    EXPECT_EQ(t.ui.focused(), "Clips/Length");
    t.ui.key(Key::enter);
    EXPECT_EQ(t.state.sort_column, 1);
    t.ui.key(Key::right, Mods::shift).key(Key::right, Mods::shift).key(Key::left, Mods::shift);
    EXPECT_FLOAT_EQ(t.state.widths[1], 7);
    t.ui.key(Key::backspace);
    EXPECT_FLOAT_EQ(t.state.widths[1], 6);
    t.ui.key(Key::left).key(Key::left);
    EXPECT_EQ(t.ui.focused(), "Clips/Name") << "the first is the end";
}

TEST(Table, DisabledItTakesNothing) {
    Clips t(100);
    t.disabled = true;
    t.ui.frame().click("Clips/Clip 2").click("Clips/Length").drag("Clips/width of Name", {28, 0});
    EXPECT_TRUE(t.state.selection.keys.empty());
    EXPECT_EQ(t.sorted, 0);
    EXPECT_FLOAT_EQ(t.state.widths[0], 10);
    EXPECT_EQ(t.ui.key(Key::tab).focused(), "");
}

TEST(Table, NamesAreShownAsTheyAre) {
    TableState state;
    Harness ui([&](Ui& u) {
        table(u, "Files", state, columns, 2,
              [](std::size_t line, std::size_t) { return TableCell{.text = line == 0 ? "a##b###c" : ""}; });
    });
    EXPECT_TRUE(ui.exists("Files/a##b###c"));
    EXPECT_EQ(ui.text("Files/a##b###c/Name"), "a##b###c");
    EXPECT_TRUE(ui.exists("Files/row")) << "one without a name";
}

TEST(Table, WidthsFromABadFileAreBroughtIn) {
    Clips t(10);
    t.state.widths = {-4, std::numeric_limits<float>::quiet_NaN(), 1e9F};
    t.ui.frame();
    EXPECT_THAT(t.state.widths, ElementsAre(2, 8, 100));
    t.state.widths = {1};
    t.ui.frame();
    EXPECT_THAT(t.state.widths, ElementsAre(10, 6, 5));
}

TEST(Table, SteadyFramesAllocateNothing) {
    Clips t(1000);
    for (int i = 0; i < 10; ++i) t.ui.frame();
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 100; ++i) t.ui.frame();
    EXPECT_EQ(test::allocations_so_far() - before, 0U);
}

TEST(Table, ASortedColumnKeepsItsTitleWhereThereIsRoomForIt) {
    constexpr TableColumn narrow[] = {{.title = "Length", .width = 5}, {.title = "Length of it", .width = 5}};
    TableState state;
    Harness ui(
        [&](Ui& u) { table(u, "Clips", state, narrow, 0, [](std::size_t, std::size_t) { return TableCell{}; }); });
    const auto drawn_in = [&](const char* path, InstanceKind kind) {
        const Rect rect = ui.rect(path);
        int count = 0;
        for (const Instance& i : ui.output().list->instances)
            count += i.kind == kind && rect.contains({i.x, i.y}) ? 1 : 0;
        return count;
    };
    const int cut = drawn_in("Clips/Length of it", InstanceKind::glyph);
    EXPECT_EQ(drawn_in("Clips/Length", InstanceKind::glyph), 6);
    EXPECT_EQ(drawn_in("Clips/Length", InstanceKind::line), 0);
    ui.click("Clips/Length");
    EXPECT_EQ(drawn_in("Clips/Length", InstanceKind::glyph), 6);
    EXPECT_GT(drawn_in("Clips/Length", InstanceKind::line), 0) << "the arrow";
    ui.click("Clips/Length of it");
    EXPECT_EQ(drawn_in("Clips/Length of it", InstanceKind::glyph), cut) << "it takes nothing where there is no room";
}

}  // namespace
}  // namespace lapfx::ui
