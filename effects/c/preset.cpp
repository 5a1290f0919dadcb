#include "c/calls.h"
#include "c/objects.h"

using namespace lapfx::c;

lapfx_status lapfx_preset_load(const char* path, lapfx_preset** preset) {
    return make<PresetObject>(__func__, preset, "preset",
                              [&] { return std::make_unique<PresetObject>(lapfx::load_preset(given(path, "path"))); });
}

lapfx_status lapfx_preset_parse(const char* json, const char* folder, lapfx_preset** preset) {
    return make<PresetObject>(__func__, preset, "preset", [&] {
        return std::make_unique<PresetObject>(
            lapfx::parse_preset(given(json, "json"), "json", folder == nullptr ? "" : folder));
    });
}

lapfx_status lapfx_preset_set(lapfx_preset* preset, const char* key, const char* value) {
    return call(__func__, [&] {
        lapfx::set_parameter(lapfx::preset_table(), &Held<PresetObject>(preset, "preset")->preset, given(key, "key"),
                             given(value, "value"));
    });
}

lapfx_status lapfx_preset_write(lapfx_preset* preset, const char** json) {
    return call(__func__, [&] {
        const Held<PresetObject> held(preset, "preset");
        given(json, "json");
        held->json = lapfx::write_preset(held->preset);
        *json = held->json.c_str();
    });
}

lapfx_status lapfx_preset_destroy(lapfx_preset* preset) {
    return destroy<PresetObject>(__func__, preset, "preset", [](const PresetObject&) {});
}
