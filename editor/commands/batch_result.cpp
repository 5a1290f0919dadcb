#include "commands/batch_result.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lapfx/authoring/file.h"
#include "lapfx/error.h"
#include "match/report/markup.h"
#include "match/report/report_plot.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;  // the format stands first

constexpr const char* format = "lapfx.batch";
constexpr int version = 1;
constexpr std::size_t longest_text = std::size_t{4} << 20, most_rows = 1000;

/// Five decimals: amounts and times are known no better, and hundreds of results make one page.
double rounded(double value) {
    constexpr double steps = 1e5;
    return std::round(value * steps) / steps;
}

Json json_of(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

std::optional<double> number(const Json& json) {
    if (json.is_null()) return {};
    return json.get<double>();
}

Json json_of(const BatchAmount& amount) {
    return {{"peak", json_of(amount.peak)},
            {"mean", json_of(amount.mean)},
            {"rms_before", json_of(amount.before)},
            {"rms_after", json_of(amount.after)}};
}

BatchAmount amount_of(const Json& json) {
    return {.peak = number(json.at("peak")),
            .mean = number(json.at("mean")),
            .before = number(json.at("rms_before")),
            .after = number(json.at("rms_after"))};
}

Json json_of(const std::optional<match::Amount>& amount) {
    if (!amount) return nullptr;
    return {rounded(amount->value), rounded(amount->low), rounded(amount->high)};
}

std::optional<match::Amount> interval_of(const Json& json) {
    if (json.is_null()) return {};
    return match::Amount{json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

/// What the scene showed: values, null where it is not measurable.
Json json_of(const std::vector<match::FrameAmounts>& frames, const match::AmountName& amount) {
    Json values = Json::array();
    for (const match::FrameAmounts& frame : frames)
        values.push_back(measurable(frame, amount.curve) ? Json(rounded((frame.*amount.shown).value)) : Json(nullptr));
    return values;
}

std::vector<match::FrameAmounts> frames_of(const Json& curves, const std::string& which) {
    const Json &blood = curves.at("blood" + which), &veil = curves.at("veil" + which);
    std::vector<match::FrameAmounts> frames(std::min(blood.size(), most_rows));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        match::FrameAmounts& frame = frames[i];
        frame.time = curves.at("time").at(i).get<double>();
        const std::optional<double> blood_value = number(blood.at(i)), veil_value = number(veil.at(i));
        frame.blood.value = blood_value.value_or(0.0), frame.veil.value = veil_value.value_or(0.0);
        frame.flags = !veil_value ? match::told::not_measurable : !blood_value ? match::told::dense : 0U;
    }
    return frames;
}

Json curves_of(const BatchResult& result) {
    Json curves{{"time", Json::array()}};
    for (const match::TargetPoint& aim : result.target) curves["time"].push_back(rounded(aim.time));
    for (const match::AmountName& amount : match::amount_names) {
        const std::string key = amount.key;
        curves[key] = Json::array();
        for (const match::TargetPoint& aim : result.target) curves[key].push_back(json_of(aim.*amount.aim));
        curves[key + "_before"] = json_of(result.before, amount);
        curves[key + "_after"] = json_of(result.after, amount);
    }
    return curves;
}

void read_curves(const Json& curves, BatchResult& result) {
    result.target.resize(std::min(curves.at("time").size(), most_rows));
    for (std::size_t i = 0; i < result.target.size(); ++i) {
        result.target[i].time = curves["time"].at(i).get<double>();
        for (const match::AmountName& amount : match::amount_names)
            result.target[i].*amount.aim = interval_of(curves.at(amount.key).at(i));
    }
    result.before = frames_of(curves, "_before"), result.after = frames_of(curves, "_after");
}

Json json_of(const BatchParameter& p) {
    return {{"key", p.key}, {"unit", p.unit}, {"before", p.before},        {"after", p.after},
            {"low", p.low}, {"high", p.high}, {"determined", p.determined}};
}

BatchParameter parameter_of(const Json& json) {
    return {.key = json.at("key").get<std::string>(),
            .unit = json.at("unit").get<std::string>(),
            .before = json.at("before").get<double>(),
            .after = json.at("after").get<double>(),
            .low = json.at("low").get<double>(),
            .high = json.at("high").get<double>(),
            .determined = json.at("determined").get<bool>()};
}

/// Numbers that a plot can have.
void require_sane(const BatchResult& result) {
    constexpr double longest = 1e7;  // s
    const auto is_time = [](double time) { return std::abs(time) <= longest; };
    const auto is_share = [](double share) { return share >= -1.0 && share <= 2.0; };
    bool sane = is_time(result.from) && is_time(result.to) && result.from <= result.to;
    for (const match::TargetPoint& aim : result.target) {
        sane = sane && is_time(aim.time);
        for (const match::AmountName& amount : match::amount_names)
            if (const std::optional<match::Amount>& shown = aim.*amount.aim)
                sane = sane && is_share(shown->value) && is_share(shown->low) && is_share(shown->high);
    }
    for (const auto* const frames : {&result.before, &result.after})
        for (const match::FrameAmounts& frame : *frames)
            sane = sane && is_time(frame.time) && is_share(frame.blood.value) && is_share(frame.veil.value);
    if (!sane) throw std::runtime_error("a time or an amount in it is none");
}

BatchResult result_of(const Json& json) {
    if (json.at("format") != format || json.at("version") != version)
        throw std::runtime_error("it is of another format or version");
    BatchResult result;
    result.kind = json.at("kind") == "scene" ? ItemKind::scene : ItemKind::video;
    result.fitted = json.at("fitted").get<bool>();
    result.input = json.at("input").get<std::string>();
    result.faults = json.at("faults").get<std::vector<std::string>>();
    result.unfinished = json.at("state") == "unfinished";
    result.seconds = json.at("seconds").get<double>();
    result.ended_early = json.at("ended_early").get<bool>();
    result.from = json.at("from").get<double>(), result.to = json.at("to").get<double>();
    result.blood = amount_of(json.at("blood")), result.veil = amount_of(json.at("veil"));
    for (const Json& p : json.at("parameters")) result.parameters.push_back(parameter_of(p));
    read_curves(json.at("curves"), result);
    for (const Json& picture : json.at("pictures"))
        result.pictures.push_back(
            {picture.at("name").get<std::string>(), match::bytes_of_base64(picture.at("jpeg").get<std::string>())});
    result.notes = json.at("notes").get<std::vector<std::string>>();
    require_sane(result);
    return result;
}

}  // namespace

const char* state_of(const BatchResult& result) {
    return result.unfinished ? "unfinished" : result.faults.empty() ? "done" : "failed";
}

std::string text_of(const BatchResult& result) {
    Json json{{"format", format},
              {"version", version},
              {"kind", result.kind == ItemKind::scene ? "scene" : "video"},
              {"fitted", result.fitted},
              {"state", state_of(result)},
              {"faults", result.faults},
              {"input", result.input},
              {"seconds", std::round(10.0 * result.seconds) / 10.0},
              {"ended_early", result.ended_early},
              {"from", result.from},
              {"to", result.to},
              {"blood", json_of(result.blood)},
              {"veil", json_of(result.veil)},
              {"parameters", Json::array()},
              {"notes", result.notes},
              {"curves", curves_of(result)},
              {"pictures", Json::array()}};
    for (const BatchParameter& p : result.parameters) json["parameters"].push_back(json_of(p));
    for (const BatchPicture& picture : result.pictures)
        json["pictures"].push_back({{"name", picture.name}, {"jpeg", match::base64(picture.jpeg)}});
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";  // names may hold any bytes
}

BatchResult parse_result(const std::string& text, const std::string& name) {
    try {
        return result_of(Json::parse(text));
    } catch (const std::exception& error) {
        throw Error(
            Failure::bad_input,
            Fault{.file = name, .place = "", .reason = std::string("is no result of lapfx batch: ") + error.what()});
    }
}

std::optional<BatchResult> read_result(const fs::path& folder) {
    try {
        const fs::path file = folder / result_name;
        return parse_result(read_file(file, longest_text), file.string());
    } catch (const Error&) {
        return {};
    }
}

bool is_of_batch(const fs::path& folder) {
    std::error_code error;
    if (fs::exists(folder / lock_name, error)) return true;
    if (!fs::is_regular_file(folder / result_name, error)) return false;
    std::ifstream in(folder / result_name, std::ios::binary);
    std::string head(32, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    return head.find(format) != std::string::npos;
}

}  // namespace lapfx::commands
