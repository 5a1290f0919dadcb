// Layouts without a window: the test gives them the list of panels.
#include "app/base/layouts.h"
#include <gmock/gmock.h>

#include <stdexcept>

#include "panels/panels.h"
#include "panels/standard_layouts.h"

namespace lapfx::test {
namespace {

ui::DockLayout two() {
    return ui::dock_split(ui::Axis::x, 0.5F, ui::dock_tabs({"View"}), ui::dock_tabs({"Preset"}));
}

TEST(Layouts, APanelThatNoneNamesComesIntoTheFirstGroup) {
    app::Layouts layouts;
    layouts.set_panels({"View", "Preset", "New"}, {{"Two", two}});
    EXPECT_EQ(layouts.name(), "Two");
    EXPECT_EQ(layouts.shown.find("New"), layouts.shown.find("View"));
    EXPECT_TRUE(layouts.seen("View")) << "it does not come before those that are named";
    layouts.bring_to_front("New");
    EXPECT_TRUE(layouts.seen("New"));
    EXPECT_FALSE(layouts.seen("View"));
}

TEST(Layouts, APanelThatIsNoneIsAMistakeOfTheProgram) {
    app::Layouts layouts;
    EXPECT_THROW(layouts.set_panels({"View"}, {{"Two", two}}), std::logic_error);
    layouts.set_panels({"View", "Preset"}, {{"Two", two}});
    EXPECT_THROW(layouts.bring_to_front("Veiw"), std::logic_error);
}

/// A panel that a layout leaves out would come into its first group by itself, which nobody has chosen.
TEST(Layouts, EachStandardOneNamesEveryPanelOnce) {
    const std::vector<std::string_view> all = panels::panel_names();
    EXPECT_GE(all.size(), 14U);
    for (const app::StandardLayout& layout : panels::standard_layouts()) {
        std::vector<std::string> tabs;
        for (const ui::DockNode& node : layout.make().nodes)
            tabs.insert(tabs.end(), node.tabs.begin(), node.tabs.end());
        EXPECT_THAT(tabs, testing::UnorderedElementsAreArray(all)) << layout.name;
    }
}

}  // namespace
}  // namespace lapfx::test
