#include "app/tuning/tuning.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "app/base/notices.h"
#include "app/base/saved.h"
#include "app/base/settings.h"
#include "app/preview/preview_host.h"
#include "app/tuning/parameter_text.h"
#include "document/words.h"

namespace lapfx::app {

namespace {

constexpr int most_tries = 32;  // of a value that breaks a rule, before it stays as it is

const std::vector<ParameterEntry>& entries() {
    return parameters().entries();
}

/// Gives the same numbers everywhere; the distributions of the standard library differ.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : bits_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1.0p-53;
    }

  private:
    std::mt19937_64 bits_;
};

/// A random value on the row's steps, at most `share` of the range from `value`.
double thrown(const Parameter& row, const Tuning::Range& range, double value, double share, Dice& dice) {
    const bool logarithmic = row.scale == Scale::logarithmic && range.low > 0;
    const auto to = [&](double v) { return logarithmic ? std::log(v) : v; };
    const double low = to(range.low), high = to(range.high), at = std::clamp(to(value), low, high);
    const double reach = share * (high - low);
    const double place =
        share >= 1 ? dice.between(low, high) : dice.between(std::max(low, at - reach), std::min(high, at + reach));
    double next = logarithmic ? std::exp(place) : place;
    // Steps of a tenth of the row's, or finer: a logarithmic row begins far below its step.
    if (row.step > 0) {
        double step = row.step;
        while (logarithmic && step > next / 20) step /= 10;
        next = std::round(next / step) * step;
        const double digits = std::pow(10.0, std::max(0.0, std::ceil(-std::log10(step)) + 2));
        next = std::round(next * digits) / digits;
    }
    return std::clamp(next, std::max(row.minimum, range.low), std::min(row.maximum, range.high));
}

Value thrown(const ParameterEntry& entry, const Tuning::Range& range, const Preset& preset, double share, Dice& dice) {
    const Parameter& row = *entry.row;
    Value value = row.get(entry.owner(preset));
    switch (row.kind) {
        case Kind::number:
            return thrown(row, range, std::get<double>(value), share, dice);
        case Kind::integer:
            return static_cast<int>(std::lround(thrown(row, range, std::get<int>(value), share, dice)));
        case Kind::color:
        case Kind::vector: {
            glm::dvec3 v = std::get<glm::dvec3>(value);
            Parameter channel = row;
            channel.step = row.kind == Kind::color ? 0 : row.step;
            for (int i = 0; i < 3; ++i) v[i] = thrown(channel, range, v[i], share, dice);
            if (row.kind == Kind::color) v = glm::round(v * 255.0) / 255.0;
            return v;
        }
        // Choices and switches have no neighbouring values: they change only at full strength.
        case Kind::boolean:
            return share >= 1 ? Value(dice.between(0, 1) < 0.5) : value;
        case Kind::choice:
            if (share < 1) return value;
            return std::min(static_cast<int>(dice.between(0, static_cast<double>(row.choices.size()))),
                            static_cast<int>(row.choices.size()) - 1);
        default:
            return value;
    }
}

std::size_t broken_rules(const ParameterEntry& entry, const Preset& preset) {
    const void* const owner = entry.owner(preset);
    return static_cast<std::size_t>(std::count_if(entry.table->rules.begin(), entry.table->rules.end(),
                                                  [&](const Rule& rule) { return !rule.check(owner).empty(); }));
}

/// Sets a value if its row allows it: a document that was opened with faults may have others.
void put(const ParameterEntry& entry, Preset& preset, const Value& value) {
    if (entry.row->check(value).empty()) entry.row->set(entry.owner(preset), value);
}

bool is_text(const ParameterEntry& entry) {
    return entry.row->kind == Kind::text || entry.row->kind == Kind::path;
}

}  // namespace

Tuning::Tuning(document::Document& document, Saved& saved, const PreviewHost& preview, Settings& settings,
               Notices& notices)
    : document_(document),
      saved_(saved),
      preview_(preview),
      settings_(settings),
      notices_(notices),
      states_(entries().size()),
      changed_in_(parameters().groups().size()) {}

std::size_t Tuning::index_of(const ParameterGroup& group) {
    return static_cast<std::size_t>(&group - parameters().groups().data());
}

void Tuning::follow() {
    if (settings_.favourites != favourite_keys_) follow_favourites();
    const document::Document& document = document_;
    std::vector<std::string>& clips = clip_faults_;
    const std::vector<Fault>& told = preview_.preset_faults();
    const bool same_faults =
        std::equal(told.begin(), told.end(), clips.begin(), clips.end(),
                   [](const Fault& fault, const std::string& reason) { return fault.reason == reason; });
    if (followed_ == document.version() && same_faults) return;
    clips.clear();
    for (const Fault& fault : told) clips.push_back(fault.reason);
    if (followed_ != document.version()) {
        const unsigned preset = document.preset_changes_since(followed_);
        followed_ = document.version();
        const bool saved = document.saved_preset() != saved_preset_;
        saved_preset_ = document.saved_preset();
        if (saved || preset != 0) follow_values();
    }
    follow_faults();
}

void Tuning::follow_favourites() {
    favourite_keys_ = settings_.favourites;
    favourites_.clear();
    for (State& state : states_) state.favourite = false;
    for (const std::string& key : favourite_keys_) {
        const std::size_t entry = parameters().find(key);
        if (entry == no_entry || states_[entry].favourite) continue;
        states_[entry].favourite = true;
        favourites_.push_back(entry);
    }
}

const Preset& Tuning::standard() const {
    return saved_.content().preset;
}

void Tuning::follow_values() {
    const Preset& preset = document_.preset();
    std::fill(changed_in_.begin(), changed_in_.end(), 0);
    changed_in_all_ = 0;
    for (std::size_t i = 0; i < states_.size(); ++i) {
        const ParameterEntry& entry = entries()[i];
        states_[i].changed = !entry.same(preset, standard());
        changed_in_[entry.group] += states_[i].changed ? 1 : 0;
        changed_in_all_ += states_[i].changed ? 1 : 0;
    }
}

void Tuning::follow_faults() {
    for (State& state : states_) state.fault.clear();
    other_faults_.clear();
    for (const std::vector<Fault>* faults : {&document_.preset_faults(), &preview_.preset_faults()})
        for (const Fault& fault : *faults) {
            const std::size_t entry = parameters().find_pointer(fault.place);
            if (entry != no_entry) {
                states_[entry].fault = fault.reason;
                continue;
            }
            std::string text = document::fault_text(fault, document_.preset());
            if (std::find(other_faults_.begin(), other_faults_.end(), text) == other_faults_.end())
                other_faults_.push_back(std::move(text));
        }
}

void Tuning::mark_favourite(std::size_t entry, bool favourite) {
    std::vector<std::string>& keys = settings_.favourites;
    std::erase(keys, entries()[entry].key);
    if (favourite) keys.push_back(entries()[entry].key);
    follow_favourites();
}

Tuning::Range Tuning::range(std::size_t entry) const {
    const Parameter& row = *entries()[entry].row;
    if (row.kind == Kind::color) return {0, 1};
    return states_[entry].range.value_or(Range{row.minimum, row.maximum});
}

bool Tuning::all_locked(const ParameterGroup& group) const {
    const auto begin = states_.begin();
    return std::all_of(begin + static_cast<std::ptrdiff_t>(group.first),
                       begin + static_cast<std::ptrdiff_t>(group.last), [](const State& s) { return s.locked; });
}

void Tuning::lock(const ParameterGroup& group, bool locked) {
    for (std::size_t i = group.first; i < group.last; ++i) states_[i].locked = locked;
}

void Tuning::reset(const ParameterGroup* group) {
    const std::string name = group == nullptr ? "Reset preset" : "Reset " + group->name;
    document_.change(name, [&](document::Content& c) {
        for (const ParameterEntry& entry : entries()) {
            if (group != nullptr && index_of(*group) != entry.group) continue;
            put(entry, c.preset, entry.row->get(entry.owner(standard())));
        }
    });
}

void Tuning::reset(std::size_t i) {
    const ParameterEntry& entry = entries()[i];
    document_.change("Reset " + entry.title, [&](document::Content& c) {
        for (const std::size_t one : {i, entry.high}) {
            if (one == no_entry) continue;
            const ParameterEntry& e = entries()[one];
            put(e, c.preset, e.row->get(e.owner(standard())));
        }
    });
}

int Tuning::randomise(const ParameterGroup* group) {
    Dice dice(seed++);
    int count = 0;
    const std::string name = group == nullptr ? "Randomise" : "Randomise " + group->name;
    document_.change(name, [&](document::Content& c) {
        for (std::size_t i = 0; i < states_.size(); ++i) {
            const ParameterEntry& entry = entries()[i];
            if (states_[i].locked || is_text(entry) || (group != nullptr && index_of(*group) != entry.group)) continue;
            void* const owner = entry.owner(c.preset);
            const Value before = entry.row->get(owner);
            const std::size_t broken = broken_rules(entry, c.preset);
            for (int tries = 0; tries < most_tries; ++tries) {
                entry.row->set(owner, thrown(entry, range(i), c.preset, strength, dice));
                if (broken_rules(entry, c.preset) <= broken) break;
                put(entry, c.preset, before);
            }
            count += entry.row->get(owner) != before ? 1 : 0;
        }
    });
    return count;
}

void Tuning::want(std::size_t entry) {
    wanted = entry;
    search.clear();
    changed_only = false;
}

std::string Tuning::copy(const ParameterGroup* group) const {
    const Preset& preset = document_.preset();
    if (group == nullptr) return copy_parameters(preset, {});
    const std::string_view keys[] = {group->key};
    return copy_parameters(preset, keys);
}

bool Tuning::paste(const std::string& text, const ParameterGroup* group) {
    try {
        Preset preset = paste_parameters(document_.preset(), text, group == nullptr ? std::string_view() : group->key);
        document_.change(group == nullptr ? "Paste parameters" : "Paste " + group->name,
                         [&](document::Content& c) { c.preset = std::move(preset); });
        return true;
    } catch (const Error& error) {
        notices_.tell(error);
        return false;
    }
}

std::string Tuning::copy(std::size_t i) const {
    const ParameterEntry& entry = entries()[i];
    const Preset& preset = document_.preset();
    std::string text = text_of(*entry.row, entry.row->get(entry.owner(preset)));
    if (entry.high == no_entry) return text;
    const ParameterEntry& high = entries()[entry.high];
    return text + ' ' + text_of(*high.row, high.row->get(high.owner(preset)));
}

bool Tuning::paste(const std::string& text, std::size_t i) {
    const ParameterEntry& entry = entries()[i];
    const std::size_t cut = entry.high == no_entry ? std::string::npos : text.find(' ');
    try {
        Preset preset = document_.preset();
        set_parameter(preset_table(), &preset, entry.key, std::string_view(text).substr(0, cut));
        if (cut != std::string::npos)
            set_parameter(preset_table(), &preset, entries()[entry.high].key, std::string_view(text).substr(cut + 1));
        document_.change("Paste " + entry.title, [&](document::Content& c) { c.preset = std::move(preset); });
        return true;
    } catch (const Error& error) {
        notices_.tell(error);
        return false;
    }
}

}  // namespace lapfx::app
