// lapfx fit: the values of a preset's parameters with which a scene shows as much blood and smoke as a video.
#include <iostream>
#include <optional>

#include "commands/command.h"
#include "commands/fit_run.h"
#include "match/fit/worse.h"

namespace lapfx::commands {

namespace {

void print_misfit(const char* name, const std::optional<double>& before, const std::optional<double>& after) {
    std::cout << name << ": ";
    if (!before || !after)
        std::cout << "not measurable\n";
    else
        std::cout << "RMS " << *before << " before, " << *after << " after\n";
}

void print(const match::FitResult& found) {
    std::cout.precision(3);
    print_misfit("blood", found.blood_before, found.blood_after);
    print_misfit("veil", found.veil_before, found.veil_after);
    for (const match::FittedParameter& p : found.parameters) {
        std::cout << p.parameter.key << ": ";
        if (!p.determined && p.after == p.before)
            std::cout << p.after << ", kept: not determined, " << p.why << '\n';
        else if (!p.determined)
            std::cout << p.before << " -> " << p.after << ": not determined, " << p.why << '\n';
        else
            std::cout << p.before << " -> " << p.after << " (" << p.low << " to " << p.high << ")"
                      << (p.parameter.row->unit.empty() ? "" : " ") << p.parameter.row->unit
                      << (p.at_bound ? ", at its bound" : "") << '\n';
    }
}

void run(const FitOptions& o) {
    const FitRun done = run_fit(o);
    for (const std::string& line : done.report.found.lines) std::cout << "begins with: " << line << '\n';
    const match::FitResult& result = *done.report.found.result;
    print(result);
    for (const std::string& line : done.report.found.colors) std::cout << line << '\n';
    for (const std::string& line : match::what_is_worse(result)) std::cout << "farther than before: " << line << '\n';
    std::cout << "curves drawn: " << result.curves << ", evaluations of the core: " << result.evaluations << ", "
              << done.report.of.seconds << " s" << (result.ended_early ? ", ended early: the best so far" : "") << '\n';
}

}  // namespace

Verb fit_verb() {
    const auto o = std::make_shared<FitOptions>();
    Verb verb{.name = "fit",
              .help = "Find the preset that shows as much blood and smoke as a surgery video",
              .run = [o] { run(*o); }};
    verb.argument("SCENE", "The scene (.scene.json), whose preset it starts from", &o->files.scene, {.required = true});
    verb.option("--reference", "VIDEO", "The video, or numbered images: frame_%04d.png", &o->files.reference,
                {.required = true});
    add_fit_options(verb, *o, "the scene");
    verb.option("--fitted-scene", "FILE.scene.json",
                "First move the scene's events to when smoke and blood of the reference begin, with tools added "
                "or silenced as it needs; when single contacts begin and end is fitted, too. Where the scene's own "
                "tools bring it nearer, they stay. Write that scene, with preset and reference, to this file",
                &o->files.fitted_scene);
    verb.option("--csv", "FILE", "Write the curves of reference, before and after to this file, by the scene's time",
                &o->files.csv);
    verb.option("--report", "FILE",
                "Write the result with curves, intervals and pictures as one file for a browser (.html)",
                &o->files.report);
    verb.option("-o,--output", "FILE.json", "The fitted preset", &o->files.output, {.required = true});
    verb.footer =
        "The reference is measured (see lapfx measure), the scene is drawn off-screen and measured by the same\n"
        "estimator, and the parameters are changed until blood and veil over time are nearest. For each parameter it\n"
        "prints the value before and after, with an interval that is to hold the true one in nine of ten cases, or "
        "why\n"
        "the video does not tell it. What it does not tell keeps its value, unless the curves rule that out, smoke "
        "may\n"
        "hide blood or it is seldom seen: then it goes where the curves are nearest. The report needs no other file:\n"
        "curves, parameters, and frames of the reference beside the scene before and after.\n\n"
        "Example:\n"
        "  lapfx fit samples/lagb.scene.json --reference samples/reference/operation.mp4 --window 0,6 "
        "-o fitted.json --report fit.html";
    return verb;
}

}  // namespace lapfx::commands
