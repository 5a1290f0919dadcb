#include "match/frame/veil_model.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <set>

#include "lapfx/error.h"
#include "match/frame/embedded_veil_model.h"

namespace lapfx::match {

namespace {

constexpr std::size_t terms_for(std::size_t inputs) {
    return inputs + inputs * (inputs + 1) / 2;
}

// Of the ridges, for terms of size 1: on views left out .1 to .8 and .01 to .1 are as good.
constexpr double penalty_with_map = 0.1, penalty_without_map = 0.03;
constexpr double nowhere_laid = 0.5, everywhere_laid = 0.8;  // likeness
constexpr double least_size = 1e-6;
constexpr std::size_t least_examples = 100, folds = 5;

struct Terms {
    std::array<double, terms_for(veil_statistics + 1)> all{};
    std::size_t count = 0;
    void add(double term) { all[count++] = term; }
    operator std::span<const double>() const { return {all.data(), count}; }
};

/// The inputs, then all their products and squares.
Terms terms_of(const VeilFigures& figures, bool with_map) {
    Terms terms;
    for (const double statistic : figures.statistics) terms.add(statistic);
    if (with_map) terms.add(figures.map);
    const std::size_t inputs = terms.count;
    for (std::size_t i = 0; i < inputs; ++i)
        for (std::size_t j = i; j < inputs; ++j) terms.add(terms.all[i] * terms.all[j]);
    return terms;
}

Error refused(const std::string& file, const std::string& place, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = file, .place = place, .reason = reason}};
}

VeilModelError error_of(std::span<const VeilExample> examples, const std::vector<double>& said) {
    VeilModelError e;
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (std::size_t i = 0; i < examples.size(); ++i) {
        const double was = examples[i].veil, is = said[i];
        e.mean_absolute += std::abs(is - was);
        e.bias += is - was;
        x += was, y += is, xx += was * was, yy += is * is, xy += was * is;
    }
    const auto n = static_cast<double>(examples.size());
    e.mean_absolute /= n;
    e.bias /= n;
    const double spread = std::sqrt(std::max(xx - x * x / n, 0.0) * std::max(yy - y * y / n, 0.0));
    e.correlation = spread > 0.0 ? (xy - x * y / n) / spread : 0.0;
    return e;
}

std::vector<double> numbers_of(const nlohmann::json& object, const std::string& of, const char* key, std::size_t count,
                               const std::string& name) {
    std::vector<double> all;
    const auto found = object.find(key);
    const std::string place = of + "/" + key;
    if (found == object.end() || !found->is_array() || found->size() != count)
        throw refused(name, place, "is no list of " + std::to_string(count) + " numbers");
    for (const nlohmann::json& value : *found) {
        if (!value.is_number() || !std::isfinite(value.get<double>()))
            throw refused(name, place + "/" + std::to_string(all.size()), "is no number");
        all.push_back(value.get<double>());
    }
    return all;
}

}  // namespace

double VeilModel::Ridge::of(std::span<const double> terms) const {
    double sum = 0.0;
    for (std::size_t t = 0; t < terms.size(); ++t) sum += weights[t] * terms[t] / size[t];
    return sum;
}

/// Through the origin: where nothing has changed there is no veil.
VeilModel::Ridge VeilModel::learned(std::span<const VeilExample> examples, bool with_map, double penalty) {
    const std::size_t count = terms_for(veil_statistics + (with_map ? 1 : 0));
    const auto n = static_cast<double>(examples.size());
    Ridge made{.size = std::vector<double>(count, 0.0), .weights = {}};
    std::vector<Terms> all;
    for (const VeilExample& example : examples) {
        all.push_back(terms_of(example.figures, with_map));
        for (std::size_t t = 0; t < count; ++t) made.size[t] += all.back().all[t] * all.back().all[t] / n;
    }
    for (double& size : made.size) size = std::max(std::sqrt(size), least_size);
    const auto rows = static_cast<int>(count);
    cv::Mat normal = cv::Mat::zeros(rows, rows, CV_64F), right = cv::Mat::zeros(rows, 1, CV_64F);
    cv::Mat weights, term(right.size(), CV_64F);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t t = 0; t < count; ++t) term.at<double>(static_cast<int>(t)) = all[i].all[t] / made.size[t];
        normal += term * term.t();
        right += term * (examples[i].veil - (with_map ? examples[i].figures.map : 0.0));
    }
    normal += cv::Mat::eye(normal.size(), CV_64F) * (penalty * n);
    cv::solve(normal, right, weights, cv::DECOMP_CHOLESKY);
    made.weights.assign(weights.begin<double>(), weights.end<double>());
    return made;
}

VeilModel VeilModel::fitted(std::span<const VeilExample> examples) {
    VeilModel model;
    model.with_map_ = learned(examples, true, penalty_with_map);
    model.without_map_ = learned(examples, false, penalty_without_map);
    return model;
}

VeilModel VeilModel::learn(std::span<const VeilExample> examples, const std::string& origin) {
    std::set<int> views;
    for (const VeilExample& example : examples) views.insert(example.view);
    if (examples.size() < least_examples || views.size() < folds)
        throw refused("", "",
                      std::to_string(examples.size()) + " pictures of " + std::to_string(views.size()) +
                          " views are too few to learn from (at least " + std::to_string(least_examples) + " of " +
                          std::to_string(folds) + ")");
    const auto fold_of = [&views](const VeilExample& example) {
        return static_cast<std::size_t>(std::distance(views.begin(), views.find(example.view))) % folds;
    };
    std::vector<double> said(examples.size());
    for (std::size_t fold = 0; fold < folds; ++fold) {
        std::vector<VeilExample> others;
        std::copy_if(examples.begin(), examples.end(), std::back_inserter(others),
                     [&](const VeilExample& e) { return fold_of(e) != fold; });
        const VeilModel without = fitted(others);
        for (std::size_t i = 0; i < examples.size(); ++i)
            if (fold_of(examples[i]) == fold) said[i] = without.veil_of(examples[i].figures);
    }
    VeilModel model = fitted(examples);
    model.origin_ = origin;
    model.examples_ = static_cast<int>(examples.size());
    model.views_ = static_cast<int>(views.size());
    model.error_ = error_of(examples, said);
    return model;
}

double VeilModel::veil_of(const VeilFigures& figures) const {
    const double veil = std::clamp(figures.map + with_map_.of(terms_of(figures, true)), 0.0, 1.0);
    const double laid = (figures.likeness - nowhere_laid) / (everywhere_laid - nowhere_laid);
    if (laid >= 1.0) return veil;
    const double most = std::clamp(without_map_.of(terms_of(figures, false)), 0.0, 1.0);
    return veil + (1.0 - std::max(laid, 0.0)) * std::min(most - veil, 0.0);
}

std::string VeilModel::json() const {
    const nlohmann::ordered_json all{
        {"learned_from", origin_},
        {"pictures", examples_},
        {"views", views_},
        {"error_on_views_left_out",
         {{"mean_absolute", error_.mean_absolute}, {"bias", error_.bias}, {"correlation", error_.correlation}}},
        {"with_map", {{"size", with_map_.size}, {"weights", with_map_.weights}}},
        {"without_map", {{"size", without_map_.size}, {"weights", without_map_.weights}}}};
    return all.dump(1) + "\n";
}

VeilModel VeilModel::read(std::string_view json, const std::string& name) {
    const nlohmann::json all = nlohmann::json::parse(json, nullptr, false);
    if (!all.is_object()) throw refused(name, "", "is no JSON object");
    VeilModel model;
    const auto ridge_of = [&all, &name](const char* key, std::size_t terms) {
        const auto found = all.find(key);
        if (found == all.end() || !found->is_object()) throw refused(name, key, "is no object");
        Ridge read{.size = numbers_of(*found, key, "size", terms, name),
                   .weights = numbers_of(*found, key, "weights", terms, name)};
        for (const double size : read.size)
            if (size < least_size)
                throw refused(name, std::string(key) + "/size", std::to_string(size) + " is below the minimum 1e-6");
        return read;
    };
    model.with_map_ = ridge_of("with_map", terms_for(veil_statistics + 1));
    model.without_map_ = ridge_of("without_map", terms_for(veil_statistics));
    const auto number = [&name](const nlohmann::json& of, const char* key, double least, double most) {
        const auto found = of.find(key);
        if (found == of.end() || !found->is_number() ||
            !(found->get<double>() >= least && found->get<double>() <= most))
            throw refused(name, key, "is no number of " + std::to_string(least) + " to " + std::to_string(most));
        return found->get<double>();
    };
    constexpr double most_pictures = 1e9;
    model.examples_ = static_cast<int>(number(all, "pictures", 0.0, most_pictures));
    model.views_ = static_cast<int>(number(all, "views", 0.0, most_pictures));
    const auto origin = all.find("learned_from"), error = all.find("error_on_views_left_out");
    if (origin == all.end() || !origin->is_string()) throw refused(name, "learned_from", "is no text");
    model.origin_ = origin->get<std::string>();
    if (error == all.end() || !error->is_object()) throw refused(name, "error_on_views_left_out", "is no object");
    model.error_ = {.mean_absolute = number(*error, "mean_absolute", 0.0, 1.0),
                    .bias = number(*error, "bias", -1.0, 1.0),
                    .correlation = number(*error, "correlation", -1.0, 1.0)};
    return model;
}

const VeilModel& VeilModel::shipped() {
    static const VeilModel model = read(embedded_veil_model, "veil_model.json");
    return model;
}

}  // namespace lapfx::match
