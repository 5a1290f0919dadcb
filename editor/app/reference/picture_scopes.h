// What is counted in a picture, to compare its colours with those of another one: how often each level occurs, its luma
// from left to right, its chroma.
//
//     scopes.count(image);                                     // when the picture has changed
//     ui::waveform(ui, "Waveform", scopes.waves());
//
// What it needs is kept: counting another picture of the same size allocates nothing. UI thread.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "lapfx/organ.h"
#include "ui/canvas/scope.h"

namespace lapfx::app {

enum class Channel : std::uint8_t { luma, red, green, blue };
inline constexpr std::array<std::string_view, 4> channel_titles = {"Luma", "Red", "Green", "Blue"};

class PictureScopes {
  public:
    /// `images` must outlive it.
    explicit PictureScopes(ui::ImageStore& images) : vectors_(images), waves_(images) {}

    /// Counts a grid of its pixels, about 256 on the shorter side.
    void count(const Image& image);
    bool counted() const { return waves_.handle() != 0; }
    /// How many pixels have each level, 0 to 255.
    std::span<const std::uint32_t> levels(Channel channel) const { return bins_[static_cast<std::size_t>(channel)]; }
    /// Mean level, 0 to 255.
    double mean(Channel channel) const { return means_[static_cast<std::size_t>(channel)]; }
    ui::ImageHandle waves() const { return waves_.handle(); }
    ui::ImageHandle vectors() const { return vectors_.handle(); }

  private:
    std::array<std::array<std::uint32_t, 256>, channel_titles.size()> bins_{};
    std::array<double, channel_titles.size()> means_{};
    ui::ScopeImage vectors_, waves_;
};

}  // namespace lapfx::app
