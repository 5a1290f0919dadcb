#!/usr/bin/env bash
# One scene, one picture (design: "same pixels"): lapfx render (Preview) on OSMesa twice gives the same bytes, and so
# does the sample host, which loads, sees and draws by itself with Effects, and is told of a contact when it begins;
# EGL's software renderer agrees with them within 1/255 in every channel of every pixel. With curves over time as well:
# all three at once, and with tests/run --deep (LAPFX_DEEP=1) each by itself.
#
#   same_pixels.sh LAPFX LAPFX_HOST IMAGES_DIFFER SHIPPED: the folder of presets and samples
set -euo pipefail
lapfx=$1 host=$2 differ=$3 root=$4
export LAPFX_DATA=$root
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
scene=$root/samples/lagb.scene.json
preset=$root/presets/gastric_banding.json
# The host draws no instrument. Each curve by itself changes the picture at 6 s.
python3 - "$scene" "$work" <<'END'
import json, os, sys
scene = json.load(open(sys.argv[1], encoding="utf-8"))
scene["organ"]["file"] = os.path.join(os.path.dirname(sys.argv[1]), scene["organ"]["file"])
scene["preset"] = scene["tool"]["file"] = scene["reference"]["file"] = ""
curves = {"cautery_power": [(1, 1), (2, 0.4), (5, 0.8)], "bleeding_strength": [(1, 0.2), (4, 1.4), (5, 0.6)],
          "emission": [(0, 0.3), (5, 2)]}
points = {key: [{"time": time, "value": value} for time, value in curve] for key, curve in curves.items()}
for name, some in {"bare": {}, "curves": points, **{key: {key: points[key]} for key in points}}.items():
    with open(os.path.join(sys.argv[2], name + ".scene.json"), "w", encoding="utf-8") as file:
        some = {**{key: [] for key in curves}, **some}
        json.dump({**scene, "events": scene["events"][::-1], "curves": some}, file)  # in any order
END

# SCENE SECONDS BACKEND NAME
render() { "$lapfx" render "$1" --preset "$preset" --at "$2" --size 320x256 --backend "$3" -o "$work/$4.png"; }
# SCENE SECONDS SHADER NAME
host() { "$host" "$1" "$preset" "$root/samples/clips" "$3" 320 256 "$2" >"$work/$4.ppm"; }
# PICTURE PICTURE: else nothing was compared
differs() {
    if "$differ" "$work/$1" "$work/$2" 0 >"$work/told"; then
        echo "same_pixels: $1 and $2 are the same"
        exit 1
    fi
}
render "$scene" 6 osmesa first
render "$scene" 6 osmesa second
cmp "$work/first.png" "$work/second.png"

# At 6 s there is blood, a plume and haze; at 8.3 s the instrument has left.
render "$work/bare.scene.json" 6 osmesa bare
host "$work/bare.scene.json" 6 lapfx bare
"$differ" "$work/bare.png" "$work/bare.ppm" 0
render "$scene" 8.3 osmesa later
host "$scene" 8.3 lapfx later
"$differ" "$work/later.png" "$work/later.ppm" 0
differs first.png later.ppm
all=(curves)
if [ -n "${LAPFX_DEEP:-}" ]; then
    all=(cautery_power bleeding_strength emission curves)
else
    echo "same_pixels: the three curves together; tests/run --deep draws each by itself, too"
fi
for curves in "${all[@]}"; do
    render "$work/$curves.scene.json" 6 osmesa "$curves"
    host "$work/$curves.scene.json" 6 lapfx "$curves"
    "$differ" "$work/$curves.png" "$work/$curves.ppm" 0
    differs bare.png "$curves.ppm"
done

status=0
render "$scene" 6 egl egl || status=$?
if [ "$status" -eq 77 ]; then
    echo "same_pixels: no EGL here, so it was not compared"
    exit 77
fi
"$differ" "$work/first.png" "$work/egl.png" 1
