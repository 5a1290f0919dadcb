// Presets and scenes.
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "commands/inspect.h"
#include "lapfx/error.h"

namespace lapfx::commands {

void inspect_document(const std::filesystem::path& file) {
    using nlohmann::json;
    std::ifstream in(file, std::ios::binary);
    const json document = json::parse(in, nullptr, false);
    const auto refuse = [&](const char* place, const char* reason) {
        throw Error(Failure::bad_input, Fault{file.string(), place, reason});
    };
    if (!document.is_object()) refuse("", "is no JSON object");
    const std::string format =
        document.contains("format") && document["format"].is_string() ? document["format"] : "";
    if (format != "lapfx.preset" && format != "lapfx.scene")
        refuse("/format", "is neither \"lapfx.preset\" nor \"lapfx.scene\"");
    const json version = document.value("version", json()), name = document.value("name", json());
    std::cout << file.string() << ": " << (format == "lapfx.preset" ? "preset" : "scene") << '\n'
              << "  format              " << format << '\n'
              << "  version             " << (version.is_number_integer() ? version.dump() : "none") << '\n'
              << "  name                " << (name.is_string() ? name.get<std::string>() : "none") << '\n';
}

}  // namespace lapfx::commands
