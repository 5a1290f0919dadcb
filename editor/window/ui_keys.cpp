// The functions of ui_window.h that work without a window: keys, modifiers, scales.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "window/ui_window.h"

namespace lapfx::window {

namespace {

using ui::Key;

Key named_key(int key) {
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return static_cast<Key>(static_cast<int>(Key::f1) + key - GLFW_KEY_F1);
    constexpr std::pair<int, Key> keys[] = {
        {GLFW_KEY_SPACE, Key::space},
        {GLFW_KEY_ESCAPE, Key::escape},
        {GLFW_KEY_ENTER, Key::enter},
        {GLFW_KEY_TAB, Key::tab},
        {GLFW_KEY_BACKSPACE, Key::backspace},
        {GLFW_KEY_INSERT, Key::insert},
        {GLFW_KEY_DELETE, Key::del},
        {GLFW_KEY_LEFT, Key::left},
        {GLFW_KEY_RIGHT, Key::right},
        {GLFW_KEY_UP, Key::up},
        {GLFW_KEY_DOWN, Key::down},
        {GLFW_KEY_PAGE_UP, Key::page_up},
        {GLFW_KEY_PAGE_DOWN, Key::page_down},
        {GLFW_KEY_HOME, Key::home},
        {GLFW_KEY_END, Key::end},
        {GLFW_KEY_MENU, Key::menu},
        {GLFW_KEY_KP_ENTER, Key::enter},
    };
    for (const auto& [glfw, ours] : keys) {
        if (glfw == key) return ours;
    }
    return Key::none;
}

Key number_block_key(int key, bool num_lock) {
    constexpr Key others[] = {Key::insert, Key::end,   Key::down, Key::page_down, Key::left,
                              Key::none,   Key::right, Key::home, Key::up,        Key::page_up};
    const int digit = key - GLFW_KEY_KP_0;
    if (digit >= 0 && digit <= 9) return num_lock ? static_cast<Key>('0' + digit) : others[digit];
    switch (key) {
        case GLFW_KEY_KP_DECIMAL:
            return num_lock ? ui::key_of('.') : Key::del;
        case GLFW_KEY_KP_DIVIDE:
            return ui::key_of('/');
        case GLFW_KEY_KP_SUBTRACT:
            return ui::key_of('-');
        case GLFW_KEY_KP_ADD:  // Ctrl++ does the same as Ctrl+=
        case GLFW_KEY_KP_EQUAL:
            return ui::key_of('=');
        default:
            return Key::none;
    }
}

bool has_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view("',-./;=[]`\\").find(c) != std::string_view::npos;
}

constexpr std::array scales = {least_scale, 0.875F, 1.0F, 1.125F, 1.25F, 1.5F, 1.75F, 2.0F, 2.5F, most_scale};

}  // namespace

Key key_from(int glfw_key, const char* name, bool num_lock) {
    if (const Key key = named_key(glfw_key); key != Key::none) return key;
    if (glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_EQUAL) return number_block_key(glfw_key, num_lock);
    if (glfw_key >= GLFW_KEY_0 && glfw_key <= GLFW_KEY_9) return static_cast<Key>(glfw_key);
    if (name != nullptr && name[0] != 0 && name[1] == 0 && has_name(name[0])) return ui::key_of(name[0]);
    const bool on_us_keyboard = glfw_key > GLFW_KEY_SPACE && glfw_key <= GLFW_KEY_GRAVE_ACCENT;
    return on_us_keyboard ? static_cast<Key>(glfw_key) : Key::none;
}

ui::Mods mods_from(int glfw_mods, int glfw_key, bool down) {
    constexpr std::pair<int, int> keys[] = {
        {GLFW_KEY_LEFT_SHIFT, GLFW_MOD_SHIFT},     {GLFW_KEY_RIGHT_SHIFT, GLFW_MOD_SHIFT},
        {GLFW_KEY_LEFT_CONTROL, GLFW_MOD_CONTROL}, {GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL},
        {GLFW_KEY_LEFT_ALT, GLFW_MOD_ALT},         {GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT}};
    for (const auto& [key, bit] : keys) {
        if (key == glfw_key) glfw_mods = down ? glfw_mods | bit : glfw_mods & ~bit;
    }
    ui::Mods mods = ui::Mods::none;
    if ((glfw_mods & GLFW_MOD_SHIFT) != 0) mods = mods | ui::Mods::shift;
    if ((glfw_mods & GLFW_MOD_CONTROL) != 0) mods = mods | ui::Mods::command;
    if ((glfw_mods & GLFW_MOD_ALT) != 0) mods = mods | ui::Mods::alt;
    return mods;
}

float next_scale(float scale, int way) {
    if (way > 0) {
        const auto above = std::find_if(scales.begin(), scales.end(), [&](float s) { return s > scale + 0.01F; });
        return above == scales.end() ? most_scale : *above;
    }
    const auto below = std::find_if(scales.rbegin(), scales.rend(), [&](float s) { return s < scale - 0.01F; });
    return below == scales.rend() ? least_scale : *below;
}

float choose_scale(float user, const char* environment, float screen) {
    float scale = screen > 0 && std::isfinite(screen) ? screen : 1.0F;
    if (environment != nullptr) {
        const std::string_view text(environment);
        float value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && value > 0 && std::isfinite(value))
            scale = value;
    }
    if (user > 0 && std::isfinite(user)) scale = user;
    return std::clamp(scale, least_scale, most_scale);
}

}  // namespace lapfx::window
