#!/usr/bin/env bash
# One scene, one picture (design: "same pixels"): lapfx render on OSMesa twice and the sample host give the same bytes; EGL's
# software renderer agrees with them within 1/255 in every channel of every pixel.
#
#   same_pixels.sh LAPFX LAPFX_HOST IMAGES_DIFFER ROOT
set -euo pipefail
lapfx=$1 host=$2 differ=$3 root=$4
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
scene=$root/samples/lagb.scene.json

render() { "$lapfx" render "$scene" --at 6 --size 320x256 --backend "$1" -o "$work/$2.png"; }
render osmesa first
render osmesa second
cmp "$work/first.png" "$work/second.png"

"$host" "$scene" 6 320 256 "$root/samples/clips" >"$work/host.ppm"
"$differ" "$work/first.png" "$work/host.ppm" 0

status=0
render egl egl || status=$?
if [ "$status" -eq 77 ]; then
    echo "same_pixels: no EGL here, so it was not compared"
    exit 77
fi
"$differ" "$work/first.png" "$work/egl.png" 1
