// What the user chose, kept as settings.json in the config folder: read at start, written a moment after it has
// changed.
//
//     Settings settings(folders);         // as it was left; a broken file is put aside and told
//     settings.connect(commands, layouts, file_dialog, notices);  // once all commands are there
//     each frame:  settings.update(now);
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/settling.h"
#include "app/base/window_place.h"
#include "document/folders.h"
#include "ui/shell/commands.h"
#include "ui/shell/file_dialog.h"
#include "ui/widgets/dock_layout.h"

namespace lapfx::app {

class Layouts;
class Notices;

class Settings {
  public:
    explicit Settings(document::Folders folders);

    bool light = false;  ///< theme
    float scale = 0;     ///< of the UI; 0: the screen's
    bool reduced_motion = false;
    bool half_resolution = false;     ///< the view is drawn with half of the pixels on each side
    bool hint_seen = false;           ///< the three lines of the first run
    WindowPlace window;               ///< where it was last
    std::vector<std::string> recent;  ///< files, the newest first
    /// Keys of parameters that are listed first: what Halic et al. tune.
    std::vector<std::string> favourites = {"smoke.keying.luma_low", "bleeding.noise_scale", "bleeding.speed",
                                           "bleeding.max_extent"};
    std::vector<std::string> preset_folders;  ///< that the preset browser looks into besides its own
    std::vector<std::string> preset_stars;    ///< files of presets

    /// A file was opened or saved: it becomes the newest of the recent ones.
    void note_recent(const std::string& file);
    /// Removes those of these files that do not exist any more from the recent ones.
    void forget_missing(const std::vector<std::string>& files);
    /// The folder in which files of a kind were last chosen, by the title of the dialog; empty: none yet.
    std::string last_folder(const std::string& title) const;
    void note_folder(const std::string& title, std::string_view folder) { last_folders_[title] = folder; }
    const document::Folders& folders() const { return folders_; }

    /// Gives these what was kept of them (keys, layouts, folders), tells what was wrong, and from now on keeps what
    /// they have. Before it nothing is written. All must outlive it.
    void connect(ui::CommandTable& commands, Layouts& layouts, ui::FileDialog& dialog, Notices& notices);
    /// Once before each frame. `now`: s.
    void update(double now);
    /// When update() is wanted at the latest, s; infinite: there is nothing to write.
    double due() const { return settling_.due(); }
    /// Writes the settings at once if anything has changed. A failure is reported only once.
    void write();

  private:
    /// All that is written, to see whether it has changed without making a text of it each frame.
    struct State {
        bool light = false, reduced_motion = false, half_resolution = false, hint_seen = false;
        float scale = 0;
        WindowPlace window;
        std::vector<std::string> recent, favourites, file_folders, preset_folders, preset_stars;
        std::map<std::string, std::string> last_folders;
        std::string layout_name;
        ui::DockLayout shown;
        std::uint32_t commands = 0, own_layouts = 0;  ///< versions
        friend bool operator==(const State&, const State&) = default;
    };
    void read();
    void apply(const std::string& text);
    State state() const;
    std::string text() const;

    document::Folders folders_;
    std::map<std::string, std::string> last_folders_;
    std::string read_;  ///< the file's text: what is unknown in it is kept
    std::string layouts_text_, keys_text_, layout_name_;
    std::vector<std::string> file_folders_, faults_;
    State written_;
    struct Parts {
        ui::CommandTable* commands = nullptr;
        Layouts* layouts = nullptr;
        ui::FileDialog* dialog = nullptr;
        Notices* notices = nullptr;
    };
    bool connected() const { return parts_.commands != nullptr; }
    Parts parts_;  ///< that have been connected
    bool told_ = false;
    Settling settling_{1, 1};  ///< written 1 s after the first change
};

}  // namespace lapfx::app
