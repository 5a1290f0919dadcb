#!/usr/bin/env bash
# editor/start as a user on a machine without a display has it: start_test.sh BUILD_DIR
# From another folder, on the sample scene and on a scene of one's own: a whole video lies where it says.
set -euo pipefail
build_dir=$1
root=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../..
work=$(mktemp -d "${TMPDIR:-/tmp}/lapfx start XXXXXX")
trap 'rm -rf -- "$work"' EXIT
cd "$work"

fail() { echo "start test: $*" >&2; cat out >&2; exit 1; }

# start EXPECTED_VIDEO EXPECTED "width,height,frames" ARGUMENT...
start() {
    local video=$1 expected=$2 found
    shift 2
    rm -f -- "$video"
    env -u DISPLAY -u WAYLAND_DISPLAY LAPFX_BUILD_DIR="$build_dir" "$root/editor/start" "$@" >out 2>&1 || fail "exit code $?"
    [ -s "$video" ] || fail "there is no $video"
    found=$(ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=width,height,nb_read_frames \
        -of csv=p=0 "$video")
    [ "$found" = "$expected" ] || fail "the video is $found, expected $expected"
}

start "$build_dir/lagb.mp4" 160,128,5 --size 160x128 --fps 10 --to 0.5
grep -q -F "$build_dir/lagb.mp4" out || fail "does not say where the video is"
start "$work/own.mp4" 96,64,3 "$root/samples/lagb.scene.json" --size=96x64 --fps 10 --to 0.3 -o "$work/own.mp4"

# A display that nobody serves is no display.
rm -f -- "$work/own.mp4"
env -u WAYLAND_DISPLAY DISPLAY=:4095 LAPFX_BUILD_DIR="$build_dir" "$root/editor/start" --size 96x64 --fps 10 --to 0.3 \
    -o "$work/own.mp4" >out 2>&1 || fail "exit code $? with a dead display"
[ -s "$work/own.mp4" ] || fail "no video with a dead display"
grep -q "':4095'" out || fail "does not say that the display is dead"

# What lapfx says of a wrong scene is the last word, and its exit code is ours.
code=0
env -u DISPLAY -u WAYLAND_DISPLAY LAPFX_BUILD_DIR="$build_dir" "$root/editor/start" missing.scene.json >out 2>&1 || code=$?
[ "$code" = 2 ] || fail "exit code $code for a scene that is not there"
tail -n 1 out | grep -q '^lapfx: missing.scene.json: ' || fail "does not say what is missing"
# It installs what builds and runs lapfx; the tests install all that .packages names.
# shellcheck source=../../.ci/setup.sh
(. "$root/.ci/setup.sh"; wanted_packages) >own
# shellcheck source=../../.ci/setup.sh
(. "$root/.ci/setup.sh"; wanted_packages tests) >out
grep -q -x xdotool own && grep -q -x libglfw3-dev own || fail "editor/start does not install all that it needs"
! grep -q -x -e libgtest-dev -e libvtk9-dev -e chromium own || fail "editor/start installs what only tests need"
head -n "$(wc -l <own)" out | cmp -s - own || fail "the tests do not install what editor/start does"
grep -q -x libgtest-dev out && grep -q -x libvtk9-dev out || fail "the tests do not install all that they need"
! grep -v -x '[a-z0-9.+-]*' out || fail "not a name of a package"
echo "start test: passed"
