#include <cmath>

#include "bench/ui/cases.h"
#include "ui/canvas/histogram.h"
#include "ui/canvas/plot.h"
#include "ui/core/node.h"
#include "ui/core/ui.h"
#include "ui/gl/renderer.h"
#include "ui/value/number.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/text_field.h"

namespace lapfx::bench {

namespace {

using namespace lapfx::ui;

class OurToolkit : public Toolkit {
  public:
    OurToolkit() : fonts_({.family = "Inter", .hinting = Hinting::slight}), ui_(fonts_, {.images = &images_}) {
        values_.resize(1000, 0.5);
        flags_.resize(1000, 0);
        texts_.resize(1000, "some text");
        for (int i = 0; i < 256; ++i)
            bars_.push_back(static_cast<std::uint32_t>(1000 * std::exp(-0.0005 * (i - 128) * (i - 128))));
        for (int c = 0; c < 8; ++c) {
            for (int i = 0; i < 512; ++i) curves_[c].push_back(std::sin(0.02 * i * (c + 1)));
            curve_data_[c].set(std::span<const double>(curves_[c]));
        }
        for (int i = 0; i < 1000000; ++i)
            million_.push_back(static_cast<float>(std::sin(1e-4 * i) + 0.1 * std::sin(1.7 * i)));
        million_data_.set(std::span<const float>(million_));
    }

    void show(Screen screen) override {
        screen_ = screen;
        const ScreenSize size = size_of(screen);
        input_.size = {size.width, size.height};
    }

    void change_all(bool change) override { change_all_ = change; }

    Drawn frame() override {
        if (change_all_) ui_.set_theme(&ui_.theme() == &dark_theme() ? light_theme() : dark_theme());
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
            case Screen::small:
                return mixed(20);
            case Screen::mixed_1000:
                return mixed(200);
            case Screen::rows_10000:
                return rows();
            case Screen::plots:
                return plots();
            case Screen::sliders_368:
                return sliders();
            case Screen::million:
                return million();
        }
    }

    void mixed(int rows) {
        for (int i = 0; i < rows; ++i) {
            const auto at = static_cast<std::size_t>(i);
            ui_.push_seed(static_cast<std::uint64_t>(i));
            {
                Row row(ui_);
                button(ui_, "Button");
                param(ui_, "Speed", values_[at], {.maximum = 1, .step = 0.001});
                ui_.last().size[0] = px(300);
                bool on = flags_[at] != 0;
                checkbox(ui_, "Visible", on);
                flags_[at] = on ? 1 : 0;
                text_field(ui_, "Name", texts_[at], {.width = px(300)});
                char number[2][32];
                label(ui_, ui_.join({format_number(number[0], i, 0), ": ", format_number(number[1], values_[at], 3),
                                     " mm"}));
            }
            ui_.pop_seed();
        }
    }

    void rows() {
        virtual_rows(ui_, "list", 10000, ui_.row_height(), [&](std::size_t row) {
            char number[32];
            label(ui_, ui_.join({"row ", format_number(number, static_cast<double>(row), 0), " of ten thousand"}));
        });
    }

    void plots() {
        histogram(ui_, "bars", {.bins = bars_}, nullptr, {.height = 100 / ui_.em(1)});
        for (int c = 0; c < 8; ++c) {
            ui_.push_seed(static_cast<std::uint64_t>(c));
            const PlotSeries series[] = {{.name = "curve", .data = &curve_data_[c]}};
            plot(ui_, "curve", series, {.height = px(90)});
            ui_.pop_seed();
        }
    }

    /// A million samples, of which each frame shows another part.
    void million() {
        const double from = std::fmod(input_.time, 1.0) * 4e5;
        million_state_.x = {from, from + 5e5};
        million_state_.y = {-1.2, 1.2};
        million_state_.fitted = false;
        const PlotSeries series[] = {{.name = "samples", .data = &million_data_}};
        plot(ui_, "million", series, {.height = px(400), .state = &million_state_});
    }

    void sliders() {
        Row columns(ui_, {.width = grow(), .height = grow(), .cross = ChildAlign::start});
        for (int column = 0; column < 8; ++column) {
            Column one(ui_, {.width = grow(), .gap = 0});
            for (int i = 0; i < 46; ++i) {
                const int at = column * 46 + i;
                ui_.push_seed(static_cast<std::uint64_t>(at));
                param(ui_, "Speed", values_[static_cast<std::size_t>(at)], {.maximum = 1, .step = 0.001});
                ui_.pop_seed();
            }
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
    std::vector<double> curves_[8];
    std::vector<std::uint32_t> bars_;
    std::vector<float> million_;
    PlotData curve_data_[8], million_data_;
    PlotState million_state_;
    bool change_all_ = false;
    std::vector<std::string> texts_;
};

}  // namespace

std::unique_ptr<Toolkit> make_ours() {
    return std::make_unique<OurToolkit>();
}

}  // namespace lapfx::bench
