#include <algorithm>
#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/widgets/thumbnails.h"

namespace lapfx::gallery {

namespace {

void sort_clips(ListsState& s) {
    const auto before = [&](std::size_t a, std::size_t b) {
        const Clip &p = s.clips[a], &q = s.clips[b];
        switch (s.table.sort_column) {
            case 1:
                return p.seconds < q.seconds;
            case 2:
                return p.codec < q.codec;
            default:
                return p.name < q.name;
        }
    };
    std::stable_sort(s.order.begin(), s.order.end(),
                     [&](std::size_t a, std::size_t b) { return s.table.descending ? before(b, a) : before(a, b); });
}

ui::TableCell cell_of(const Clip& clip, std::size_t column) {
    switch (column) {
        case 0:
            return {.text = clip.name, .icon = ui::Icon::image};
        case 1:
            return {.text = clip.length, .number = true};
        case 2:
            return {.text = clip.codec, .tone = ui::Tone::dim};
        default:
            return {.text = clip.keyed ? "keyed" : "no key", .tone = clip.keyed ? ui::Tone::good : ui::Tone::warning};
    }
}

void clip_table(ui::Ui& ui, ListsState& s) {
    constexpr std::array columns = {ui::TableColumn{"Name", 11}, ui::TableColumn{"Length", 5, ui::Align::end},
                                    ui::TableColumn{"Codec", 7}, ui::TableColumn{"State", 5, ui::Align::start, false}};
    const auto key_of = [&](std::size_t row) { return static_cast<std::uint64_t>(s.order[row]); };
    const ui::RowList::KeyOf key(key_of);
    const auto events =
        ui::table(ui, "Clips", s.table, columns, s.order.size(),
                  [&](std::size_t row, std::size_t column) { return cell_of(s.clips[s.order[row]], column); },
                  {.multiple = true, .height = ui::px(ui.em(17)), .key_of = &key});
    if (events.sorted) sort_clips(s);
}

void preset_grid(ui::Ui& ui, ListsState& s) {
    const auto events = ui::thumbnails(
        ui, "Presets", s.presets, 60,
        [&](std::size_t i) {
            const Clip& clip = s.clips[i];
            return ui::Thumbnail{.label = clip.name, .image = clip.image, .star = clip.star, .changed = i % 9 == 4};
        },
        {.height = ui::px(ui.em(17))});
    if (events.marked != ui::no_row) s.clips[events.marked].star = !s.clips[events.marked].star;
}

}  // namespace

void lists_page(ui::Ui& ui, State& state) {
    ListsState& s = state.lists;
    {
        const Part part(ui, "Table");
        clip_table(ui, s);
    }
    const Part part(ui, "Thumbnails");
    preset_grid(ui, s);
}

}  // namespace lapfx::gallery
