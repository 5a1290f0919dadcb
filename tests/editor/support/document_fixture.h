// A fixture with a preset of the test's own, open in the whole editor, and with the questions that are asked about it.
#pragma once

#include "app/files/files.h"
#include "editor/support/editor_test.h"
#include "lapfx/authoring/documents.h"

namespace lapfx::test {

class EditorDocument : public SampleTest {
  protected:
    void set_speed(double speed) {
        editor().document.change("Speed", [&](document::Content& c) { c.preset.bleeding.speed = speed; });
        ui().frame();
    }
    double speed() { return editor().document.preset().bleeding.speed; }
    /// Opens a preset of the test's own and saves it.
    std::filesystem::path own_preset(const std::string& name = "own.json") {
        const std::filesystem::path file = folder() / name;
        Preset preset;
        preset.name = "own";
        preset.vessels = editor().document.preset().vessels;  // finding other vessels takes a second
        save_preset(preset, file);
        open({file.string()});
        return file;
    }
    void say(const std::string& answer) { ui().click("**/" + answer).frame(); }
    bool asked(const std::string& title) {
        ui().frame();
        return editor().files().question() != nullptr &&
               editor().files().question()->title.find(title) != std::string::npos;
    }
};

}  // namespace lapfx::test
