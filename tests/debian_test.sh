#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# debian_test.sh PACKAGES [ROOT]: installs the .deb files of a folder in a bare Debian by apt, and
# uses them there. ROOT is the folder of a bare Debian, which is changed, or / for this machine
# itself, as in a container; without it debootstrap makes one and it is removed afterwards. Needs
# root, the network and some minutes. `./run package test` calls it.
set -euo pipefail
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=/var/tmp/halfspace_test  # inside the bare Debian
scene=$work/bunny.obj

fail() { printf 'debian_test: %s\n' "$1" >&2; exit 2; }
passed() { printf 'passed: %s\n' "$1"; }

# --- Inside ---------------------------------------------------------------------------------------

install() {
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null \
    2>"$work/apt.log" || { cat "$work/apt.log" >&2; fail "apt-get install $*"; }
}

# recommended PACKAGE: the first choice of each of its recommendations.
recommended() {
  dpkg-query -W -f '${Recommends}\n' "$1" | sed 's/ *|[^,]*//g; s/([^)]*)//g; s/,/ /g'
}

# same WHAT FOUND: FOUND is the CRC-32 that the program has of the scene's coverage.
same() {
  [ "$2" = "$crc" ] || { printf 'debian_test: %s found %s, not %s\n' "$1" "$2" "$crc" >&2; exit 1; }
  passed "$1"
}

crc_of() { sed -n 's/.*"coverage_crc32": *\([0-9]*\).*/\1/p' "$1"; }

program_alone() {
  install "$work"/packages/halfspace_*.deb
  halfspace render "$scene" --size 640x480 --out "$work/bunny.png" --stats "$work/bunny.json"
  crc=$(crc_of "$work/bunny.json")
  [ -n "$crc" ] && [ -s "$work/bunny.png" ] || fail 'the program drew nothing'
  passed "the program draws the bunny, alone (CRC-32 $crc)"
}

# A configuration of the user's own, which no preset is: the program builds its RTL.
rtl_on_demand() {
  printf '{"preset": "tiny", "subpixel_bits": 5, "viewport_bits": 8}\n' >"$work/own.json"
  local size=(--config "$work/own.json" --size 160x120) status=0
  halfspace cosim "$scene" "${size[@]}" 2>"$work/said" || status=$?
  [ "$status" -eq 2 ] && grep -q 'package verilator' "$work/said" ||
    fail "cosim: status $status: $(cat "$work/said")"
  passed 'cosim says that it needs Verilator'
  install $(recommended halfspace)
  halfspace render "$scene" "${size[@]}" --level cycle --out "$work/cycle.png"
  halfspace render "$scene" "${size[@]}" --level rtl --out "$work/rtl.png"
  cmp "$work/cycle.png" "$work/rtl.png"
  passed 'render --level rtl builds the RTL of a configuration of its own'
  halfspace cosim "$scene" "${size[@]}" --stall 0.3 --seed 7 --trace "$work/waves.fst"
  [ -s "$work/waves.fst" ] || fail 'no waves'
  passed 'cosim of that configuration, with waves'
}

# find_package and pkg-config with what libhalfspace-dev depends on, without what it recommends.
default_components() {
  install g++ cmake make pkg-config
  install "$work"/packages/libhalfspace*.deb
  mkdir -p "$work/default"
  cp "$work/consumer/consumer.c" "$work/default"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(default)' \
    'find_package(halfspace REQUIRED)' 'add_executable(consumer consumer.c)' \
    'target_link_libraries(consumer PRIVATE halfspace::cmodel halfspace::capi)' \
    >"$work/default/CMakeLists.txt"
  build "$work/default"
  same 'find_package(halfspace), default components' \
    "$("$work/default/build/consumer" "${bunny[@]}")"
  cc "$work/consumer/consumer.c" -o "$work/pkg_shared" $(pkg-config --cflags --libs halfspace)
  same 'pkg-config, shared' "$("$work/pkg_shared" "${bunny[@]}")"
}

build() {
  { cmake -S "$1" -B "$1/build" && cmake --build "$1/build"; } >"$work/build.log" 2>&1 ||
    { cat "$work/build.log" >&2; fail "could not build $1"; }
}

every_component() {
  install $(recommended libhalfspace-dev)
  build "$work/consumer"
  local name
  for name in consumer_c consumer_static consumer_cpp; do
    same "find_package(halfspace), $name" "$("$work/consumer/build/$name" "${bunny[@]}")"
  done
  cc "$work/consumer/consumer.c" -o "$work/pkg_static" \
    $(pkg-config --cflags --libs --static halfspace | sed 's/-lhalfspace /-l:libhalfspace.a /')
  same 'pkg-config, static' "$("$work/pkg_static" "${bunny[@]}")"
}

python_module() {
  install "$work"/packages/python3-halfspace_*.deb
  same 'the Python module' "$(/usr/bin/python3 "$work/consumer/consumer.py" "${bunny[@]}")"
}

removal() {
  local names
  names=$(dpkg-query -W -f '${Package}\n' '*halfspace*')
  [ "$(wc -w <<<"$names")" -eq 4 ] || fail "installed: $names"
  apt-get purge -y -qq $names >/dev/null 2>&1
  local left
  left=$(find /usr /etc -name '*halfspace*' ! -path '*/__pycache__/*')
  [ -z "$left" ] || { printf 'debian_test: left behind: %s\n' "$left" >&2; exit 1; }
  passed 'nothing is left behind'
}

inside() {
  trap 'printf "debian_test: line %s failed\n" "$LINENO" >&2' ERR
  bunny=("$scene" 640 480)
  apt-get update -qq
  program_alone
  rtl_on_demand
  default_components
  every_component
  python_module
  removal
}

# --- Outside --------------------------------------------------------------------------------------

# Undoes what main did, in the reverse order.
clean() {
  if [ "$root" != / ]; then
    umount "$root/dev" "$root/proc" 2>/dev/null || true
    ! mountpoint -q "$root/dev" || fail "$root/dev is still mounted"
  fi
  rm -rf "${root:?}$work"
  [ -z "$made" ] || rm -rf --one-file-system "$made"
}

main() {
  [ $# -ge 1 ] && [ $# -le 2 ] || fail 'usage: debian_test.sh PACKAGES [ROOT]'
  local packages=$1
  root=${2:-} made=
  [ "$(id -u)" -eq 0 ] || fail 'needs root, for apt and chroot'
  ls "$packages"/*.deb >/dev/null 2>&1 || fail "no .deb files in $packages"
  if [ -z "$root" ]; then
    made=$(mktemp -d)
    root=$made/root
  fi
  trap clean EXIT
  if [ -n "$made" ]; then
    local name
    name=$(. /etc/os-release && echo "$VERSION_CODENAME")
    printf 'debian_test: debootstrap %s\n' "$name" >&2
    debootstrap --variant=minbase "$name" "$root" >"$made/log" 2>&1 ||
      { tail "$made/log" >&2; fail 'debootstrap failed'; }
  fi
  [ -x "$root/usr/bin/apt-get" ] || fail "$root holds no Debian"
  mkdir -p "$root$work/packages"
  cp "$packages"/*.deb "$root$work/packages"
  cp -r "$tests/consumer" "$tests/scenes/bunny.obj" "$tests/debian_test.sh" "$root$work"
  if [ "$root" = / ]; then
    bash "$work/debian_test.sh" inside
  else
    mount -t proc proc "$root/proc"
    mount --bind /dev "$root/dev"
    cp -L /etc/resolv.conf "$root/etc/resolv.conf"
    chroot "$root" /usr/bin/env -i HOME=/root LC_ALL=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
      bash "$work/debian_test.sh" inside
  fi
}

if [ "${1:-}" = inside ]; then inside; else main "$@"; fi
