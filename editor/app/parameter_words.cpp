#include "app/parameter_words.h"

#include <algorithm>

namespace lapfx::app {

namespace {

constexpr std::pair<std::string_view, std::string_view> all[] = {
    {"name", "title label"},
    {"description", "comment note text"},
    {"tags", "category keywords label"},

    {"bleeding", "blood bleed hemorrhage haemorrhage"},
    {"bleeding.speed", "rate velocity fast slow flow spread growth"},
    {"bleeding.max_extent", "size spread amount area reach radius limit maximum pool large small how much far"},
    {"bleeding.threshold", "cutoff edge start thin film hide"},
    {"bleeding.noise_scale", "lobe pattern ragged irregular detail frequency edge shape perlin"},
    {"bleeding.noise_strength", "ragged irregular rough jagged edge shape amplitude perlin"},
    {"bleeding.noise_octaves", "detail fine layers fractal edge perlin"},
    {"bleeding.gravity_bias", "drip run down downhill fall weight"},
    {"bleeding.crease_bias", "fold groove valley ridge wrinkle"},
    {"bleeding.bridge_gap", "seam join touch parts crack"},
    {"bleeding.rivulets", "runs streaks drips trickle stripes narrow"},
    {"bleeding.pulse_rate", "pulse artery arterial heartbeat heart beat frequency bpm spurt"},
    {"bleeding.pulse_strength", "pulse artery arterial heartbeat heart beat spurt pump"},
    {"bleeding.coagulation_time", "stop close clot seal heal hemostasis haemostasis delay"},
    {"bleeding.suction_radius", "vacuum clean aspirate remove size reach"},
    {"bleeding.irrigation_radius", "rinse wash water saline clean flush size reach"},
    {"bleeding.color_thin", "color red hue tint bright film edge"},
    {"bleeding.color_deep", "color red hue tint dark pool"},
    {"bleeding.deep_at", "depth gradient dark colour color"},
    {"bleeding.opacity", "alpha transparent transparency translucent see through cover visible"},
    {"bleeding.thickness", "height depth volume bump relief normal"},
    {"bleeding.gloss", "shiny wet specular highlight reflection shine"},
    {"bleeding.clot_darkening", "clotted dried brown black old dark colour color"},

    {"vessels", "vein artery arteries blood density map"},
    {"vessels.vessel_low", "red band pass filter detect sensitivity"},
    {"vessels.vessel_high", "red band pass filter detect sensitivity"},
    {"vessels.vessel_width", "size thickness diameter"},
    {"vessels.vessel_color", "blue vein pale hue tint color filter detect"},
    {"vessels.vessel_tolerance", "blue vein pale band pass filter range distance detect"},
    {"vessels.fat_low", "yellow hue band pass filter detect"},
    {"vessels.fat_high", "yellow hue band pass filter detect"},
    {"vessels.smoothing", "blur gaussian soft"},
    {"vessels.region", "radius area size influence brush"},
    {"vessels.vessel_threshold", "cutoff minimum limit bleeds at all"},
    {"vessels.vessel_reference", "normal standard calibration"},
    {"vessels.vessel_strength", "influence weight factor"},

    {"cautery", "burn electrocautery diathermy hook heat hot"},
    {"cautery.model", "physics simulation equation pennes"},
    {"cautery.heat_rate", "power fast speed burn"},
    {"cautery.tip_radius", "tool size hook contact"},
    {"cautery.cut_temperature", "divide sever incision"},
    {"cautery.coagulation_temperature", "seal close stop bleeding hemostasis haemostasis"},
    {"cautery.char_temperature", "black blacken burnt carbon scorch"},
    {"cautery.heat_spread", "radius size lateral thermal damage grow"},
    {"cautery.cooling_time", "cool down decay"},
    {"cautery.maximum_temperature", "limit cap hottest"},
    {"cautery.diffusivity", "conduction conductivity thermal spread"},
    {"cautery.perfusion", "blood flow cooling"},
    {"cautery.clip_length", "clip applier titanium metal size"},
    {"cautery.clip_reach", "clip applier hemostasis haemostasis stop bleeding radius"},

    {"smoke.keying",
     "key matte mask cut out chroma key green screen greenscreen blue screen background removal smoke video"},
    {"smoke.keying.luma_low", "brightness luminance black level dark threshold clip"},
    {"smoke.keying.luma_high", "brightness luminance white level bright threshold clip"},
    {"smoke.keying.key_color", "color background backdrop eyedropper"},
    {"smoke.keying.chroma_low", "saturation color tolerance similarity threshold"},
    {"smoke.keying.chroma_high", "saturation color tolerance similarity threshold"},
    {"smoke.keying.spill", "despill fringe green rim tint color"},
    {"smoke.keying.choke", "shrink erode edge rim border halo fringe"},
    {"smoke.keying.feather", "blur soft soften smooth edge"},
    {"smoke.keying.noise_scale", "pattern texture size frequency lobe turbulence"},
    {"smoke.keying.noise_strength", "pattern texture amount variation turbulence"},
    {"smoke.keying.noise_drift", "speed motion movement wind flow animate"},

    {"smoke.plume", "smoke puff cloud vapour vapor fume steam source"},
    {"smoke.plume.size", "scale large small big height width radius"},
    {"smoke.plume.density",
     "amount thick thickness opacity alpha transparent transparency strength intensity how much"},
    {"smoke.plume.rise", "speed velocity up drift float fast slow"},
    {"smoke.plume.growth", "expand spread widen grow speed"},
    {"smoke.plume.fade_in", "appear start delay attack"},
    {"smoke.plume.fade_out", "disappear vanish end linger decay release"},
    {"smoke.plume.lean", "tilt angle direction camera"},
    {"smoke.plume.softness", "soft particles edge intersection blend"},
    {"smoke.plume.fat_gain", "amount burn tissue more boost"},
    {"smoke.plume.color", "color tint grey gray white"},
    {"smoke.plume.extinction", "transmission absorption transparent red green blue light"},

    {"smoke.haze", "smoke fog veil mist cloudy murky ambient environment whole view visibility"},
    {"smoke.haze.accumulation", "amount density build up fill thick rate speed how much"},
    {"smoke.haze.ventilation", "clear clearing leave disappear air exchange decay evacuate rate speed"},
    {"smoke.haze.suction", "vacuum clear aspirate evacuate remove"},
    {"smoke.haze.unevenness", "patchy uniform even noise variation cloudiness"},
    {"smoke.haze.color", "color tint grey gray white"},
    {"smoke.haze.extinction", "transmission absorption transparent red green blue light"},

    {"smoke.particles", "specks sparks splatter droplets debris spray sizzle"},
    {"smoke.particles.rate", "amount number count how many"},
    {"smoke.particles.size", "radius diameter large small big"},
    {"smoke.particles.speed", "velocity fast slow"},
    {"smoke.particles.lifetime", "duration age how long"},
    {"smoke.particles.color", "color tint"},

    {"scene.duration", "length time seconds how long"},
    {"scene.seed", "random variation chance"},
    {"scene.gravity", "down direction fall"},
    {"scene.organ", "mesh model surface tissue"},
    {"scene.organ.scale", "size unit mm metres meters"},
    {"scene.organ.rotation", "orientation turn angle up axis"},
    {"scene.organ.color", "color tint hue tissue surface plain"},
    {"scene.tool", "instrument hook mesh model"},
    {"scene.tool.scale", "size unit mm metres meters"},
    {"scene.tool.port", "trocar entry shaft"},
    {"scene.camera", "endoscope laparoscope view"},
    {"scene.camera.eye", "position place location"},
    {"scene.camera.target", "look at direction"},
    {"scene.camera.up", "roll tilt orientation"},
    {"scene.camera.field_of_view", "fov zoom lens angle wide"},
    {"scene.camera.exposure", "brightness bright dark gain"},
    {"scene.camera.vignette", "round circle border edge dark corners"},
    {"scene.light", "lamp brightness illumination"},
    {"scene.light.intensity", "bright dark power strength"},
    {"scene.light.focus_distance", "falloff range"},
    {"scene.light.beam_angle", "spot cone spread"},
    {"scene.light.color", "color temperature tint white"},
    {"scene.reference", "surgery video match compare"},
    {"scene.reference.offset", "sync synchronise align time shift delay"},
    {"scene.reference.aspect", "ratio squeezed stretched anamorphic widescreen 4:3 16:9 pixel shape"},
};

}  // namespace

std::span<const std::pair<std::string_view, std::string_view>> parameter_words() {
    return all;
}

std::string_view everyday_words(std::string_view key) {
    const auto found = std::find_if(std::begin(all), std::end(all), [&](const auto& row) { return row.first == key; });
    return found == std::end(all) ? std::string_view() : found->second;
}

}  // namespace lapfx::app
