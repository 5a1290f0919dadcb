// Dear ImGui 1.86, for comparison. Only this benchmark links it, never the product.
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "bench/ui/cases.h"

namespace lapfx::bench {

namespace {

class ImGuiToolkit : public Toolkit {
  public:
    ImGuiToolkit() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DeltaTime = 1.0F / 60;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        for (int i = 0; i < 512; ++i) {
            for (int c = 0; c < 8; ++c) curves_[c].push_back(std::sin(0.02F * static_cast<float>(i * (c + 1))));
        }
        for (int i = 0; i < 256; ++i) bars_.push_back(std::exp(-0.0005F * static_cast<float>((i - 128) * (i - 128))));
        values_.resize(1000, 0.5F);
        flags_.resize(1000, 0);
        texts_.resize(1000, std::vector<char>(64, 0));
        for (auto& text : texts_) std::snprintf(text.data(), text.size(), "some text");
    }
    ~ImGuiToolkit() override {
        if (drawing_) ImGui_ImplOpenGL3_Shutdown();
        ImGui::DestroyContext();
    }

    void show(Screen screen) override {
        screen_ = screen;
        const ScreenSize size = size_of(screen);
        ImGui::GetIO().DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    }

    Drawn frame() override {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("screen", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings);
        build();
        ImGui::End();
        ImGui::Render();
        const ImDrawData* data = ImGui::GetDrawData();
        Drawn drawn;
        for (int i = 0; i < data->CmdListsCount; ++i) drawn.calls += data->CmdLists[i]->CmdBuffer.Size;
        drawn.bytes = static_cast<std::size_t>(data->TotalVtxCount) * sizeof(ImDrawVert) +
                      static_cast<std::size_t>(data->TotalIdxCount) * sizeof(ImDrawIdx);
        drawn.elements = static_cast<std::size_t>(data->TotalVtxCount);
        return drawn;
    }

    void draw(unsigned) override {
        if (!drawing_) ImGui_ImplOpenGL3_Init("#version 450");
        if (!drawing_) ImGui_ImplOpenGL3_NewFrame();
        drawing_ = true;
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }

  private:
    void build() {
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
                return;
        }
    }

    void mixed(int rows) {
        ImGui::PushItemWidth(200);
        for (int i = 0; i < rows; ++i) {
            ImGui::PushID(i);
            const auto at = static_cast<std::size_t>(i);
            ImGui::Button("Button");
            ImGui::SameLine();
            ImGui::SliderFloat("Speed", &values_[at], 0, 1);
            ImGui::SameLine();
            bool on = flags_[at] != 0;
            ImGui::Checkbox("Visible", &on);
            flags_[at] = on ? 1 : 0;
            ImGui::SameLine();
            ImGui::InputText("Name", texts_[at].data(), texts_[at].size());
            ImGui::SameLine();
            ImGui::Text("%d: %.3f mm", i, static_cast<double>(values_[at]));
            ImGui::PopID();
        }
        ImGui::PopItemWidth();
    }

    void rows() {
        ImGui::BeginChild("list");
        ImGuiListClipper clipper;
        clipper.Begin(10000);
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) ImGui::Text("row %d of ten thousand", i);
        }
        ImGui::EndChild();
    }

    void plots() {
        ImGui::PlotHistogram("bars", bars_.data(), 256, 0, nullptr, 0, 1, {1200, 100});
        for (int c = 0; c < 8; ++c) {
            ImGui::PushID(c);
            ImGui::PlotLines("curve", curves_[c].data(), 512, 0, nullptr, -1, 1, {1200, 90});
            ImGui::PopID();
        }
    }

    void sliders() {
        ImGui::Columns(8, nullptr, false);
        ImGui::PushItemWidth(130);
        for (int i = 0; i < 368; ++i) {
            ImGui::PushID(i);
            ImGui::SliderFloat("Speed", &values_[static_cast<std::size_t>(i)], 0, 1);
            ImGui::PopID();
            if (i % 46 == 45) ImGui::NextColumn();
        }
        ImGui::PopItemWidth();
        ImGui::Columns(1);
    }

    Screen screen_ = Screen::mixed_100;
    std::vector<float> values_, bars_, curves_[8];
    std::vector<int> flags_;
    std::vector<std::vector<char>> texts_;
    bool drawing_ = false;
};

}  // namespace

std::unique_ptr<Toolkit> make_imgui() {
    return std::make_unique<ImGuiToolkit>();
}

}  // namespace lapfx::bench
