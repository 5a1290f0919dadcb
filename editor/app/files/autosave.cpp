#include "app/files/autosave.h"

#include <chrono>
#include <cmath>
#include <optional>

#include "app/base/notices.h"
#include "app/tuning/snapshots.h"

namespace lapfx::app {

namespace {

std::int64_t now_utc() {
    return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

std::filesystem::path folder_in(const std::filesystem::path& state) {
    return state.empty() ? state : state / "autosave";
}

std::string name_of(const std::filesystem::path& file, const std::string& name, const char* kind) {
    if (!file.empty()) return file.filename().string();
    return name.empty() ? std::string("a new ") + kind : name;
}

/// Takes the newest kept state that can be read.
bool read_newest(Autosave::Offer& offer) {
    for (const auto& file : offer.left.files) {
        try {
            std::vector<std::string> told;
            offer.kept = document::read_kept(file, told);
            offer.notes.insert(offer.notes.end(), told.begin(), told.end());
            return true;
        } catch (const Error& fault) {
            offer.notes.push_back(fault.faults().front().text());
        }
    }
    return false;
}

}  // namespace

Autosave::Autosave(document::Document& document, Snapshots& snapshots, Notices& notices,
                   std::filesystem::path state_folder)
    : document_(document),
      snapshots_(snapshots),
      notices_(notices),
      state_folder_(std::move(state_folder)),
      folder_(folder_in(state_folder_)),
      writer_({}, 1) {}

Autosave::~Autosave() {
    writer_.finish();
}

std::uint64_t Autosave::state() const {
    return document_.version() + (snapshots_.version() << 40U);
}

void Autosave::soon() {
    soon_ = true;
}

document::Kept Autosave::kept() const {
    const document::Document& d = document_;
    return {.time = now_utc(),
            .content = d.content(),
            .scene_file = d.scene_file(),
            .preset_file = d.preset_file(),
            .scene_disk = d.scene_on_disk(),
            .preset_disk = d.preset_on_disk(),
            .scene_unsaved = d.scene_unsaved(),
            .preset_unsaved = d.preset_unsaved(),
            .snapshots = snapshots_.kept()};
}

void Autosave::update(double now) {
    if (state_folder_.empty()) return;
    writer_.take();
    if (const std::uint64_t state = this->state(); state != seen_) {
        seen_ = state;
        const bool unsaved = document_.unsaved();
        if (unsaved) settling_.change(now);
        // It was saved: this is written down at once, or a crash would offer work that is on the disk already.
        if (!unsaved && unsaved_ && written_) settling_.set(now);
        if (!unsaved && !written_) settling_.clear();
        if (!unsaved && unsaved_) {
            for (document::LeftBehind& left : recovered_) {
                try {
                    document::discard(std::move(left));
                } catch (const Error& fault) {
                    failed(fault.faults().front().text());
                }
            }
            recovered_.clear();
        }
        unsaved_ = unsaved;
    }
    soon_ |= std::exchange(faults_seen_, notices_.faults()) != notices_.faults();
    if (std::exchange(soon_, false) && unsaved_) settling_.set(now);
    if (settling_.due_at(now)) write(now);
}

void Autosave::write(double now) {
    settling_.clear();
    if (writer_.busy()) {  // a slow disk: the next write has this, too
        settling_.set(now + 1);
        return;
    }
    written_ = true;
    writer_.start(
        "Autosave",
        [this, kept = kept()](Job&) -> Jobs::Apply {
            folder_.write(kept);
            return [this] { told_ = false; };
        },
        [this, now](const std::vector<Fault>& faults) {
            failed(faults.empty() ? "unknown" : faults.front().text());
            settling_.set(now + wait);
        });
}

void Autosave::failed(const std::string& reason) {
    if (!told_)
        notices_.add({.kind = ui::ToastKind::warning,
                      .text = "Unsaved work cannot be kept for a crash: " + reason + ". The editor keeps trying."});
    told_ = true;
}

void Autosave::write_now() noexcept {
    try {
        if (state_folder_.empty() || !document_.unsaved()) return;
        writer_.finish();
        folder_.write(kept());
    } catch (const std::exception&) {
        return;  // there is nobody left to tell: the fault that ends the editor is told
    }
}

void Autosave::end() {
    if (state_folder_.empty()) return;
    writer_.finish();
    folder_.remove();
    for (document::LeftBehind& left : recovered_) {
        try {
            document::discard(std::move(left));
        } catch (const Error&) {
            continue;  // it is offered again next time
        }
    }
    recovered_.clear();
    settling_.clear();
    written_ = false;
}

void Autosave::find() {
    offers_.clear();
    if (state_folder_.empty()) return;
    for (document::LeftBehind& left : document::find_left_behind(folder_in(state_folder_))) {
        Offer offer{.left = std::move(left), .kept = {}, .name = {}, .unsaved = {}, .notes = {}};
        if (!read_newest(offer)) continue;  // written by another version, which may still read it
        const document::Kept& k = offer.kept;
        if (!k.scene_unsaved && !k.preset_unsaved) continue;
        offer.name = name_of(k.scene_file, k.content.scene.name, "scene") + ", " +
                     name_of(k.preset_file, k.content.preset.name, "preset");
        offer.unsaved = k.scene_unsaved && k.preset_unsaved ? "scene and preset" : k.scene_unsaved ? "scene" : "preset";
        offers_.push_back(std::move(offer));
    }
}

namespace {

/// Reads a file, if it still is the one that the work began with.
template <typename Read>
auto in_file(const std::filesystem::path& file, const document::OnDisk& known, Read read)
    -> std::optional<decltype(read(file))> {
    if (file.empty() || document::OnDisk::of(file) != known) return {};
    try {
        return read(file);
    } catch (const Error&) {
        return {};
    }
}

}  // namespace

void Autosave::recover(std::size_t index) {
    Offer offer = std::move(offers_[index]);
    offers_.clear();
    document::Kept& k = offer.kept;
    document_.recover(
        {.content = std::move(k.content),
         .scene_in_file = in_file(k.scene_file, k.scene_disk, load_scene),
         .preset_in_file = in_file(k.preset_file, k.preset_disk, [](const auto& f) { return load_preset(f); }),
         .scene_file = k.scene_file,
         .preset_file = k.preset_file,
         .scene_disk = k.scene_disk,
         .preset_disk = k.preset_disk,
         .scene_unsaved = k.scene_unsaved,
         .preset_unsaved = k.preset_unsaved});
    snapshots_.restore(k.snapshots);
    for (const std::string& note : offer.notes)
        notices_.add({.kind = ui::ToastKind::warning, .text = "Not recovered: " + note});
    recovered_.push_back(std::move(offer.left));
    // It is kept as this editor's own from now on, too.
    unsaved_ = true;
    soon_ = true;
}

void Autosave::discard(std::size_t index) {
    Offer offer = std::move(offers_[index]);
    offers_.erase(offers_.begin() + static_cast<std::ptrdiff_t>(index));
    try {
        document::discard(std::move(offer.left));
    } catch (const Error& fault) {
        notices_.tell(fault);
    }
}

}  // namespace lapfx::app
