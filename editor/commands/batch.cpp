// lapfx batch: many scenes and videos, fitted or measured in a process for each.
#include <iostream>
#include <limits>
#include <optional>

#include "commands/batch_list.h"
#include "commands/batch_run.h"
#include "commands/batch_table.h"
#include "commands/command.h"
#include "commands/file_kind.h"
#include "commands/matched_videos.h"
#include "commands/options.h"
#include "commands/say.h"
#include "commands/shown_scene.h"
#include "lapfx/authoring/file.h"
#include "lapfx/preset.h"

namespace lapfx::commands {

namespace {

namespace fs = std::filesystem;

struct ListOptions {
    std::string folder, results;
};

struct RunOptions {
    BatchRunOptions run;
    std::string folder, results, item;
    std::optional<std::size_t> number;
};

void list(const ListOptions& o) {
    const BatchList found = batch_items(o.folder, o.results);
    for (const BatchItem& item : found.items) std::cout << item.name << '\n';
    for (const std::string& line : found.notes) say(line);
}

BatchItem item_of(const RunOptions& o) {
    if (o.number.has_value() == !o.item.empty())
        throw wrong_option("ITEM", o.number ? "\"" + o.item + "\" and --number: one of them says which item"
                                            : "is missing: a line of `lapfx batch list`, or --number");
    if (!o.number) return batch_item(o.folder, o.item);
    const BatchList list = batch_items(o.folder, o.results);
    if (*o.number < 1 || *o.number > list.items.size())
        throw wrong_option(
            "--number", std::to_string(*o.number) + " is none of the list's 1 to " + std::to_string(list.items.size()));
    return list.items[*o.number - 1];
}

/// What is wrong with the command is told before an item is touched: else each would fail by it.
void check(const RunOptions& o) {
    const FitOptions& fit = o.run.fit;
    if (!fit.match.window.empty()) (void)window_of(fit.match.window, std::numeric_limits<double>::max(), "item");
    const std::vector<std::string> presets =
        fit.files.preset.empty() ? std::vector<std::string>() : std::vector{fit.files.preset};
    if (!fit.files.preset.empty()) (void)load_preset(fit.files.preset);
    if (!fit.files.scene.empty()) (void)open_shown(fit.files.scene, presets, {});
    std::error_code error;
    if (fs::exists(o.results, error) && !fs::is_directory(o.results, error))
        throw wrong_option("--into", "\"" + o.results + "\" is not a folder");
    if (will_be_same_file(o.results, o.folder))
        throw wrong_option("--into", "\"" + o.results + "\" is the folder of the items");
}

void run(const RunOptions& given) {
    RunOptions o = given;
    o.run.folder = o.folder, o.run.results = o.results;
    const BatchItem item = item_of(o);
    check(o);
    run_item(o.run, item, std::cout);
}

void collect(const std::string& results) {
    const std::vector<BatchEntry> entries = batch_entries(results);
    const fs::path folder = results;
    write_file(folder / "table.csv", table_csv(entries));
    write_file(folder / "index.html", index_html(entries));
    std::size_t done = 0, failed = 0;
    for (const BatchEntry& entry : entries) {
        const std::string state = state_of(entry);
        if (state == "unfinished")
            say(entry.item + ": is not finished" +
                (entry.result && !entry.result->faults.empty() ? ": " + entry.result->faults.front() : ""));
        else
            ++(state == "done" ? done : failed);
    }
    std::cout << entries.size() << (entries.size() == 1 ? " item, " : " items, ") << done << " done, " << failed
              << " failed, " << entries.size() - done - failed << " unfinished\n";
}

Verb list_part() {
    const auto o = std::make_shared<ListOptions>();
    Verb part{.name = "list", .help = "Print the scenes and videos of a folder, one a line", .run = [o] { list(*o); }};
    part.argument("FOLDER", "The folder", &o->folder, {.required = true});
    part.option("--into", "RESULTS", "The folder of the results, which is not looked through", &o->results);
    part.footer =
        "Scenes are *.scene.json, videos have a name that `lapfx help files` lists. Folders below are looked through,\n"
        "too, but not those of results. A video that is there twice, by its content, is listed once, and one that a\n"
        "scene of the list has as its reference is not: the scene is fitted to it. What is left out is told on "
        "stderr.\n\n"
        "Example:\n  lapfx batch list samples";
    return part;
}

Verb run_part() {
    const auto o = std::make_shared<RunOptions>();
    Verb part{.name = "run", .help = "Fit or measure one item of the list", .run = [o] { run(*o); }};
    part.argument("FOLDER", "The folder of the list", &o->folder, {.required = true});
    part.argument("ITEM", "A line of the list", &o->item);
    part.option("--number", "N",
                "The item by its line in the list, from 1, for job arrays; the folder must not change meanwhile",
                &o->number, {.number = Number::whole});
    part.option("--into", "RESULTS", "The folder of the results; made where it is missing", &o->results,
                {.required = true});
    part.option("--scene", "FILE.scene.json", "The scene that videos are fitted with", &o->run.fit.files.scene);
    add_fit_options(part, o->run.fit, "a scene");
    part.flag("--again", "Also what is done", &o->run.again);
    part.footer =
        "A scene is fitted to the reference that it names. A video is fitted with --scene, whose events move to when\n"
        "smoke and blood of the video begin, and without --scene it is measured.\n\n"
        "RESULTS/ITEM/ gets amounts.csv, of a fit also fitted.json, fitted.scene.json, curves.csv and report.html, "
        "and\n"
        "last of all result.json. An item that has one, made from the same files by the same options, is not done "
        "again:\n"
        "it is told, with the exit code that it had. One whose input is at fault (exit 2) has one, too; one that "
        "failed\n"
        "otherwise (exit 1) or was killed is done by the next run. Two processes never do one item: the second says\n"
        "so and ends with 0.\n\n"
        "Example:\n  lapfx batch run samples reference/operation.mp4 --window 0,2 --into results";
    return part;
}

Verb collect_part() {
    const auto results = std::make_shared<std::string>();
    Verb part{.name = "collect", .help = "Make a table and an index page of all results", .run = [results] {
                  collect(*results);
              }};
    part.argument("RESULTS", "The folder of the results", results.get(), {.required = true});
    part.footer =
        "RESULTS/table.csv has a row for each item: state and fault, peak and mean of blood and veil of the video, of "
        "a\n"
        "fit their root mean square differences before and after, and of each parameter its value before and after\n"
        "and its interval. RESULTS/index.html shows them with curves and pictures, and leads to the reports.\n\n"
        "Example:\n  lapfx batch collect results";
    return part;
}

}  // namespace

Verb batch_verb() {
    Verb verb{.name = "batch", .help = "Fit or measure many scenes and videos, one in each process"};
    verb.parts = {list_part(), run_part(), collect_part()};
    verb.footer =
        "What starts the processes is GNU parallel, the job array of a cluster, or a loop:\n\n"
        "    lapfx batch list videos | parallel lapfx batch run videos {} --scene usual.scene.json --into results\n"
        "    lapfx batch collect results\n\n"
        "Run again, it goes on where it stopped.";
    return verb;
}

}  // namespace lapfx::commands
