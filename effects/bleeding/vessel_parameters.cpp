// The parameters of vessel density (paper: figure 9): where the organ's texture shows vessels. None can be
// tuned yet; the group is there so that presets that name it load.
#include "preset/tables.h"

namespace lapfx::preset {

Table vessels_table() {
    return table<&Preset::vessels>("vessels", "Vessels",
                                   "Where the organ's texture shows vessels; nothing to tune yet.", {});
}

}  // namespace lapfx::preset
