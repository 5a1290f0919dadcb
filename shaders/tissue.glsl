// Wet tissue under an endoscope: base colour, bump (normal) mapping and a specular film (paper: "the existing shader,
// which allows bump mapping and wet surface effects"). Linear light in and out.
#include "view.glsl"
#include "color.glsl"
#include "noise.glsl"
#include "overlay.glsl"

layout(location = 0) in vec3 v_position;
layout(location = 1) in vec3 v_rest;
layout(location = 2) in vec3 v_normal;
layout(location = 3) in vec4 v_tangent;
layout(location = 4) in vec2 v_uv;
layout(location = 5) in vec4 v_color;
layout(location = 6) in vec2 v_blood;
layout(location = 7) in vec2 v_marks;
layout(location = 8) in vec2 v_density;

layout(binding = 0) uniform sampler2D u_base_color;  // sRGB texture: sampled linear
layout(binding = 1) uniform sampler2D u_normal_map;

uniform vec4 u_base_factor;
uniform float u_roughness;
uniform float u_normal_scale;
uniform int u_tissue;  // 1: an organ, wet and translucent; 0: an instrument
uniform int u_plate;   // 1: the base colour is a picture of tissue in its light, thrown by u_projector
uniform mat4 u_projector;  // organ space to places of that picture, homogeneous

layout(location = 0) out vec4 o_color;

// Where no lamp shines, a plate is lit by this, so that a colour can make its picture.
const float least_plate_light = 0.02;

struct Tissue {
    vec3 albedo;
    vec3 normal;       // under the film
    vec3 film_normal;  // of the wet surface
    float roughness;   // of the wet surface
    float wetness;     // 0..1, strength of the film
    float sheen;       // strength of the broad gloss of the tissue below it
};

// The normal map's normal. Averaged mip levels are shorter than 1: the lost length is roughness (Toksvig 2005).
vec3 mapped_normal(vec3 normal, out float spread) {
    vec3 texel = texture(u_normal_map, v_uv).xyz * 2.0 - 1.0;
    spread = clamp(1.0 - length(texel), 0.0, 0.5);
    vec3 tangent = normalize(v_tangent.xyz - normal * dot(normal, v_tangent.xyz));
    vec3 bitangent = v_tangent.w * cross(normal, tangent);
    vec3 bumped = texel.x * u_normal_scale * tangent + texel.y * u_normal_scale * bitangent + max(texel.z, 0.05) * normal;
    return normalize(bumped);
}

// The wet film follows the bumps of the tissue and adds fine ripples. They break highlights into the clusters of small
// white spots that every laparoscopic picture shows.
vec3 film_normal(vec3 geometric, vec3 normal) {
    vec3 ripple = lapfx_fractal_noise(v_rest / 2.1, 2 * u_tissue, 5u).yzw;
    vec3 film = mix(geometric, normal, 0.8) - 0.045 * (ripple - geometric * dot(geometric, ripple));
    return normalize(film);
}

// The fibres of the lamp are around the lens. The light is a little above it, so that highlights are not exactly in the
// centre.
vec3 light_direction() {
    return normalize(u_eye.xyz - v_position + 4.0 * vec3(u_view[0][1], u_view[1][1], u_view[2][1]));
}

// The lamp, with tissue that scatters light under its surface, red farthest: the shadow side stays reddish.
vec3 body_light(vec3 normal) {
    vec3 view = normalize(u_eye.xyz - v_position);
    vec3 wrap = u_tissue == 1 ? vec3(0.32, 0.12, 0.10) : vec3(0.0);
    vec3 diffuse = max((vec3(dot(normal, light_direction())) + wrap) / ((1.0 + wrap) * (1.0 + wrap)), 0.0);
    vec3 ambient = u_beam.y * vec3(1.0, 0.62, 0.55) * (0.6 + 0.4 * dot(normal, view));
    return lapfx_lamp(v_position) * diffuse + u_light.rgb * ambient;
}

// The light of the plate's picture before the camera, which makes the picture of it again.
vec3 plate_light() {
    vec4 thrown = u_projector * vec4(v_rest, 1.0);
    vec2 half_texel = 0.5 / vec2(textureSize(u_base_color, 0));
    vec2 place = clamp(thrown.xy / thrown.w, half_texel, 1.0 - half_texel);  // the texture repeats
    vec3 picture = texture(u_base_color, place).rgb;
    if (u_plate_film.w == 0.0) return picture / u_beam.z;
    vec3 light = lapfx_before_film(picture, u_plate_film.xyz);
    vec3 grey = vec3(dot(light, vec3(0.2126, 0.7152, 0.0722)));
    return mix(grey, light, 1.0 / max(u_plate_light.a, 0.1)) / u_plate_light.rgb;
}

// A plate has the colour that the lamp shows as its picture, so that blood and char over it are lit like any. It has no
// gloss of its own: that is in the picture.
Tissue plate_tissue(vec3 geometric) {
    Tissue tissue;
    tissue.albedo = plate_light() / max(body_light(geometric), least_plate_light);
    tissue.normal = tissue.film_normal = geometric;
    tissue.roughness = u_roughness;
    tissue.wetness = tissue.sheen = 0.0;
    return tissue;
}

Tissue bare_tissue(vec3 geometric) {
    if (u_plate == 1) return plate_tissue(geometric);
    vec4 base = texture(u_base_color, v_uv) * u_base_factor * v_color;
    float spread;
    Tissue tissue;
    tissue.albedo = base.rgb;
    tissue.normal = mapped_normal(geometric, spread);
    tissue.film_normal = film_normal(geometric, tissue.normal);
    tissue.roughness = clamp(sqrt(u_roughness * u_roughness + spread), 0.08, 1.0);
    tissue.wetness = 1.0;
    tissue.sheen = 0.6;
    return tissue;
}

vec3 facing_normal() { return normalize(v_normal) * (gl_FrontFacing ? 1.0 : -1.0); }

// GGX with Smith's visibility (height-correlated approximation, Hammon 2017) and Schlick's Fresnel.
float specular(vec3 n, vec3 v, vec3 l, float roughness) {
    vec3 h = normalize(v + l);
    float a = roughness * roughness, nh = max(dot(n, h), 0.0), nl = max(dot(n, l), 0.0), nv = max(dot(n, v), 1e-3);
    float d = nh * nh * (a * a - 1.0) + 1.0;
    float distribution = a * a / (3.14159265 * d * d);
    float visibility = 0.5 / max(mix(2.0 * nl * nv, nl + nv, a), 1e-3);
    float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(v, h), 0.0), 5.0);
    return distribution * visibility * fresnel * nl;
}

vec3 shade(Tissue tissue, vec3 geometric) {
    vec3 view = normalize(u_eye.xyz - v_position);
    vec3 light = light_direction();
    vec3 lamp = lapfx_lamp(v_position);
    vec3 body = body_light(tissue.normal);
    vec3 color = tissue.albedo * (u_plate == 1 ? max(body, least_plate_light) : body);
    // The film's light is white: dielectric. A broad, weak lobe below it is the sheen of the tissue.
    float film = specular(tissue.film_normal, view, light, tissue.roughness);
    float sheen = specular(tissue.normal, view, light, min(tissue.roughness + 0.32, 0.9));
    // A white surface returns `lamp`, so the lamp's irradiance is pi times that.
    return color + lamp * tissue.wetness * (3.14159265 * film + tissue.sheen * sheen);
}

vec3 overlaid(vec3 shaded) {
    return u_overlay == OVERLAY_NONE ? shaded : lapfx_overlay(shaded, texture(u_density, v_uv).rg * v_density, v_blood.x);
}
