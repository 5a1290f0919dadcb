#include <algorithm>
#include <set>

#include "document/document.h"
#include "document/tables.h"

namespace lapfx::document {

namespace {

constexpr std::string_view clips = "/smoke/clips/";

/// The fault of a rule between values names only one of them, although another value of the group may be the wrong one.
enum class Reach { value, group };

void put_back(Preset& preset, Preset& good, std::string_view place, Reach reach) {
    if (reach == Reach::group) place = place.substr(0, place.rfind('/'));
    const Spot to = find(preset_table(), &preset, place), from = find(preset_table(), &good, place);
    if (!to || !from) return;
    if (to.row != nullptr && from.row != nullptr)
        copy(*to.row, to.owner, from.owner);
    else if (to.table != nullptr && to.table->list == nullptr)
        copy(*to.table, to.owner, from.owner);
}

void put_back_clip(Preset& preset, const Preset& good, std::size_t index) {
    auto& all = preset.smoke.clips;
    if (index >= all.size()) return;
    const auto& former = good.smoke.clips;
    if (preset.folder == good.folder && index < former.size() && former[index].file == all[index].file)
        all[index] = former[index];
    else
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace

Preset mended(Preset wanted, const Preset& good) {
    Preset from = good;
    for (const Reach reach : {Reach::value, Reach::group}) {
        const std::vector<Fault> faults = check(preset_table(), &wanted);
        if (faults.empty()) return wanted;
        std::set<std::size_t, std::greater<>> bad_clips;  // from the back, so that those before keep their indices
        for (const Fault& fault : faults) {
            if (fault.place.starts_with(clips))
                bad_clips.insert(static_cast<std::size_t>(std::atoi(fault.place.c_str() + clips.size())));
            else
                put_back(wanted, from, fault.place, reach);
        }
        for (const std::size_t clip : bad_clips) put_back_clip(wanted, good, clip);
    }
    return check(preset_table(), &wanted).empty() ? wanted : good;
}

}  // namespace lapfx::document
