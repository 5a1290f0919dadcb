#include "cautery/cautery.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lapfx/parameter.h"

namespace lapfx::cautery {

namespace {

/// Degrees below which heat is not kept: no tissue changes.
constexpr double least_rise = BurntArea::least_rise;

}  // namespace

Cautery::Cautery(const Surface& surface, StrengthAt strength_at)
    : surface_(surface),
      strength_at_(std::move(strength_at)),
      track_(surface),
      radial_(strength_at_, sealed_at()),
      clips_(surface),
      dirty_(surface.positions.size()),
      marks_(surface.weld.size(), glm::vec2(0.0f)),
      changed_(surface.weld.size()),
      peaks_(surface.positions.size(), 0.0f),
      burnt_(surface) {
    settled_.values.assign(surface.positions.size(), glm::vec2(0.0f));
    last_.values = settled_.values;
}

void Cautery::set_parameters(const CauteryParameters& parameters, unsigned changed) {
    parameters_ = parameters;
    due_ |= changed;
}

void Cautery::choose_model() {
    radial_.reset(parameters_);
    if (bioheat_)
        for (const std::uint32_t point : bioheat_->touched()) dirty_.add(point);
    const std::uint64_t before = heat_version();
    if (parameters_.model != HeatModel::bioheat)
        bioheat_.reset();
    else if (!bioheat_)
        bioheat_ = std::make_unique<Bioheat>(surface_, strength_at_, sealed_at());
    if (bioheat_) bioheat_->reset(parameters_);
    versions_ = before + 1 - list().version();
    all_stale_ = remeasure_ = true;
}

void Cautery::set(const tool::Log& log) {
    const unsigned due = std::exchange(due_, 0U);
    if (due & redo::tip_places) track_.set_parameters(parameters_);
    const std::size_t before = track_.stays().size();
    std::size_t first = track_.set(log);
    const std::size_t count = track_.stays().size();
    const double clips_from = clips_.set(track_, first, parameters_, due);
    if (clips_from < never) {
        radial_.seal_wounds();
        if (bioheat_) bioheat_->seal_wounds();
    }
    double from = track_.same_until();
    if (due & redo::heat) {
        choose_model();
        first = 0;
        from = -never;
    } else if (first == before && first == count) {
        return;
    }
    if (bioheat_) {
        bioheat_->changed_from(std::min(track_.same_until(), clips_from));
    } else {
        radial_.truncate(first);
        for (std::size_t i = first; i < count; ++i) radial_.append(track_, static_cast<std::uint32_t>(i));
        // Earlier clips may decide whether a wound opens.
        radial_.resolve(track_, std::min(from, clips_from));
    }
    // Only the marks of the last contact can be removed, and heat adds: it changes what others do at the same time.
    const bool beside = first > 0 && first < count && track_.stays()[first - 1].latest_end > from && from < updated_;
    if (first + 1 < before || count < before || beside) all_stale_ = true;
    last_stale_ = true;
    if (all_stale_) return;
    for (std::size_t i = std::min(first, before > 0 ? before - 1 : 0); i + 1 < count; ++i)
        contribute(static_cast<std::uint32_t>(i), updated_, settled_);
}

SealedAt Cautery::sealed_at() {
    return [this](const glm::dvec3& place) { return clips_.sealed_at(place); };
}

void Cautery::update(double time) noexcept {
    if (!std::isfinite(time)) return;
    const auto stays = track_.stays();
    if (bioheat_) {
        bioheat_->seek(track_, time);
        for (const std::uint32_t point : bioheat_->changed()) dirty_.add(point);
        bioheat_->take_changed();
    }
    const bool back = time < updated_;
    const double from = back || all_stale_ ? -never : updated_;
    if (back || all_stale_) clear(settled_);
    if (!stays.empty()) {
        const auto begun =
            std::partition_point(stays.begin(), stays.end(), [&](const Stay& s) { return s.contact.time <= time; });
        auto i = static_cast<std::uint32_t>(begun - stays.begin());
        const auto last = static_cast<std::uint32_t>(stays.size() - 1);
        if (last_stale_ || back || stays[last].contact.end() >= updated_) {
            clear(last_);
            contribute(last, time, last_);
        }
        while (i > 0 && stays[i - 1].latest_end >= from) {
            --i, ++work_;
            if (i != last && stays[i].contact.end() >= from) contribute(i, time, settled_);
        }
    } else {
        clear(last_);
    }
    all_stale_ = last_stale_ = false;
    updated_ = time;
    publish();
}

void Cautery::clear(Layer& layer) {
    work_ += layer.points.size();
    for (const std::uint32_t point : layer.points) {
        layer.values[point] = glm::vec2(0.0f);
        dirty_.add(point);
    }
    layer.points.clear();
}

/// The marks of a contact by `time`. They only grow with time, so adding them again later does no harm.
void Cautery::contribute(std::uint32_t number, double time, Layer& layer) {
    const Stay& stay = track_.stays()[number];
    if (stay.contact.time > time) return;
    if (cold(stay.contact.action)) {
        for (const Place& place : track_.places_of(stay))
            if (place.arrival <= time) divide_around(place.point.position, stay.contact.action, layer);
        return;
    }
    if (!stay.contact.hot() || bioheat_) return;
    radial_.bells(track_, number, time, bells_);
    for (const Bell& bell : bells_) {
        if (bell.divided) divide_around(bell.position, stay.contact.action, layer);
        if (!(bell.rise > least_rise)) continue;
        surface_.points_within(bell.position, bell.radius * std::sqrt(std::log(bell.rise / least_rise)), near_);
        work_ += near_.size();
        for (const std::uint32_t point : near_)
            raise(layer, point, {static_cast<float>(bell.at(surface_.positions[point])), 0.0f});
    }
}

void Cautery::divide_around(const glm::dvec3& place, ToolAction action, Layer& layer) {
    surface_.points_within(place, 2.0 * parameters_.tip_radius, near_);
    work_ += near_.size();
    for (const std::uint32_t point : near_) {
        const double distance = glm::distance(surface_.positions[point], place);
        raise(layer, point, {0.0f, static_cast<float>(divided_at(distance, action, parameters_))});
    }
}

void Cautery::raise(Layer& layer, std::uint32_t point, glm::vec2 value) {
    glm::vec2& known = layer.values[point];
    const glm::vec2 higher = glm::max(known, value);
    if (higher == known) return;
    if (known == glm::vec2(0.0f)) layer.points.push_back(point);
    known = higher;
    dirty_.add(point);
}

void Cautery::publish() {
    for (const std::uint32_t point : dirty_.points()) {
        glm::vec2 mark = glm::max(settled_.values[point], last_.values[point]);
        if (bioheat_)
            mark = glm::max(mark,
                            {static_cast<float>(bioheat_->peak(point)), static_cast<float>(bioheat_->divided(point))});
        if (mark.x != peaks_[point] || remeasure_) {
            peaks_[point] = mark.x;
            burnt_.mark(point);
        }
        const double peak = body_temperature + std::min<double>(mark.x, highest_rise(parameters_));
        mark.x = static_cast<float>(char_of(peak, parameters_));
        for (const std::uint32_t vertex : surface_.vertices_at(point)) {
            if (marks_[vertex] == mark) continue;
            marks_[vertex] = mark;
            changed_.mark(vertex);
        }
    }
    dirty_.clear();
    remeasure_ = false;
    const double wanted = parameters_.char_temperature - body_temperature;
    burnt_.measure(peaks_, wanted > highest_rise(parameters_) ? never : std::max(wanted, least_rise));
}

double Cautery::temperature(const glm::dvec3& place, double time) {
    const glm::dvec3 size = glm::abs(place);
    if (!(size.x <= 1e5 && size.y <= 1e5 && size.z <= 1e5) || !std::isfinite(time) || surface_.triangles.empty())
        return body_temperature;
    const SurfacePoint nearest = surface_.closest_point(place);
    if (!(nearest.distance <= farthest_touch)) return body_temperature;
    if (!bioheat_) return radial_.temperature(nearest.position, time);
    bioheat_->seek(track_, time);
    return bioheat_->temperature(nearest);
}

}  // namespace lapfx::cautery
