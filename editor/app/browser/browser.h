// Presets in folders, with thumbnails: the shipped ones, those next to the open preset, and those in folders that the
// user has added.
//
//     browser.show();                                  // called by the panel in each build: it is visible
//     for (std::size_t i : browser.found()) draw(browser.files()[i]);
//     browser.take_values(i);
//
// A job reads the folders when the panel becomes visible, when the preset was saved and by reload(). Nothing is read or
// rendered for a panel that is not visible. UI thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/base/editor_options.h"
#include "app/browser/thumbnail_maker.h"
#include "document/document.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class Job;
class Jobs;
class Notices;
class Screen;
class Settings;

/// A preset that was found, or a file that could be one and is broken.
struct PresetFile {
    std::filesystem::path file{};
    std::string name{};               ///< the preset's, or the file's
    std::vector<std::string> tags{};  ///< lower case
    std::string words{};              ///< what search looks into
    std::string tip{};
    std::string fault{};  ///< why it cannot be opened; empty: it can
    std::filesystem::file_time_type modified{};
    std::uint64_t key = 0;  ///< of its path
    ui::ImageHandle image = 0;
};

enum class PresetOrder { name, newest };

class Browser {
  public:
    /// All must outlive it.
    Browser(const EditorOptions& options, document::Document& document, Settings& settings, Jobs& jobs,
            ui::ImageStore& images, Notices& notices, Screen& screen);
    ~Browser();
    /// Once before each frame. `now`: s.
    void update(double now);
    void show();
    void reload() { stale_ = true; }

    const std::vector<PresetFile>& files() const { return files_; }
    /// Indices of those that search and tags leave, in order.
    const std::vector<std::size_t>& found();
    const std::vector<std::string>& tags() const { return tags_; }  ///< the most frequent ones come first
    bool has_tag(std::string_view tag) const;
    void choose_tag(std::string_view tag, bool on);  ///< presets must have all that are chosen
    bool starred(std::size_t file) const;
    void star(std::size_t file, bool on);
    bool current(std::size_t file) const;  ///< it is the one that is open
    std::uint64_t current_key() const { return current_key_; }

    std::string search;
    PresetOrder order = PresetOrder::name;
    bool stars_only = false;

    /// Its parameters and clips in place of those that are open, as one undo step; name and file stay.
    void take_values(std::size_t file);
    /// A folder that presets are looked for in from now on.
    void add_folder(const std::filesystem::path& folder);
    void remove_folder(const std::filesystem::path& folder);
    const std::vector<std::string>& own_folders() const;  ///< those that were added

    /// For tests: thumbnails are rendered by this program, even where the options say that none are rendered.
    void render_with(const std::filesystem::path& program);
    /// Whether folders are still to be read or thumbnails still to come.
    bool busy() const;

  private:
    struct ScannedPresets {
        std::vector<PresetFile> files;
    };
    static ScannedPresets look(const std::vector<std::filesystem::path>& folders);
    std::vector<std::filesystem::path> folders() const;
    void start_maker();
    void scan();
    void take(ScannedPresets found);
    void want_thumbnails();
    void take_thumbnails();
    void count_tags();

    const EditorOptions& options_;
    document::Document& document_;
    Settings& settings_;
    Jobs& jobs_;
    ui::ImageStore& images_;
    Notices& notices_;
    Screen& screen_;
    std::vector<PresetFile> files_;
    std::vector<std::string> tags_, chosen_tags_;
    std::vector<std::size_t> found_;
    bool sorted_ = false;  ///< found_ is up to date for tags, files and the three values below
    std::string found_for_;
    PresetOrder found_order_ = PresetOrder::name;
    bool found_stars_ = false;
    bool shown_ = false, seen_ = false, stale_ = true, renders_ = true;
    std::shared_ptr<Job> scanning_;
    std::filesystem::path program_ = "/proc/self/exe";
    std::filesystem::path scanned_beside_, current_, scene_;
    std::uint64_t current_key_ = 0;
    std::shared_ptr<const Preset> scanned_saved_;
    std::unique_ptr<ThumbnailMaker> maker_;
};

}  // namespace lapfx::app
