// Presets with thumbnails: found by name, tag and star, opened or taken over with one press.
#include "app/base/file_chooser.h"
#include "app/browser/browser.h"
#include "app/files/files.h"
#include "panels/panels.h"
#include "ui/core/node.h"
#include "ui/shell/dialog.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/text_field.h"
#include "ui/widgets/thumbnails.h"

namespace lapfx::panels {

namespace {

using app::Browser;
using app::PresetFile;
using app::PresetOrder;
using ui::Icon;

constexpr std::string_view item_menu = "preset file menu", view_menu = "presets menu", open_question = "open preset";

/// What the panel works on.
struct On {
    Browser& browser;
    const document::Document& document;
    app::Files& files;
    ui::Toasts& notices;
};

struct Browsing {
    ui::Selection selection;
    std::uint64_t current = ui::no_key;  ///< the one that is open, as it was selected last
    std::uint64_t asked = ui::no_key;    ///< key of the preset that the question is about
    std::uint64_t menu_of = ui::no_key;  ///< key of the preset that the menu is about
};

/// The number of the file with this key; ui::no_row where it is gone.
std::size_t file_of(const Browser& browser, std::uint64_t key) {
    for (std::size_t i = 0; i < browser.files().size(); ++i)
        if (browser.files()[i].key == key) return i;
    return ui::no_row;
}

void open(ui::Ui& ui, const On& on, Browsing& b, std::size_t file) {
    const PresetFile& preset = on.browser.files()[file];
    if (!preset.fault.empty()) {
        on.notices.add({.kind = ui::ToastKind::error, .text = preset.fault});
    } else if (on.document.preset_unsaved()) {
        b.asked = preset.key;
        ui::open_dialog(ui, open_question);
    } else {
        on.files.open_anyway({preset.file.string()});
    }
}

/// Opening would lose unsaved work. Taking only the values can be undone.
void question(ui::Ui& ui, const On& on, Browsing& b) {
    if (b.asked == ui::no_key) return;
    const std::size_t file = file_of(on.browser, b.asked);
    if (file == ui::no_row) {
        b.asked = ui::no_key;
        return;
    }
    const std::string& name = on.browser.files()[file].name;
    const auto answer =
        ui::ask(ui, open_question, "Open preset",
                ui.join({"The preset that is open has unsaved changes. \"", name,
                         "\" can replace it, or only pass its values on to it, which Undo takes back."}),
                {{.label = "Cancel", .cancel = true, .tip = "Nothing changes"},
                 {.label = "Open, discard changes", .tip = "Unsaved changes are lost"},
                 {.label = "Take its values", .standard = true, .tip = "One undo step; name and file stay"}},
                ui::Tone::warning);
    if (!answer) return;
    b.asked = ui::no_key;
    if (*answer == 1) on.files.open_anyway({on.browser.files()[file].file.string()});
    if (*answer == 2) on.browser.take_values(file);
}

void ask_folder(Browser& browser, app::FileChooser& chooser) {
    chooser.ask({.task = ui::FileTask::folder, .title = "Add a folder of presets"},
                [&browser](const std::vector<std::string>& folders) {
                    for (const std::string& folder : folders) browser.add_folder(folder);
                });
}

void view_items(ui::Ui& ui, Browser& browser, app::FileChooser& chooser) {
    if (ui::menu_item(ui, "By name", {.checked = browser.order == PresetOrder::name}))
        browser.order = PresetOrder::name;
    if (ui::menu_item(ui, "Newest first", {.checked = browser.order == PresetOrder::newest}))
        browser.order = PresetOrder::newest;
    ui::menu_separator(ui);
    if (ui::menu_item(ui, "Look again", {.icon = Icon::reset, .tip = "Reads the folders again"})) browser.reload();
    if (ui::menu_item(ui, "Add folder...", {.icon = Icon::folder})) ask_folder(browser, chooser);
    const std::vector<std::string>& folders = browser.own_folders();
    for (std::size_t i = 0; i < folders.size(); ++i) {
        if (!ui::menu_item(ui, ui.join({"Remove ", folders[i]}), {.tip = "Its files stay where they are"})) continue;
        browser.remove_folder(folders[i]);
        break;
    }
}

/// Shows as many tags as there is room for. The others are in the menu after them.
void tag_chips(ui::Ui& ui, Browser& browser, float room) {
    std::size_t shown = 0;
    const std::vector<std::string>& tags = browser.tags();
    for (; shown < tags.size(); ++shown) {
        const float width = ui.text_width(tags[shown]) + ui.em(1.6F) + ui.em(ui.theme().gap);
        const bool rest = shown + 1 < tags.size();
        if (width + (rest ? ui.em(2) : 0) > room) break;
        room -= width;
        bool on = browser.has_tag(tags[shown]);
        if (ui::toggle(ui, tags[shown], on, {.tip = "Only presets with this tag"})) browser.choose_tag(tags[shown], on);
    }
    if (shown == tags.size()) return;
    constexpr std::string_view menu_name = "tags menu";
    const ui::Id id = ui.id_of("More tags");
    if (ui::icon_button(ui, Icon::chevron_down, "More tags", {.quiet = true}))
        ui::open_menu(ui, menu_name, {.side = ui::Placement::Side::below, .anchor = id});
    if (const ui::Menu menu(ui, menu_name, "Tags"); menu)
        for (std::size_t i = shown; i < tags.size(); ++i)
            if (ui::menu_item(ui, tags[i], {.checked = browser.has_tag(tags[i])}))
                browser.choose_tag(tags[i], !browser.has_tag(tags[i]));
}

void tool_row(ui::Ui& ui, Browser& browser, app::FileChooser& chooser) {
    ui::Node& bar = ui.open(ui::Role::group, "Filter", ui::Axis::x);
    bar.size[0] = ui::grow();
    bar.gap = ui.em(ui.theme().gap);
    bar.cross = ui::ChildAlign::center;
    const float search = ui.em(14);
    const float room = ui.rect_before(bar.id).w - search - ui.em(6);
    ui.follow_size(bar);
    ui::search_field(ui, "Search", browser.search,
                     {.placeholder = "Find a preset", .tip = "By name, description and tags", .width = ui::px(search)});
    tag_chips(ui, browser, room);
    ui::spacer(ui);
    ui::toggle(ui, "Starred only", browser.stars_only,
               {.icon = browser.stars_only ? Icon::star_filled : Icon::star, .quiet = true});
    const ui::Id id = ui.id_of("More");
    if (ui::icon_button(ui, Icon::menu, "More", {.tip = "Order and folders", .quiet = true}))
        ui::open_menu(ui, view_menu, {.side = ui::Placement::Side::below, .anchor = id});
    if (const ui::Menu menu(ui, view_menu, "Presets menu"); menu) view_items(ui, browser, chooser);
    ui.close();
}

std::string_view why_empty(const Browser& browser) {
    if (browser.files().empty()) return "There is no preset in these folders";
    bool any = false;
    for (std::size_t i = 0; i < browser.files().size() && !any; ++i) any = browser.starred(i);
    if (browser.stars_only && !any)
        return "No preset is starred yet. The star on a preset's picture, or Star in its menu, marks it";
    return browser.stars_only ? "No starred preset matches" : "No preset matches";
}

void item_items(ui::Ui& ui, const On& on, Browsing& b, std::size_t index) {
    Browser& browser = on.browser;
    const PresetFile& file = browser.files()[index];
    const bool usable = file.fault.empty(), starred = browser.starred(index);
    if (ui::menu_item(ui, "Open",
                      {.shortcut = "Enter",
                       .tip = usable ? std::string_view("In place of the open preset") : file.fault,
                       .enabled = usable}))
        open(ui, on, b, index);
    if (ui::menu_item(ui, "Take its values",
                      {.tip = usable ? std::string_view(
                                           "Uses its values in the open preset, in one undo step; name and file stay")
                                     : file.fault,
                       .enabled = usable}))
        browser.take_values(index);
    ui::menu_separator(ui);
    if (ui::menu_item(ui, "Star", {.icon = Icon::star, .checked = starred})) browser.star(index, !starred);
    if (ui::menu_item(ui, "Copy path", {.icon = Icon::copy, .enabled = ui.clipboard() != nullptr}))
        ui.clipboard()->set(file.file.string());
}

void grid(ui::Ui& ui, const On& on, Browsing& b) {
    Browser& browser = on.browser;
    const std::vector<std::size_t>& found = browser.found();
    if (b.current != browser.current_key()) {
        b.current = browser.current_key();
        b.selection.only(b.current);
    }
    const auto item = [&](std::size_t i) -> ui::Thumbnail {
        const std::size_t index = found[i];
        const PresetFile& file = browser.files()[index];
        return {.label = file.fault.empty() ? std::string_view(file.name) : ui.join({"\u26A0 ", file.name}),
                .image = file.image,
                .star = browser.starred(index),
                .changed = browser.current(index) && on.document.preset_unsaved(),
                .tip = file.tip,
                .key = file.key};
    };
    constexpr float aspect =
        static_cast<float>(app::ThumbnailMaker::standard_size.x) / app::ThumbnailMaker::standard_size.y;
    const ui::ThumbnailEvents events =
        ui::thumbnails(ui, "Presets", b.selection, found.size(), item, {.cell = 7.5F, .aspect = aspect});
    if (events.marked != ui::no_row) {
        const std::size_t file = found[events.marked];
        browser.star(file, !browser.starred(file));
        return;  // what was found may be other files now
    }
    if (events.opened != ui::no_row) return open(ui, on, b, found[events.opened]);
    if (events.context != ui::no_row) {
        b.menu_of = browser.files()[found[events.context]].key;
        ui::open_menu(ui, item_menu,
                      {.side = ui::Placement::Side::pointer, .rect = {ui.pointer().x, ui.pointer().y, 0, 0}});
    }
}

}  // namespace

void presets_panel(ui::Ui& ui, Browser& browser, const document::Document& document, app::Files& files,
                   app::FileChooser& chooser, ui::Toasts& notices) {
    const On on{browser, document, files, notices};
    browser.show();
    Browsing& b = ui.memory<Browsing>(ui.id_of("Browsing"));
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow()});
    tool_row(ui, browser, chooser);
    if (browser.found().empty() && !browser.busy())  // above the grid, which takes all the room
        ui::label(ui, why_empty(browser), {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
    grid(ui, on, b);
    if (b.menu_of != ui::no_key) {
        const std::size_t file = file_of(browser, b.menu_of);
        if (const ui::Menu menu(ui, item_menu, "Preset file menu"); menu && file != ui::no_row)
            item_items(ui, on, b, file);
    }
    question(ui, on, b);
}

}  // namespace lapfx::panels
