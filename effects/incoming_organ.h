// An organ that takes the place of another one without a frame that takes long: what needs no GPU is done on a thread
// of its own, and the rest a part in each frame. Render thread, context current.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "body.h"
#include "lapfx/prepared_organ.h"
#include "simulation.h"

namespace lapfx {

/// What the new organ has gone through, and with what.
struct OrganHistory {
    SimulationParameters parameters;
    std::vector<ToolContact> contacts;
    Curves curves;
    glm::dvec3 down{0.0, -1.0, 0.0};  ///< unit
    std::uint32_t seed = 1;
    double time = 0.0;  ///< s; it is simulated up to here
};

class IncomingOrgan {
  public:
    /// `programs`: to draw the organ with. `before`: an organ that is only in memory and does not come any more, or
    /// null; the other thread begins when that one's has ended.
    IncomingOrgan(std::shared_ptr<const PreparedOrgan> organ, OrganHistory history,
                  std::shared_ptr<render::OrganPrograms> programs, std::unique_ptr<IncomingOrgan> before = nullptr);
    IncomingOrgan(const IncomingOrgan&) = delete;
    IncomingOrgan& operator=(const IncomingOrgan&) = delete;
    ~IncomingOrgan();  ///< stops the other thread, and waits for the step that it is in
    /// Whether it has no names of OpenGL yet: then any thread may destroy it.
    bool only_in_memory() const { return making_.valid() || (!textures_ && body_ == nullptr); }
    /// For an organ that does not come any more: frees one of its textures; false when none is left.
    bool free_texture() noexcept;
    void free_names() noexcept;  ///< all names of OpenGL that are left

    /// Does the next part; true when simulation and body can be taken. `wait`: all that is left.
    bool advance(bool wait);

    // Once it is here.
    std::unique_ptr<Simulation> take_simulation() { return std::move(made_.simulation); }
    std::unique_ptr<Body> take_body() { return std::move(body_); }
    /// That of a plate.
    std::optional<glm::mat4> projector() const;

    // What the host has set meanwhile.
    bool later_curves = false;
    std::optional<std::vector<ToolContact>> later_contacts;

  private:
    /// By the other thread.
    struct Made {
        std::vector<organ::TextureLevels> textures;
        std::unique_ptr<Simulation> simulation;
    };
    static Made make(const PreparedOrgan& organ, const OrganHistory& history, const std::atomic<bool>& stop);
    void make_body();
    bool is_here(bool wait);

    std::shared_ptr<const PreparedOrgan> organ_;
    std::uint32_t seed_;
    std::shared_ptr<render::OrganPrograms> programs_;
    std::atomic<bool> stop_ = false;
    Made made_;
    std::optional<render::OrganTextures> textures_;
    bool all_sent_ = false;
    std::unique_ptr<Body> body_;
    std::future<Made> making_;  // destroyed first: refers to what is above
};

}  // namespace lapfx
