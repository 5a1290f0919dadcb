// Four states of the preset, A to D, to go back to and to compare.
//
//     editor.snapshots().keep(0);  // as A
//     editor.snapshots().show(0);  // one undo step "Snapshot A"; a second call goes back to the preset before
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "document/keep.h"
#include "lapfx/preset.h"

namespace lapfx::app {

class Snapshots {
  public:
    static constexpr std::size_t count = 4;
    static constexpr std::array<const char*, count> names = {"A", "B", "C", "D"};

    explicit Snapshots(document::Document& document) : document_(document) {}

    struct Snapshot {
        Preset preset;
        std::int64_t time = 0;       ///< when it was kept, s since 1970, UTC
        std::filesystem::path file;  ///< of the preset that was open then; empty: it had none
        std::uint64_t id = 0;        ///< no other snapshot of this run of the program has it
    };
    const std::optional<Snapshot>& at(std::size_t slot) const { return all_[slot]; }
    void keep(std::size_t slot);
    void clear(std::size_t slot);
    /// The document's preset becomes this one. If it already is, the preset from before a snapshot was shown comes
    /// back.
    void show(std::size_t slot);
    /// The preset, as the document would have it: its clips are found from the document's folder.
    Preset preset(std::size_t slot) const;
    /// Snapshots stay when another preset is opened, to be compared with that one. This is the name of the file that
    /// the snapshot was kept from, where it is not the document's file now; empty where it is, or where there was no
    /// file.
    std::string other_file(std::size_t slot) const;
    /// The document's preset has been saved under another name: those kept of it are of that file now.
    void move(const std::filesystem::path& from, const std::filesystem::path& to);
    /// Whether the document's preset is just this one.
    bool shown(std::size_t slot) const;

    /// Forgets the preset from before a snapshot was shown, because another document has been opened.
    void forget_before() { before_.reset(); }

    /// For autosave.
    std::vector<document::KeptSnapshot> kept() const;
    void restore(const std::vector<document::KeptSnapshot>& kept);
    /// Grows with every change.
    std::uint64_t version() const { return version_; }

  private:
    document::Document& document_;
    std::array<std::optional<Snapshot>, count> all_;
    std::optional<Preset> before_;  ///< a snapshot was shown
    std::uint64_t last_id_ = 0;
    std::uint64_t version_ = 1;
    // What shown() answers, for these versions of document and snapshots.
    mutable std::uint64_t compared_document_ = 0, compared_ = 0;
    mutable std::array<bool, count> same_{};
};

}  // namespace lapfx::app
