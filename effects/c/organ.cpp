#include "c/calls.h"
#include "c/objects.h"
#include "lapfx/refine.h"

namespace lapfx::c {

std::unique_ptr<OrganObject> organ_object(const char* function, Organ organ) {
    for (const std::string& warning : organ.warnings) warn(function, warning);
    return std::make_unique<OrganObject>(std::move(organ));
}

namespace {

OrganOptions options_of(const lapfx_organ_options* options) {
    if (options == nullptr) return {};
    const lapfx_organ_options& o = LAPFX_SIZED(lapfx_organ_options, options);
    finite("options.scale", o.scale);
    finite("options.rotation", o.rotation);
    if (o.scale < 0) refuse_value("options.scale", std::to_string(o.scale) + " is below 0 mm per unit");
    return {.scale = o.scale,
            .rotation = {o.rotation[0], o.rotation[1], o.rotation[2]},
            .texture = o.texture == nullptr ? "" : o.texture};
}

template <typename T, typename Component>
std::span<const T> span_of(const Component* data, std::size_t count) {
    static_assert(sizeof(T) % sizeof(Component) == 0 && alignof(T) == alignof(Component));
    return {reinterpret_cast<const T*>(data), data == nullptr ? 0 : count};
}

Mesh mesh_of(const lapfx_mesh& mesh) {
    return {.positions = span_of<glm::vec3>(given(mesh.positions, "mesh.positions"), mesh.vertex_count),
            .indices = span_of<std::uint32_t>(given(mesh.indices, "mesh.indices"), mesh.index_count),
            .normals = span_of<glm::vec3>(mesh.normals, mesh.vertex_count),
            .uvs = span_of<glm::vec2>(mesh.uvs, mesh.vertex_count),
            .colors = span_of<glm::vec4>(mesh.colors, mesh.vertex_count)};
}

}  // namespace
}  // namespace lapfx::c

using namespace lapfx::c;

lapfx_status lapfx_organ_load(const char* path, const lapfx_organ_options* options, lapfx_organ** organ) {
    return make<OrganObject>(__func__, organ, "organ", [&, function = __func__] {
        return organ_object(function, lapfx::load_organ(given(path, "path"), options_of(options)));
    });
}

lapfx_status lapfx_organ_create(const lapfx_mesh* mesh, lapfx_organ** organ) {
    return make<OrganObject>(__func__, organ, "organ", [&, function = __func__] {
        return organ_object(function, lapfx::make_organ(mesh_of(LAPFX_SIZED(lapfx_mesh, mesh))));
    });
}

lapfx_status lapfx_organ_refine(const lapfx_organ* organ, lapfx_organ** refined) {
    return make<OrganObject>(__func__, refined, "refined", [&] {
        return std::make_unique<OrganObject>(lapfx::refine(Held<OrganObject>(organ, "organ")->organ).organ);
    });
}

lapfx_status lapfx_organ_prepare(lapfx_organ* organ, const lapfx_preset* preset) {
    return call(__func__, [&] {
        const Held<OrganObject> held(organ, "organ");
        lapfx::VesselParameters vessels;
        if (preset != nullptr) vessels = Held<PresetObject>(preset, "preset")->preset.vessels;
        held->prepared = lapfx::prepare_organ(held->organ, vessels);
    });
}

lapfx_status lapfx_organ_get_data(const lapfx_organ* organ, lapfx_organ_data* data) {
    return call(__func__, [&] {
        const Held<OrganObject> held(organ, "organ");
        const lapfx::Organ& from = held->organ;
        lapfx_organ_data& out = LAPFX_SIZED(lapfx_organ_data, data);
        out.vertex_count = from.positions.size();
        out.index_count = from.indices.size();
        out.positions = &from.positions.data()->x;
        out.normals = &from.normals.data()->x;
        out.uvs = &from.uvs.data()->x;
        out.colors = &from.colors.data()->x;
        out.indices = from.indices.data();
    });
}

lapfx_status lapfx_organ_destroy(lapfx_organ* organ) {
    return destroy<OrganObject>(__func__, organ, "organ", [](const OrganObject&) {});
}
