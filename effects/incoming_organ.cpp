#include "incoming_organ.h"

#include <chrono>

#include "foundation.h"

namespace lapfx {

namespace {

/// A few ms of memory traffic, also where the GPU is a processor.
constexpr std::size_t bytes_per_frame = std::size_t{6} << 20;

}  // namespace

IncomingOrgan::IncomingOrgan(std::shared_ptr<const PreparedOrgan> organ, OrganHistory history,
                             std::shared_ptr<render::OrganPrograms> programs, std::unique_ptr<IncomingOrgan> before)
    : organ_(std::move(organ)), seed_(history.seed), programs_(std::move(programs)) {
    if (before) before->stop_ = true;
    making_ =
        std::async(std::launch::async, [this, history = std::move(history), before = std::move(before)]() mutable {
            before.reset();
            return make(*organ_, history, stop_);
        });
}

IncomingOrgan::~IncomingOrgan() {
    stop_ = true;
}

IncomingOrgan::Made IncomingOrgan::make(const PreparedOrgan& organ, const OrganHistory& history,
                                        const std::atomic<bool>& stop) {
    Made made;
    const Organ& shape = organ.organ();
    const std::shared_ptr<const Foundation>& foundation = PreparedOrganAccess::state(organ).foundation;
    for (const organ::TextureUse& use : organ::texture_uses(shape)) {
        if (stop) return made;
        made.textures.push_back(organ::texture_levels(shape, foundation->pixels, use));
    }
    if (stop) return made;
    made.simulation = std::make_unique<Simulation>(foundation, history.down);
    made.simulation->set(history.parameters, history.contacts, history.curves);
    if (stop) return made;
    made.simulation->seek(history.time);
    return made;
}

void IncomingOrgan::make_body() {
    const std::shared_ptr<const Foundation>& foundation = PreparedOrganAccess::state(*organ_).foundation;
    body_ =
        std::make_unique<Body>(organ_->organ(), foundation, *made_.simulation, seed_, programs_, std::move(*textures_));
    if (const auto thrown = projector()) body_->set_projector(*thrown);
}

std::optional<glm::mat4> IncomingOrgan::projector() const {
    const auto& plate = PreparedOrganAccess::state(*organ_).foundation->plate;
    return plate ? std::optional(glm::mat4(plate->projector())) : std::nullopt;
}

bool IncomingOrgan::free_texture() noexcept {
    return body_ != nullptr ? body_->free_texture() : textures_ && textures_->free_one();
}

void IncomingOrgan::free_names() noexcept {
    body_.reset();
    textures_.reset();
}

bool IncomingOrgan::advance(bool wait) {
    while (!is_here(wait))
        if (!wait) return false;
    return true;
}

/// After one more step on the way.
bool IncomingOrgan::is_here(bool wait) {
    using namespace std::chrono_literals;
    if (body_ != nullptr) return true;
    if (making_.valid()) {
        if (!wait && making_.wait_for(0s) != std::future_status::ready) return false;
        made_ = making_.get();
        textures_.emplace();
    } else if (all_sent_) {
        make_body();
    } else {
        all_sent_ = !textures_->send(made_.textures, bytes_per_frame);
    }
    return false;
}

}  // namespace lapfx
