// What the user chose, kept in the config folder.
#pragma once

#include <string>
#include <vector>

#include "document/folders.h"

namespace lapfx::app {

class Settings {
  public:
    explicit Settings(document::Folders folders) : folders_(std::move(folders)) {}

    bool light = false;  ///< theme
    float scale = 0;     ///< of the UI; 0: the screen's
    bool reduced_motion = false;
    bool hint_seen = false;           ///< the three lines of the first run
    std::vector<std::string> recent;  ///< files, the newest first
    /// Keys of parameters that are listed first: what Halic et al. tune.
    std::vector<std::string> favourites = {"smoke.keying.luma_low", "bleeding.noise_scale", "bleeding.speed",
                                           "bleeding.max_extent"};
    std::vector<std::string> preset_folders;  ///< that the preset browser looks into besides its own
    std::vector<std::string> preset_stars;    ///< files of presets

    void note_recent(const std::string& file);
    const document::Folders& folders() const { return folders_; }

  private:
    document::Folders folders_;
};

}  // namespace lapfx::app
