// A host in C99, as a stranger would write it: lapfx.h and the C library alone. It writes one frame of a scene as a
// PPM, without a window: the same bytes as host.cpp. A scene's events are the hand.
#include <lapfx.h>
#include <stdio.h>
#include <stdlib.h>

/// All that a simulator holds on to.
typedef struct host {
    lapfx_scene_info info;
    lapfx_scene* scene;
    lapfx_context* context;
    lapfx_organ* organ;
    lapfx_preset* preset;
    lapfx_effects* effects;
    lapfx_frame* frame;
} host;

static int open_host(host* h, const char* scene, const char* preset, const char* clips) {
    lapfx_effects_options options = LAPFX_EFFECTS_OPTIONS;
    h->info.size = sizeof h->info;
    if (lapfx_scene_load(scene, &h->scene) || lapfx_scene_get_info(h->scene, &h->info) ||
        lapfx_scene_load_organ(h->scene, &h->organ) || lapfx_preset_load(preset, &h->preset))
        return 0;
    options.seed = h->info.seed;
    for (int i = 0; i < 3; ++i) options.gravity[i] = h->info.gravity[i];
    options.clip_folders = &clips;
    options.clip_folder_count = 1;
    options.wait_for_clips = 1;
    return !lapfx_context_create(LAPFX_BACKEND_OSMESA, &h->context) &&
           !lapfx_effects_create(h->context, h->organ, h->preset, &options, &h->effects) &&
           !lapfx_effects_set_curves(h->effects, h->scene) && !lapfx_frame_create(h->context, &h->frame);
}

/// What the hand has done until `time`, as it went on.
static int play(host* h, double time) {
    const size_t count = h->info.event_count;
    lapfx_contact* events = calloc(count + 1, sizeof *events);
    int fine = events != NULL;
    for (size_t i = 0; fine && i < count; ++i) {
        events[i].size = sizeof events[i];
        fine = !lapfx_scene_get_event(h->scene, i, &events[i]);
    }
    for (size_t i = 0; fine && i < count && events[i].time <= time; ++i)
        fine =
            !lapfx_effects_set_contacts(h->effects, events, i + 1) && !lapfx_effects_seek(h->effects, events[i].time);
    free(events);
    return fine;
}

static int draw(host* h, int width, int height, double time) {
    lapfx_view view;
    unsigned depth;
    view.size = sizeof view;
    return !lapfx_scene_get_view(h->scene, width, height, &view) && !lapfx_effects_seek(h->effects, time) &&
           !lapfx_frame_begin(h->frame, width, height) && !lapfx_effects_draw_organ(h->effects, &view) &&
           !lapfx_frame_begin_smoke(h->frame) && !lapfx_frame_get_depth(h->frame, &depth) &&
           !lapfx_effects_draw_smoke(h->effects, &view, depth);
}

static int write_picture(host* h, int width, int height) {
    const size_t pixels = (size_t)width * (size_t)height;
    unsigned char* rgba = malloc(4 * pixels);
    lapfx_response response;
    int fine;
    response.size = sizeof response;
    fine = rgba != NULL && !lapfx_scene_get_response(h->scene, &response) &&
           !lapfx_frame_read(h->frame, &response, rgba, 4 * pixels);
    if (fine) printf("P6\n%d %d\n255\n", width, height);
    for (size_t i = 0; fine && i < pixels; ++i) fine = fwrite(rgba + 4 * i, 3, 1, stdout) == 1;
    free(rgba);
    return fine;
}

/// In any order; what was not made is NULL.
static void close_host(host* h) {
    lapfx_context_destroy(h->context);
    lapfx_frame_destroy(h->frame);
    lapfx_effects_destroy(h->effects);
    lapfx_preset_destroy(h->preset);
    lapfx_organ_destroy(h->organ);
    lapfx_scene_destroy(h->scene);
}

int main(int argc, char** argv) {
    host h = {0};
    int fine;
    if (argc != 7) {
        fprintf(stderr, "usage: %s SCENE PRESET CLIPS WIDTH HEIGHT SECONDS\n", argv[0]);
        return 2;
    }
    fine = open_host(&h, argv[1], argv[2], argv[3]) && play(&h, atof(argv[6])) &&
           draw(&h, atoi(argv[4]), atoi(argv[5]), atof(argv[6])) && write_picture(&h, atoi(argv[4]), atoi(argv[5]));
    if (!fine) fprintf(stderr, "%s\n", lapfx_last_message());
    close_host(&h);
    return fine ? 0 : 1;
}
