// Keeps unsaved work in the user's state folder and offers it after a crash.
//
// The work is kept 2 s after the last change, but no later than 5 s after the first one; at once when something goes
// wrong; and again when it has been saved. A separate thread writes it. end() removes it, when everything has been
// saved or the user has chosen to discard it. After a crash it stays, and find() of the next editor offers it. Work
// that was recovered also stays until it is saved.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/base/jobs.h"
#include "app/base/settling.h"
#include "document/document.h"
#include "document/keep.h"

namespace lapfx::app {

class Notices;
class Snapshots;

class Autosave {
  public:
    static constexpr double pause = 2;  ///< s without another change until it is kept
    static constexpr double wait = 5;   ///< s from a change until it is kept at the latest

    /// `state_folder`: of the user; empty: nothing is kept. All must outlive it.
    Autosave(document::Document& document, Snapshots& snapshots, Notices& notices, std::filesystem::path state_folder);
    ~Autosave();

    /// Once before each frame. `now`: s.
    void update(double now);
    /// When update() is wanted at the latest, s; infinite: nothing has to be kept.
    double due() const { return settling_.due(); }
    /// Keeps the work with the next update(), because something has gone wrong. Notices about faults do the same.
    void soon();
    /// Keeps the work at once and waits until it is written: the editor is about to end because of a fault. Never
    /// throws.
    void write_now() noexcept;
    /// Called when everything was saved or the user chose to discard it: nothing is kept any longer.
    void end();

    // --- after a crash ----------------------------------------------------------------------------------------------
    /// What an editor that ended by a fault had not saved, and no other editor offers now.
    struct Offer {
        document::LeftBehind left;
        document::Kept kept;
        std::string name;                ///< "lagb.scene.json, my_bleed.json"
        std::string unsaved;             ///< "scene and preset"
        std::vector<std::string> notes;  ///< what could not be read of it
    };
    /// Looks for it. For the start of the program; reads files.
    void find();
    const std::vector<Offer>& offers() const { return offers_; }
    /// Becomes the document; the others wait for the next start. Only a part of what that takes: Files::recover().
    void recover(std::size_t offer);
    void discard(std::size_t offer);
    void keep_for_later() { offers_.clear(); }

  private:
    std::uint64_t state() const;  ///< changes with what is to be kept
    document::Kept kept() const;
    void write(double now);
    void failed(const std::string& reason);

    document::Document& document_;
    Snapshots& snapshots_;
    Notices& notices_;
    std::filesystem::path state_folder_;
    std::uint64_t faults_seen_ = 0;  ///< notices_.faults() had this value last
    document::KeepFolder folder_;    ///< used by the writer's thread; by others only while nothing runs there
    std::uint64_t seen_ = 0;         ///< state() when it was last checked
    bool unsaved_ = false, written_ = false, told_ = false, soon_ = false;
    Settling settling_{pause, wait};
    std::vector<Offer> offers_;
    std::vector<document::LeftBehind> recovered_;
    Jobs writer_;  ///< declared last, so that its thread ends first
};

}  // namespace lapfx::app
