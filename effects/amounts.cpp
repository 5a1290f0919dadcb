#include "lapfx/amounts.h"

#include <array>
#include <charconv>
#include <cmath>

#include "foundation.h"
#include "inputs.h"
#include "organ/refine.h"
#include "simulation.h"

namespace lapfx {

namespace {

/// With a point, whatever the locale of the host.
void add_number(std::string& line, double value, int decimals) {
    std::array<char, 512> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
    line.append(text.data(), end);
}

}  // namespace

std::string amounts_head() {
    std::string line = "time_s";
    for (const AmountRow& row : amount_rows) {
        if (row.decimals < 0) continue;
        line += ',';
        line += row.key;
        if (!row.unit.empty()) line += '_', line += row.unit;
    }
    return line + '\n';
}

std::string amounts_line(double time, const Amounts& amounts) {
    std::string line;
    add_number(line, time, 4);
    for (const AmountRow& row : amount_rows) {
        if (row.decimals < 0) continue;
        line += ',';
        add_number(line, row.member.of(amounts), row.decimals);
    }
    return line + '\n';
}

struct AmountsModel::State {
    State(std::shared_ptr<const Foundation> foundation, const AmountsOptions& options)
        : simulation(std::move(foundation), direction_of(options.gravity)) {}

    Simulation simulation;
    bool smokes = false;  // the preset has clips
};

AmountsModel::AmountsModel(const Organ& organ, const AmountsOptions& options)
    : state_(std::make_unique<State>(
          std::make_shared<const Foundation>(organ::FineOrgan(organ).organ(), VesselParameters{}), options)) {}
AmountsModel::AmountsModel(const std::shared_ptr<const PreparedOrgan>& organ, const AmountsOptions& options)
    : state_(std::make_unique<State>(organ->state().foundation, options)) {}
AmountsModel::AmountsModel(AmountsModel&&) noexcept = default;
AmountsModel& AmountsModel::operator=(AmountsModel&&) noexcept = default;
AmountsModel::~AmountsModel() = default;

void AmountsModel::set(const Preset& preset, std::span<const ToolContact> contacts, const Curves& curves) {
    require_valid(preset);
    state_->simulation.set(preset, contacts, curves);
    state_->smokes = !preset.smoke.clips.empty();
}

Amounts AmountsModel::at(double time) noexcept {
    state_->simulation.seek(std::isfinite(time) ? time : 0.0);
    return state_->simulation.amounts(state_->smokes);
}

SmokeAmounts AmountsModel::smoke_at(double time) const noexcept {
    return state_->simulation.smoke(std::isfinite(time) ? time : 0.0, state_->smokes);
}

std::span<const WoundStatus> AmountsModel::wounds() const noexcept {
    return state_->simulation.blood().wounds();
}

}  // namespace lapfx
