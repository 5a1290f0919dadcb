// Effects of the C API: what happens to the organ, and what is known of it.
#include <tuple>
#include <utility>

#include "c/calls.h"
#include "c/objects.h"

namespace lapfx::c {

namespace {

static_assert(LAPFX_WOUND_WAITING == static_cast<int>(WoundState::waiting) &&
              LAPFX_WOUND_CLOSED == static_cast<int>(WoundState::closed));

glm::dvec3 vector_of(const double* vector, const char* argument) {
    finite(argument, std::span(given(vector, argument), 3));
    return {vector[0], vector[1], vector[2]};
}

glm::dvec3 share_of(const double* vector, const char* argument) {
    const glm::dvec3 shares = vector_of(vector, argument);
    for (int i = 0; i < 3; ++i)
        if (shares[i] < 0.0 || shares[i] > 1.0)
            refuse_value(argument,
                         "element " + std::to_string(i) + " is " + std::to_string(shares[i]) + "; expected 0 to 1");
    return shares;
}

ToolAction action_of(const char* argument, int action) {
    static const std::string all =
        std::string(std::begin(tool_actions)->key) + " to " + std::string(std::rbegin(tool_actions)->key);
    return static_cast<ToolAction>(choice(argument, action, tool_action_count, all.c_str()));
}

ToolContact contact_of(const lapfx_contact& c) {
    return {.action = static_cast<ToolAction>(c.action),
            .time = c.time,
            .duration = c.duration,
            .position = {c.position[0], c.position[1], c.position[2]},
            .to = {c.to[0], c.to[1], c.to[2]},
            .power = c.power,
            .strength = c.strength};
}

/// Its place in the list is told, and made only then: a list may be set in each frame.
void check_contact(const lapfx_contact& contact, std::size_t index) {
    constexpr int actions = tool_action_count;
    if (contact.size == sizeof contact && contact.action >= 0 && contact.action < actions) return;
    const std::string argument = "contacts[" + std::to_string(index) + "]";
    action_of((argument + ".action").c_str(), sized(&contact, "lapfx_contact", argument.c_str()).action);
}

ToolSample sample_of(const lapfx_sample& s) {
    return {.time = s.time,
            .position = {s.position[0], s.position[1], s.position[2]},
            .touching = s.touching != 0,
            .action = action_of("sample.action", s.action),
            .power = s.power,
            .strength = s.strength};
}

/// The vertices of a shape, checked: a coordinate that is no number would be everywhere.
std::span<const glm::vec3> vertices_of(const float* data, std::size_t count, const char* argument) {
    constexpr float farthest = 1e9F;  // mm, as of a mesh
    for (std::size_t i = 0; i < 3 * count; ++i)
        if (!(std::abs(data[i]) <= farthest))
            refuse_value(argument, "element " + std::to_string(i) + " is " + std::to_string(data[i]) +
                                       "; expected numbers from -1e9 to 1e9");
    return {reinterpret_cast<const glm::vec3*>(data), count};
}

/// A member of both structs, of one type.
template <class T>
struct AmountInC {
    T Amounts::*from;
    T lapfx_amounts::*to;
};
constexpr std::tuple amounts_in_c{
    AmountInC{&Amounts::blood_area, &lapfx_amounts::blood_area},
    AmountInC{&Amounts::blood_volume, &lapfx_amounts::blood_volume},
    AmountInC{&Amounts::burnt_area, &lapfx_amounts::burnt_area},
    AmountInC{&Amounts::haze, &lapfx_amounts::haze},
    AmountInC{&Amounts::emission, &lapfx_amounts::emission},
    AmountInC{&Amounts::lost_samples, &lapfx_amounts::lost_samples},
    AmountInC{&Amounts::wounds, &lapfx_amounts::wounds},
    AmountInC{&Amounts::bleeding_wounds, &lapfx_amounts::bleeding_wounds},
    AmountInC{&Amounts::left_out_wounds, &lapfx_amounts::left_out_wounds},
};
static_assert(std::tuple_size_v<decltype(amounts_in_c)> == amount_count, "C has all amounts (lapfx/amounts.h)");

void fill(lapfx_amounts& out, const Amounts& amounts) {
    std::apply([&](const auto&... in_c) { ((out.*in_c.to = amounts.*in_c.from), ...); }, amounts_in_c);
}

void fill(lapfx_wound& out, const WoundStatus& status) {
    out.state = static_cast<int>(status.state);
    out.bleeds = status.bleeds ? 1 : 0;
    for (int i = 0; i < 3; ++i) out.position[i] = status.wound.position[i];
    out.start = status.wound.start;
    out.stop = status.wound.stop;
    out.strength = status.wound.strength;
    out.extent = status.extent;
}

void fill(lapfx_memory_use& out, const MemoryUse& use) {
    out.surface = use.surface;
    out.pixels = use.pixels;
    out.densities = use.densities;
    out.geometry = use.geometry;
    out.textures = use.textures;
    out.clips = use.clips;
    out.targets = use.targets;
    out.total = use.total();
}

/// Calls that change something.
template <typename Body>
lapfx_status change(const char* function, lapfx_effects* effects, const Body& body) noexcept {
    return call(function, [&] {
        const Held<EffectsObject> held(effects, "effects");
        held->shared->require_current();
        body(*held);
    });
}

/// Calls that ask for something.
template <typename Body>
lapfx_status ask(const char* function, lapfx_effects* effects, const Body& body) noexcept {
    return call(function, [&] {
        const Held<EffectsObject> held(effects, "effects");
        held->shared->require_thread();
        body(std::as_const(held->effects));
    });
}

/// Into the object's own, which it keeps.
void take_contacts(EffectsObject& object, const lapfx_contact* contacts, std::size_t count) {
    at_most("count", count, 1U << 24);
    if (count > 0) given(contacts, "contacts");
    object.contacts.clear();
    for (std::size_t i = 0; i < count; ++i) {
        check_contact(contacts[i], i);
        object.contacts.push_back(contact_of(contacts[i]));
    }
}

}  // namespace
}  // namespace lapfx::c

using namespace lapfx::c;

lapfx_status lapfx_effects_set_contacts(lapfx_effects* effects, const lapfx_contact* contacts, size_t count) {
    return change(__func__, effects, [&](EffectsObject& object) {
        take_contacts(object, contacts, count);
        object.effects.set_contacts(object.contacts);
    });
}

lapfx_status lapfx_effects_set_organ(lapfx_effects* effects, const lapfx_organ* organ, const lapfx_contact* contacts,
                                     size_t count) {
    return change(__func__, effects, [&](EffectsObject& object) {
        const Held<OrganObject> of(organ, "organ");
        if (!of->prepared)
            throw Misuse("organ: it has not been prepared; call lapfx_organ_prepare before, on another thread");
        take_contacts(object, contacts, count);
        try {
            object.effects.set_organ(of->prepared, object.contacts);
        } catch (...) {
            if (!object.effects.organ_coming()) object.coming_vertices = object.vertices;
            throw;
        }
        object.coming_vertices = of->organ.positions.size();
    });
}

lapfx_status lapfx_effects_get_organ_coming(lapfx_effects* effects, int* coming) {
    return ask(__func__, effects,
               [&](const lapfx::Effects& e) { *given(coming, "coming") = e.organ_coming() ? 1 : 0; });
}

lapfx_status lapfx_effects_push_sample(lapfx_effects* effects, const lapfx_sample* sample) {
    bool room = true;
    const auto push = [&] {
        const Held<EffectsObject> held(effects, "effects");
        room = held->effects.tool_queue().push(sample_of(LAPFX_SIZED(lapfx_sample, sample)));
    };
    const lapfx_status status = call(__func__, push, Told::kept);  // another thread may be in the host's log
    return room ? status : quiet(LAPFX_RUNTIME, "lapfx_effects_push_sample: the queue is full; the sample is lost");
}

lapfx_status lapfx_effects_set_curves(lapfx_effects* effects, const lapfx_scene* scene) {
    return change(__func__, effects, [&](EffectsObject& object) {
        object.effects.set_curves(scene == nullptr ? lapfx::Curves{} : Held<SceneObject>(scene, "scene")->scene.curves);
    });
}

lapfx_status lapfx_effects_set_shape(lapfx_effects* effects, size_t vertex_count, const float* positions,
                                     const float* normals) {
    return change(__func__, effects, [&](EffectsObject& object) {
        given(positions, "positions");
        if (vertex_count != object.vertices)
            refuse_value("vertex_count", std::to_string(vertex_count) + "; the organ has " +
                                             std::to_string(object.vertices) + " vertices");
        object.effects.set_shape(vertices_of(positions, vertex_count, "positions"),
                                 vertices_of(normals, normals == nullptr ? 0 : vertex_count, "normals"));
    });
}

lapfx_status lapfx_effects_set_gravity(lapfx_effects* effects, const double gravity[3]) {
    return change(__func__, effects,
                  [&](EffectsObject& object) { object.effects.set_gravity(vector_of(gravity, "gravity")); });
}

lapfx_status lapfx_effects_set_seed(lapfx_effects* effects, uint32_t seed) {
    return change(__func__, effects, [&](EffectsObject& object) { object.effects.set_seed(seed); });
}

lapfx_status lapfx_effects_set_organ_color(lapfx_effects* effects, const double color[3]) {
    return change(__func__, effects,
                  [&](EffectsObject& object) { object.effects.set_organ_color(share_of(color, "color")); });
}

lapfx_status lapfx_effects_seek(lapfx_effects* effects, double time) {
    return change(__func__, effects, [&](EffectsObject& object) {
        finite("time", time);
        object.effects.seek(time);
        if (!object.effects.organ_coming()) object.vertices = object.coming_vertices;
    });
}

lapfx_status lapfx_effects_get_amounts(lapfx_effects* effects, lapfx_amounts* amounts) {
    return ask(__func__, effects,
               [&](const lapfx::Effects& e) { fill(LAPFX_SIZED(lapfx_amounts, amounts), e.amounts()); });
}

lapfx_status lapfx_effects_get_wound_count(lapfx_effects* effects, size_t* count) {
    return ask(__func__, effects, [&](const lapfx::Effects& e) { *given(count, "count") = e.wounds().size(); });
}

lapfx_status lapfx_effects_get_wound(lapfx_effects* effects, size_t index, lapfx_wound* wound) {
    return ask(__func__, effects, [&](const lapfx::Effects& e) {
        fill(LAPFX_SIZED(lapfx_wound, wound), e.wounds()[index_below(index, e.wounds().size(), "wounds")]);
    });
}

lapfx_status lapfx_effects_get_contact_count(lapfx_effects* effects, size_t* count) {
    return ask(__func__, effects, [&](const lapfx::Effects& e) { *given(count, "count") = e.contacts().size(); });
}

lapfx_status lapfx_effects_get_contact(lapfx_effects* effects, size_t index, lapfx_contact* contact) {
    return ask(__func__, effects, [&](const lapfx::Effects& e) {
        lapfx_contact& out = LAPFX_SIZED(lapfx_contact, contact);
        fill(out, e.contacts()[index_below(index, e.contacts().size(), "contacts")]);
    });
}

lapfx_status lapfx_effects_pick(lapfx_effects* effects, const double origin[3], const double direction[3],
                                lapfx_hit* hit) {
    return ask(__func__, effects, [&](const lapfx::Effects& e) {
        lapfx_hit& out = LAPFX_SIZED(lapfx_hit, hit);
        const glm::dvec3 from = vector_of(origin, "origin"), along = vector_of(direction, "direction");
        if (glm::length(along) == 0.0) refuse_value("direction", "a vector of length 0 has no direction");
        const std::optional<lapfx::OrganHit> met = e.pick(from, along);
        const lapfx::OrganHit place = met.value_or(lapfx::OrganHit{});
        out.found = met ? 1 : 0;
        for (int i = 0; i < 3; ++i) out.position[i] = place.position[i];
        out.distance = place.distance;
    });
}

lapfx_status lapfx_effects_get_late(lapfx_effects* effects, int* late) {
    return ask(__func__, effects, [&](const lapfx::Effects& e) { *given(late, "late") = e.late() ? 1 : 0; });
}

lapfx_status lapfx_effects_get_memory(lapfx_effects* effects, lapfx_memory_use* use) {
    return ask(__func__, effects,
               [&](const lapfx::Effects& e) { fill(LAPFX_SIZED(lapfx_memory_use, use), e.memory_use()); });
}
