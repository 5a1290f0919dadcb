// A file dialog on made-up folders, driven by the names of the widgets on the screen.
#pragma once

#include <gmock/gmock.h>

#include <map>

#include "ui/core/node.h"
#include "ui/shell/file_dialog.h"
#include "ui/support/harness.h"

namespace lapfx::ui {

struct MadeUpFiles : FileSystem {
    std::map<std::string, std::vector<FileEntry>> folders;
    std::map<std::string, std::string> faults;  ///< by folder; with "/+" at its end, the fault of making a folder in it
    std::vector<std::string> listed;
    std::string list(const std::string& folder, std::vector<FileEntry>& entries) override {
        listed.push_back(folder);
        entries.clear();
        if (const auto fault = faults.find(folder); fault != faults.end()) return fault->second;
        const auto at = folders.find(folder);
        if (at == folders.end()) return "No such file or directory";
        entries = at->second;
        return "";
    }
    Kind kind(const std::string& path) override {
        if (folders.contains(path)) return Kind::folder;
        const auto at = folders.find(std::string(parent_of(path)));
        if (at == folders.end()) return Kind::nothing;
        for (const FileEntry& e : at->second) {
            if (e.name == name_of_path(path)) return e.folder ? Kind::folder : Kind::file;
        }
        return Kind::nothing;
    }
    std::string home() override { return "/home/u"; }
    std::string make_folder(const std::string& path) override {
        if (kind(path) != Kind::nothing) return "there is a file or folder of this name already";
        const std::string in(parent_of(path));
        if (const auto fault = faults.find(in + "/+"); fault != faults.end()) return fault->second;
        folders[in].push_back({.name = std::string(name_of_path(path)), .folder = true});
        folders[path] = {};
        return "";
    }
    std::vector<FilePlace> places() override { return {{"Home", "/home/u"}, {"Computer", "/"}}; }
};

class FileDialogTest : public testing::Test {
  protected:
    explicit FileDialogTest(RunBeside beside = {}) : dialog(files, std::move(beside)) {
        files.folders["/"] = {{.name = "home", .folder = true}};
        files.folders["/home"] = {{.name = "u", .folder = true}};
        files.folders["/home/u"] = {{.name = "shot 10.exr", .size = 2'000'000, .changed = 300},
                                    {.name = "shot 9.exr", .size = 3'000'000, .changed = 100},
                                    {.name = "notes.txt", .size = 12, .changed = 200},
                                    {.name = ".secret.exr"},
                                    {.name = "plates", .folder = true},
                                    {.name = "locked", .folder = true}};
        files.folders["/home/u/plates"] = {{.name = "a.EXR"}};
        files.folders["/home/u/locked"] = {};
        files.faults["/home/u/locked"] = "Permission denied";
    }
    void open(FileRequest request) {
        dialog.open(ui.ui(), std::move(request));
        ui.frame().frame();
    }
    static FileRequest request(FileTask task) {
        return {.task = task, .title = "Plates", .filters = {{"Pictures", {".exr", ".png"}}}};
    }
    std::vector<std::string> rows() {
        std::vector<std::string> all;
        for (const Node& node : ui.ui().tree()) {
            if (node.role == Role::row) all.emplace_back(node.label);
        }
        return all;
    }
    bool says(const std::string& text) { return ui.dump().find(text) != std::string::npos; }
    MadeUpFiles files;
    FileDialog dialog;
    std::vector<std::string> chosen;
    int times = 0;
    Harness ui{[this](Ui& u) {
                   if (const auto paths = dialog.build(u)) chosen = *paths, ++times;
               },
               {1000, 700}};
};

}  // namespace lapfx::ui
