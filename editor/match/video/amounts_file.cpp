// Amounts as CSV and JSON.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "lapfx/error.h"
#include "match/video/measure.h"

namespace lapfx::match {

namespace {

// Files of programs that tell less end there.
constexpr std::string_view first_columns = "time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags";
constexpr std::string_view columns =
    "time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags,light,light_low,light_high,gain,gain_low,gain_high";
constexpr std::size_t flags_column = 7, light_column = 8, gain_column = 11;

std::string flags_text(unsigned flags) {
    std::string text;
    for (const ToldRow& row : told_rows)
        if ((flags & row.bit) != 0) text += (text.empty() ? "" : " ") + std::string(row.key);
    return text;
}

std::string cells_of(const Amount& amount, bool measurable) {
    if (!measurable) return ",,,";
    char cells[64];
    std::snprintf(cells, sizeof cells, ",%.5f,%.5f,%.5f", amount.value, amount.low, amount.high);
    return cells;
}

Error refused(const std::string& name, std::size_t line, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = name, .place = "line " + std::to_string(line), .reason = reason}};
}

std::vector<std::string_view> split(std::string_view text, char by) {
    std::vector<std::string_view> parts;
    for (std::size_t from = 0;;) {
        const std::size_t at = text.find(by, from);
        parts.push_back(text.substr(from, at == std::string_view::npos ? at : at - from));
        if (at == std::string_view::npos) return parts;
        from = at + 1;
    }
}

std::string quoted(std::string_view text) {
    constexpr std::size_t most = 60;
    return '"' + std::string(text.substr(0, most)) + (text.size() > most ? "...\"" : "\"");
}

/// One line of numbers and flags.
class Row {
  public:
    /// `header`: the columns of the file.
    Row(const std::string& name, std::size_t line, std::string_view header, std::string_view text)
        : name_(name), line_(line), titles_(split(header, ',')), cells_(split(text, ',')) {
        if (cells_.size() != titles_.size())
            throw refused(name, line,
                          "has " + std::to_string(cells_.size()) + " values instead of " +
                              std::to_string(titles_.size()) + " (" + std::string(header) + ")");
    }
    bool has(std::size_t column) const { return column < cells_.size(); }
    /// `most_text`: the limit, for people.
    double number(std::size_t column, double most, const char* most_text = "1") const {
        const std::string_view cell = cells_[column];
        double value = 0.0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
            throw refused(name_, line_, title(column) + ": " + quoted(cell) + " is not a number");
        if (value < 0.0 || value > most)
            throw refused(name_, line_,
                          title(column) + ": " + std::string(cell) + " is outside the allowed 0 to " + most_text);
        return value;
    }
    /// Empty where the flags say that it is not measurable.
    Amount amount(std::size_t column, bool measurable, double most = 1.0, const char* most_text = "1") const {
        if (cells_[column].empty() && cells_[column + 1].empty() && cells_[column + 2].empty()) {
            if (!measurable) return {};
            throw refused(name_, line_, title(column) + ": is empty, and no flag says why");
        }
        const Amount a{number(column, most, most_text), number(column + 1, most, most_text),
                       number(column + 2, most, most_text)};
        if (a.low <= a.value && a.value <= a.high) return a;
        throw refused(name_, line_, title(column) + ": its interval does not hold it");
    }
    unsigned flags() const {
        unsigned all = 0;
        if (cells_[flags_column].empty()) return all;
        for (const std::string_view word : split(cells_[flags_column], ' ')) all |= bit_of(word);
        return all;
    }

  private:
    std::string title(std::size_t column) const { return std::string(titles_[column]); }
    unsigned bit_of(std::string_view word) const {
        std::string known;
        for (const ToldRow& row : told_rows) {
            if (row.key == word) return row.bit;
            known += (known.empty() ? "" : ", ") + std::string(row.key);
        }
        throw refused(name_, line_, "flags: " + quoted(word) + " is not known (allowed: " + known + ")");
    }

    const std::string& name_;
    std::size_t line_;
    std::vector<std::string_view> titles_, cells_;
};

nlohmann::json json_of(const Episode& episode) {
    nlohmann::json made;
    const std::pair<const char*, const std::optional<double>*> figures[] = {
        {"peak", &episode.peak}, {"mean", &episode.mean},       {"area", &episode.area},  {"onset", &episode.onset},
        {"rise", &episode.rise}, {"peak_at", &episode.peak_at}, {"decay", &episode.decay}};
    for (const auto& [key, figure] : figures) made[key] = *figure ? nlohmann::json(**figure) : nlohmann::json(nullptr);
    return made;
}

nlohmann::json json_of(const Amount& amount, bool measurable) {
    if (!measurable) return nullptr;
    return {{"value", amount.value}, {"low", amount.low}, {"high", amount.high}};
}

/// Of a frame that was compared with a baseline.
nlohmann::json figure_of(const FrameAmounts& frame, double figure) {
    return (frame.flags & (told::missing | told::no_baseline)) != 0 ? nlohmann::json(nullptr) : nlohmann::json(figure);
}

nlohmann::json json_of(std::optional<double> baseline, bool suggested) {
    if (!baseline) return nullptr;
    return {{"time", *baseline}, {"suggested", suggested}};
}

/// Blood is absolute then: all that is in view.
nlohmann::json json_of(const PaintedVideo& painted) {
    return {{"file", painted.file.empty() ? nlohmann::json(nullptr) : nlohmann::json(painted.file)},
            {"absolute", true},
            {"without_blood", painted.without_blood ? nlohmann::json(*painted.without_blood) : nlohmann::json(nullptr)},
            {"threshold", painted.blood->threshold()},
            {"found_again", painted.blood->found_again()}};
}

}  // namespace

std::string csv_of(const Measurement& measurement) {
    std::string text = std::string(columns) + "\n";
    for (const FrameAmounts& f : measurement.frames) {
        char time[32];
        std::snprintf(time, sizeof time, "%.4f", f.time);
        text += time + cells_of(f.blood, f.blood_measurable()) + cells_of(f.veil, f.measurable()) + "," +
                flags_text(f.flags) + cells_of(f.light, f.measurable()) + cells_of(f.gain, f.measurable()) + "\n";
    }
    return text;
}

std::string json_of(const Measurement& measurement) {
    nlohmann::json frames = nlohmann::json::array();
    for (const FrameAmounts& f : measurement.frames)
        frames.push_back({{"time", f.time},
                          {"blood", json_of(f.blood, f.blood_measurable())},
                          {"veil", json_of(f.veil, f.measurable())},
                          {"plume", f.plume ? json_of(*f.plume, true) : nlohmann::json(nullptr)},
                          {"light", json_of(f.light, f.measurable())},
                          {"gain", json_of(f.gain, f.measurable())},
                          {"valid", figure_of(f, f.valid)},
                          {"likeness", figure_of(f, f.likeness)},
                          {"course", f.course ? nlohmann::json(f.course->value) : nlohmann::json(nullptr)},
                          {"flags", flags_text(f.flags)}});
    nlohmann::json shots = nlohmann::json::array();
    for (const Shot& shot : measurement.shots)
        shots.push_back({{"from", shot.from},
                         {"to", shot.to},
                         {"baseline", json_of(shot.baseline, shot.suggested)},
                         {"without", shot.baseline ? nlohmann::json(nullptr) : nlohmann::json(row_of(shot.why).key)}});
    nlohmann::json whole{
        {"format", "lapfx.amounts"},
        {"version", 1},
        {"baseline", json_of(measurement.baseline, measurement.suggested)},
        {"shots", std::move(shots)},
        {"light",
         {{"color",
           {measurement.survey->light.color.r, measurement.survey->light.color.g, measurement.survey->light.color.b}},
          {"fall_off", measurement.survey->light.fall_off}}},
        {"blood", json_of(measurement.blood)},
        {"veil", json_of(measurement.veil)},
        {"course_only", measurement.course_only},
        {"notes", measurement.notes},
        {"frames", std::move(frames)}};
    if (measurement.painted) whole["blood_by_strokes"] = json_of(*measurement.painted);
    return whole.dump(2) + "\n";
}

std::vector<FrameAmounts> read_amounts(std::string_view csv, const std::string& name) {
    std::vector<FrameAmounts> frames;
    std::size_t line = 0;
    std::string_view header;
    for (std::string_view text : split(csv, '\n')) {
        ++line;
        if (text.ends_with('\r')) text.remove_suffix(1);
        if (line == 1) {
            header = text;
            if (header != columns && header != first_columns)
                throw refused(name, line,
                              "the columns are " + quoted(text) + " instead of " + std::string(first_columns));
            continue;
        }
        if (text.empty()) continue;
        const Row row(name, line, header, text);
        constexpr double day = 86'400.0;
        FrameAmounts f;
        f.time = row.number(0, day, "86400 s");
        f.flags = row.flags();
        f.blood = row.amount(1, f.blood_measurable());
        f.veil = row.amount(4, f.measurable());
        if (row.has(light_column)) f.light = row.amount(light_column, f.measurable());
        if (row.has(gain_column) && f.measurable()) f.gain = row.amount(gain_column, true, most_gain, "4");
        if (!frames.empty() && f.time <= frames.back().time)
            throw refused(name, line, "time: " + seconds_text(f.time) + " is not after that of the line before");
        frames.push_back(f);
    }
    if (frames.empty()) throw refused(name, line, "has no amounts");
    return frames;
}

}  // namespace lapfx::match
