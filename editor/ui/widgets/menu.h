// Menus: from a bar, from a button, or at the pointer. All are overlays with a global name.
//
//     if (r.context)
//         ui::open_menu(u, "param menu", {.side = Placement::Side::pointer, .rect = {r.pointer.x, r.pointer.y, 0, 0}});
//     if (ui::Menu menu(u, "param menu", "Speed"); menu) {
//         if (ui::menu_item(u, "Reset", {.shortcut = "Backspace"})) value = standard;
//     }
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

void open_menu(Ui& ui, std::string_view name, const Placement& placement);

/// The open menu `name`, or nothing. Arrows go round, letters go to the next item that begins so, Enter takes, Esc and
/// a press outside close.
class Menu {
  public:
    /// `label`: what it is called in the tree.
    Menu(Ui& ui, std::string_view name, std::string_view label);
    ~Menu();
    Menu(const Menu&) = delete;
    Menu& operator=(const Menu&) = delete;
    explicit operator bool() const { return open_; }

  private:
    Ui& ui_;
    bool open_ = false;
};

struct MenuItemOptions {
    Icon icon = Icon::none;
    std::string_view shortcut = {};  ///< as text, at the right
    std::string_view tip = {};
    bool enabled = true;
    bool checked = false;
};
/// If it is chosen, closes all menus and returns true.
bool menu_item(Ui& ui, std::string_view label, const MenuItemOptions& options = {});
void menu_separator(Ui& ui);

/// A menu inside a menu: opens beside it on hover, Right or Enter. Built like Menu.
class Submenu {
  public:
    Submenu(Ui& ui, std::string_view label, Icon icon = Icon::none);
    ~Submenu();
    Submenu(const Submenu&) = delete;
    Submenu& operator=(const Submenu&) = delete;
    explicit operator bool() const { return open_; }

  private:
    Ui& ui_;
    bool open_ = false;
};

/// A bar across the window; its menus open on a press and, while one is open, on hover.
class MenuBar {
  public:
    explicit MenuBar(Ui& ui);
    ~MenuBar();
    MenuBar(const MenuBar&) = delete;
    MenuBar& operator=(const MenuBar&) = delete;

  private:
    Ui& ui_;
};
/// One menu of a bar.
class BarMenu {
  public:
    BarMenu(Ui& ui, std::string_view label);
    ~BarMenu();
    BarMenu(const BarMenu&) = delete;
    BarMenu& operator=(const BarMenu&) = delete;
    explicit operator bool() const { return open_; }

  private:
    Ui& ui_;
    bool open_ = false;
};

}  // namespace lapfx::ui
