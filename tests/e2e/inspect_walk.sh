#!/usr/bin/env bash
# lapfx inspect on files of the third-party test data but meshes, which organ_walk.py inspects: no crash, no hang; exit
# 0, or exit 2 and at least one line that begins with "lapfx: ". Skips (77) where that data is not there. It looks at
# one file in four, or with `tests/run --deep` (LAPFX_DEEP=1) at every one, which takes some minutes.
#
#   inspect_walk.sh LAPFX DATA_FOLDER
set -euo pipefail
lapfx=$1 data=${LAPFX_TEST_DATA:-$2}
if [ ! -d "$data" ]; then
    echo "inspect_walk: no test data in $data, so nothing was inspected"
    exit 77
fi

inspect() {
    local status=0 errors
    errors=$(timeout 1200 "$1" inspect "$2" 2>&1 >/dev/null) || status=$?
    case $status in
        0) return 0 ;;
        2) grep -q '^lapfx: ' <<<"$errors" && return 0 ;;
    esac
    echo "exit $status: $2: $errors"
    return 1
}
export -f inspect
step=4
[ -z "${LAPFX_DEEP:-}" ] || step=1
files() {
    find "$data/" -type f -not -iregex '.*\.\(glb\|gltf\|obj\|off\|ply\|stl\)' -print0 | sort -z |
        sed -z -n "1~${step}p"
}
files | xargs -0 -P 2 -I{} bash -c 'inspect "$0" "$1"' "$lapfx" {} &&
    echo "inspect_walk: $(files | tr -cd '\0' | wc -c) files"
