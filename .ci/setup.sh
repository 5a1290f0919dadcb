# Sourced by editor/start and tests/run: installs what .packages names, configures and builds.
# Needs bash and Debian's own tools, nothing else: it runs before anything is installed.
# Messages go to stderr, so that the stdout of a command stays its own.
# shellcheck shell=bash

unset CDPATH  # with it, cd may print the folder and go elsewhere
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)

self=$(basename -- "$(dirname -- "$(readlink -f -- "$0")")")/${0##*/}
say() { printf '%s: %s\n' "$self" "$*" >&2; }
die() { say "$*"; exit 1; }

# wanted_packages [tests]: what .packages names, one per line; without `tests`, the part above its line [tests].
wanted_packages() {
    sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$root/.packages" |
        if [ "${1:-}" = tests ]; then grep -v -x -F '[tests]'; else sed '/^\[tests\]$/,$d'; fi
}

# What of it is not installed.
missing_packages() {
    local installed
    local -a wanted
    mapfile -t wanted < <(wanted_packages "$@")
    # dpkg-query fails when it does not know one of the names; what it prints about the others is all we need.
    installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null || true)
    printf '%s\n' "${wanted[@]}" | grep -v -x -F -f <(sed -n 's/^installed //p' <<<"$installed") || true
}

is_debian_12() {
    [ -r /etc/os-release ] && (. /etc/os-release && [ "${ID:-}" = debian ] && [ "${VERSION_ID:-}" = 12 ])
}

# install_packages [tests]
install_packages() {
    local tool lacking=
    if ! is_debian_12; then
        for tool in c++ cmake ninja pkg-config glad python3; do
            command -v "$tool" >/dev/null || lacking+=" $tool"
        done
        [ -z "$lacking" ] || die "this is not Debian 12, so nothing is installed here; it lacks:$lacking.
    .packages names all that it needs, by Debian 12's package names."
        say "warning: this is not Debian 12; going on with what is here, nothing is installed."
        return
    fi

    local -a missing as_root=(env)
    mapfile -t missing < <(missing_packages "$@")
    [ "${#missing[@]}" -gt 0 ] || return 0
    say "lapfx needs ${#missing[@]} Debian packages that are not installed (the list is .packages): ${missing[*]}"
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || die "there is no sudo to install them with. As root, run
    apt-get update && apt-get install --no-install-recommends ${missing[*]}"
        say "sudo may ask for your password now: only root can install packages. Only apt-get is run with it."
        as_root=(sudo env)
    fi
    as_root+=(DEBIAN_FRONTEND=noninteractive apt-get -q)
    # update succeeds or fails for reasons of its own (other people's package sources); install is what counts.
    "${as_root[@]}" update >&2 || say "warning: apt-get update failed; trying with the package lists that are here."
    "${as_root[@]}" install --yes --no-install-recommends "${missing[@]}" >&2 ||
        die "could not install the packages above. It needs a network, a Debian 12 package source in
    /etc/apt and the right to install (root or sudo). Once they are installed, no network is needed any more."
}

# Whether what DIR was configured for is this tree, as it lies here. A build folder that came along when the tree was
# copied or moved, or that another generator made, cannot be used as it is; cmake says so and stops.
usable_cache() {
    grep -q -x -F "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt" 2>/dev/null &&
        grep -q -x -F "CMAKE_CACHEFILE_DIR:INTERNAL=$(cd -- "$1" && pwd -P)" "$1/CMakeCache.txt" &&
        grep -q -x -F "CMAKE_GENERATOR:INTERNAL=Ninja" "$1/CMakeCache.txt"
}

# build DIR TARGET [CMAKE OPTION...]: configures and builds TARGET into DIR.
build() {
    local dir=$1 target=$2 fresh=
    shift 2
    # --fresh drops the old cache, and what is still good is kept.
    if [ -f "$dir/CMakeCache.txt" ] && ! usable_cache "$dir"; then fresh=--fresh; fi
    # ccache is a help, never a need: without a folder that it may write to, it would fail the build.
    local cache=${CCACHE_DIR:-${XDG_CACHE_HOME:-${HOME:-/nonexistent}/.cache}/ccache}
    if ! mkdir -p -- "$cache" 2>/dev/null || ! [ -w "$cache" ]; then export CCACHE_DISABLE=1; fi
    cmake ${fresh:+"$fresh"} -S "$root" -B "$dir" -G Ninja --log-level=WARNING "$@" >&2
    cmake --build "$dir" --target "$target" --parallel "$(nproc)" >&2
}
