// The preset's clips as files: where each lies, what it holds, what is wrong with it, a small picture; adding,
// replacing and copying them. Files are looked through by jobs, each once.
//
//     shelf.update(now);                                // once before each frame
//     const ClipFacts& facts = shelf.of(shelf.selected);  // while the UI is built
//     shelf.add({"/videos/plume.mp4"});                 // looked through first; then one undo step
//
// UI thread.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/base/jobs.h"
#include "document/document.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/keying.h"
#include "lapfx/authoring/suggest.h"
#include "lapfx/streaming.h"
#include "ui/draw/draw_list.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class Notices;
class PreviewHost;
class Settings;

/// The facts about one clip's file.
struct ClipFacts {
    std::filesystem::path path;  ///< empty: not found
    bool known = false;          ///< `report` holds
    std::string summary{};       ///< the report says it in one line: "720x480, 5 s at 30 fps"
    ClipReport report{};
    std::vector<Fault> faults;      ///< why it cannot be used
    ui::ImageHandle thumbnail = 0;  ///< 16:9
    std::shared_ptr<Job> job;       ///< that looks through it now
};

class ClipShelf {
  public:
    /// All must outlive it.
    ClipShelf(document::Document& document, const PreviewHost& preview, Jobs& jobs, Settings& settings,
              ui::ImageStore& images, Notices& notices, std::vector<std::filesystem::path> clip_folders, bool exact)
        : document_(document),
          preview_(preview),
          jobs_(jobs),
          settings_(settings),
          images_(images),
          notices_(notices),
          clip_folders_(std::move(clip_folders)),
          exact_(exact) {}
    ClipShelf(const ClipShelf&) = delete;
    ClipShelf& operator=(const ClipShelf&) = delete;

    std::size_t selected = 0;  ///< panels show this one of the preset's clips

    /// Once before each frame. `now`: s.
    void update(double now);

    /// The clip that smokes alone in the preview, to be looked at; none: all do. It is no part of the document; it
    /// stays with its file when the list changes, and ends when that is gone.
    const std::optional<std::size_t>& alone() const { return alone_; }
    void play_alone(std::optional<std::size_t> clip);

    /// The facts about the preset's clip with this number; empty facts if there is no such clip.
    const ClipFacts& of(std::size_t clip) const;
    /// How the clip plays in the preview, updated a few times a second; null: the preview does not have it.
    const ClipStatus* playing(std::size_t clip) const;
    /// All that is wrong with a clip, file and values, a line each.
    const std::vector<std::string>& faults(std::size_t clip) const;
    /// It lies neither in the folder of the preset file nor on the search path, so a preset cannot name it. It can be
    /// copied.
    bool outside(std::size_t clip) const;
    bool any_outside() const;
    /// The folder that the preset's clips belong in; empty while the preset has no folder yet.
    std::filesystem::path home() const;
    /// Examines all files again, because they have changed on the disk.
    void look_again();

    // --- changing ----------------------------------------------------------------------------------------------------
    /// Examines files in a job and adds those that are clips, with the keying and the source that are suggested for
    /// them, or replaces clip `replace` by the first one. refused()
    /// says what is wrong with the others. What is asked for while other work runs waits for its end.
    void add(const std::vector<std::string>& files, std::optional<std::size_t> replace = {});
    /// Copies every clip that is outside into home(), in a job, and names the copy in the preset.
    void copy_beside();
    /// Copies into `folder`, by a job, the clips that a preset there could not name, and uses the copies. Then calls
    /// `then`.
    void copy_to(const std::filesystem::path& folder, std::function<void()> then);
    /// A job of add() or copy_beside(); null: none runs.
    const std::shared_ptr<Job>& work() const { return work_; }
    void cancel_work();  ///< what waits for it is cancelled, too
    /// Adds nothing of add() that has this file.
    void give_up(const std::string& file);
    const std::vector<Fault>& refused() const { return refused_; }
    void forget_refused() { refused_.clear(); }

  private:
    struct Seen {
        std::uint64_t version = 0;
        std::vector<ClipFacts*> facts;
        std::vector<std::vector<std::string>> faults;
        std::vector<bool> outside;
    };
    struct Lot {
        std::vector<std::string> files;
        std::optional<std::size_t> replace;
    };
    void look_through(const Lot& lot);
    void end_work();
    ClipFacts& find(const std::string& file);
    void look(const std::string& key, const std::string& file);
    /// A file that is a clip, and what is suggested for it where it is added.
    struct Good {
        std::string file;
        SourceSuggestion source{};
        KeyingSuggestion keying{};
    };
    void take_found(const std::vector<Good>& files, std::optional<std::size_t> replace);
    void tell_keying(const std::vector<Good>& added);
    void copy(const std::map<std::string, std::filesystem::path>& from, const std::filesystem::path& to,
              std::function<void(const std::map<std::string, std::string>&)> taken);
    bool is_outside(const ClipFacts& facts) const;
    bool stale() const;
    void follow();
    void follow_alone();

    document::Document& document_;
    const PreviewHost& preview_;
    Jobs& jobs_;
    Settings& settings_;
    ui::ImageStore& images_;
    Notices& notices_;
    std::vector<std::filesystem::path> clip_folders_;
    bool exact_;
    std::map<std::string, ClipFacts> known_;  ///< the key is folder and name
    Seen seen_;
    std::uint64_t grown_ = 1;           ///< every result of a job adds one
    std::uint64_t followed_ = 0;        ///< version of the document
    std::uint64_t followed_grown_ = 0;  ///< grown_ then
    std::string followed_file_;         ///< the preset had this file then
    std::shared_ptr<Job> work_;
    std::vector<std::string> work_files_;  ///< that it looks through
    std::deque<Lot> waiting_;
    std::vector<Fault> refused_;
    std::vector<ClipStatus> playing_;
    double asked_ = -1;  ///< s, when the preview was asked for it
    std::optional<std::size_t> alone_;
    std::string alone_file_;
};

/// The middle of an image, cut to 16:9 and reduced to `size`, as RGBA.
std::vector<std::uint8_t> shrunk(const Image& image, glm::ivec2 size);

/// Into source_x and source_y, where smoke was found.
void take_source(SmokeClip& clip, const SourceSuggestion& found);

}  // namespace lapfx::app
