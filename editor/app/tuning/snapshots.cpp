#include "app/tuning/snapshots.h"

#include <chrono>

namespace lapfx::app {

namespace {

std::int64_t now_utc() {
    return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

}  // namespace

void Snapshots::keep(std::size_t slot) {
    document_.commit();
    all_[slot] = {.preset = document_.preset(), .time = now_utc(), .file = document_.preset_file(), .id = ++last_id_};
    ++version_;
}

void Snapshots::clear(std::size_t slot) {
    all_[slot].reset();
    ++version_;
}

std::string Snapshots::other_file(std::size_t slot) const {
    const auto& snapshot = all_[slot];
    return snapshot && snapshot->file != document_.preset_file() ? snapshot->file.filename().string() : "";
}

void Snapshots::move(const std::filesystem::path& from, const std::filesystem::path& to) {
    if (from.empty() || from == to) return;  // without a file nobody knows which document it was
    for (auto& snapshot : all_)
        if (snapshot && snapshot->file == from) snapshot->file = to;
    ++version_;
}

Preset Snapshots::preset(std::size_t slot) const {
    return all_[slot]->preset;
}

void Snapshots::show(std::size_t slot) {
    if (!all_[slot]) return;
    document_.commit();
    const std::string name = std::string("Snapshot ") + names[slot];
    if (shown(slot)) {
        if (!before_) return;
        const Preset back = *before_;
        document_.change("Back from snapshot " + std::string(names[slot]),
                         [&](document::Content& c) { c.preset = back; });
        return;
    }
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) any |= shown(i);
    // Going from one snapshot to another keeps the preset from before the first one.
    if (!any) before_ = document_.preset();
    document_.change(name, [&](document::Content& c) { c.preset = preset(slot); });
}

bool Snapshots::shown(std::size_t slot) const {
    const std::uint64_t version = document_.version();
    if (compared_document_ != version || compared_ != version_) {
        compared_document_ = version;
        compared_ = version_;
        same_.fill(false);
        for (std::size_t i = 0; i < count; ++i)
            same_[i] = all_[i] && document::same(all_[i]->preset, document_.preset());
    }
    return same_[slot];
}

std::vector<document::KeptSnapshot> Snapshots::kept() const {
    std::vector<document::KeptSnapshot> kept;
    for (std::size_t i = 0; i < count; ++i)
        if (all_[i])
            kept.push_back({.slot = i, .time = all_[i]->time, .preset = all_[i]->preset, .file = all_[i]->file});
    return kept;
}

void Snapshots::restore(const std::vector<document::KeptSnapshot>& kept) {
    all_ = {};
    before_.reset();
    for (const document::KeptSnapshot& snapshot : kept)
        if (snapshot.slot < count)
            all_[snapshot.slot] = {
                .preset = snapshot.preset, .time = snapshot.time, .file = snapshot.file, .id = ++last_id_};
    ++version_;
}

}  // namespace lapfx::app
