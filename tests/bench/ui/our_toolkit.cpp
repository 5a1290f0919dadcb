#include <cmath>

#include "bench/ui/cases.h"
#include "ui/core/ui.h"
#include "ui/gl/renderer.h"
#include "ui/value/number.h"
#include "ui/widgets/basic.h"

namespace lapfx::bench {

namespace {

using namespace lapfx::ui;

class OurToolkit : public Toolkit {
  public:
    OurToolkit() : fonts_({.family = "Inter", .hinting = Hinting::slight}), ui_(fonts_, {.images = &images_}) {
        values_.resize(1000, 0.5);
        flags_.resize(1000, 0);
        texts_.resize(1000, "some text");
    }

    void show(Screen screen) override {
        screen_ = screen;
        const ScreenSize size = size_of(screen);
        input_.size = {size.width, size.height};
    }

    Drawn frame() override {
        input_.time += 1.0 / 60;
        const FrameOutput& out = ui_.frame(input_, [this](Ui&) { build(); });
        list_ = out.list;
        return {.bytes = list_->instances.size() * sizeof(Instance) + list_->clips.size() * sizeof(Rect),
                .calls = static_cast<int>(list_->batches.size()),
                .elements = list_->instances.size()};
    }

    void draw(unsigned framebuffer) override {
        if (!renderer_) renderer_ = std::make_unique<Renderer>();
        renderer_->draw(*list_, fonts_, &images_, framebuffer);
    }

    std::size_t memory() const override { return ui_.memory_used(); }

  private:
    void build() {
        Panel panel(ui_, "screen");
        switch (screen_) {
            case Screen::mixed_100:
                return mixed(20);
            case Screen::mixed_1000:
                return mixed(200);
            default:
                return;
        }
    }

    void mixed(int rows) {
        for (int i = 0; i < rows; ++i) {
            ui_.push_seed(static_cast<std::uint64_t>(i));
            {
                Row row(ui_);
                button(ui_, "Button");
                button(ui_, "Speed");
                bool on = flags_[static_cast<std::size_t>(i)] != 0;
                checkbox(ui_, "Visible", on);
                flags_[static_cast<std::size_t>(i)] = on ? 1 : 0;
                button(ui_, "Name");
                char number[2][32];
                label(ui_, ui_.join({format_number(number[0], i, 0), ": ",
                                     format_number(number[1], values_[static_cast<std::size_t>(i)], 3), " mm"}));
            }
            ui_.pop_seed();
        }
    }

    Fonts fonts_;
    ImageStore images_;
    Ui ui_;
    FrameInput input_;
    Screen screen_ = Screen::mixed_100;
    const DrawList* list_ = nullptr;
    std::unique_ptr<Renderer> renderer_;
    std::vector<double> values_;
    std::vector<int> flags_;
    std::vector<std::string> texts_;
};

}  // namespace

std::unique_ptr<Toolkit> make_ours() {
    return std::make_unique<OurToolkit>();
}

}  // namespace lapfx::bench
