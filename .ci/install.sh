# Sourced by ./fly and ./check: installs what Rapidity needs on Debian 12 or newer, says what is needed elsewhere.
# Nothing is done, and no time spent, when everything is there. The system's package sources stay as they are.

# What building and flying needs.
flight_packages=(
  g++ cmake ninja-build pkg-config
  libglfw3-dev libglm-dev libepoxy-dev libimgui-dev libtinygltf-dev libopenexr-dev libstb-dev libsqlite3-dev
  libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libembree-dev libtbb-dev zlib1g-dev
  libopenxr-dev libopenxr-loader1 libx11-dev
  libegl-dev libgl-dev libegl1 libgl1-mesa-dri libegl-mesa0 libglx-mesa0 fonts-dejavu-core ffmpeg
)
# What the tests need on top. Catch2 3 is handled on its own: Debian 12 has it in its backports only.
test_packages=(xvfb xauth xdotool x11-utils sqlite3 libopenmpi-dev openmpi-bin gnuplot-nox openxr-layer-corevalidation)
# What Monado is built with, the headset in software that the tests fly in.
monado_packages=(
  python3-minimal xz-utils libeigen3-dev glslang-tools libvulkan-dev libopengl-dev libglx-dev libgles-dev libudev-dev
  libcjson-dev libbsd-dev libx11-xcb-dev libxcb-randr0-dev libxrandr-dev mesa-vulkan-drivers
)

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "This needs root: install sudo, or run as root: $*" >&2
    return 1
  fi
}

is_debian() {
  command -v apt-get >/dev/null && command -v dpkg-query >/dev/null && grep -qsE '^ID(_LIKE)?=.*debian' /etc/os-release
}

missing_packages() {
  local package
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done
}

have_catch2_3() {
  local version
  version=$(dpkg-query -W -f '${Version}' libcatch2-dev 2>/dev/null) && [ -n "$version" ] ||
    version=$(dpkg-query -W -f '${Version}' catch2 2>/dev/null) && [ -n "$version" ] || return 1
  dpkg --compare-versions "$version" ge 3
}

apt_install() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$@" >&2
}

refresh_package_lists() {
  if [ -z "${package_lists_fresh:-}" ]; then
    as_root apt-get update >&2 || return 1
    package_lists_fresh=yes
  fi
}

# Catch2 3 from the release's backports, through a package list of its own that is thrown away afterwards.
install_catch2_3() {
  refresh_package_lists || return 1
  local candidate codename mirror folder options result
  candidate=$(apt-cache policy catch2 | sed -n 's/ *Candidate: //p')
  if dpkg --compare-versions "${candidate:-0}" ge 3; then
    apt_install catch2
    return
  fi
  codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
  mirror=$(debian_mirror)
  if [ -z "$mirror" ]; then
    echo "Catch2 3 is needed for the tests, and no Debian $codename source was found to take it from." >&2
    return 1
  fi
  folder=$(mktemp -d)
  chmod 755 "$folder"
  mkdir -p "$folder/lists/partial"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $codename-backports main" >"$folder/sources.list"
  options=(-o "Dir::Etc::sourcelist=$folder/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$folder/lists"
    -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=)
  result=0
  { as_root apt-get "${options[@]}" update &&
    as_root env DEBIAN_FRONTEND=noninteractive apt-get "${options[@]}" install -y --no-install-recommends catch2; } >&2 || result=$?
  as_root rm -rf "$folder"
  return $result
}

# The mirror that this system takes the packages of its release from.
debian_mirror() {
  apt-get indextargets --format '$(CODENAME) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
    awk -v codename="$(. /etc/os-release && echo "$VERSION_CODENAME")" '$1 == codename && $2 == "main" { print $3; exit }'
}

# Monado 25 as an OpenXR runtime inside the program, without a service or a screen: built once, from Debian 13's source
# package, into a cache outside of the source tree. About two minutes on two cores.
monado_folder() {
  echo "${RAPIDITY_MONADO_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/rapidity/monado-25.0.0}"
}

install_monado() {
  local folder mirror missing work options result driver off=()
  folder=$(monado_folder)
  if [ -e "$folder/share/openxr/1/openxr_monado.json" ]; then
    return 0
  fi
  mirror=$(debian_mirror)
  if [ -z "$mirror" ]; then
    echo "Monado is needed for the headset's tests, and no Debian source was found to take it from." >&2
    return 1
  fi
  mapfile -t missing < <(missing_packages "${monado_packages[@]}")
  if [ "${#missing[@]}" -gt 0 ]; then
    refresh_package_lists && apt_install "${missing[@]}" || return 1
  fi
  echo "Building Monado for the headset's tests, once, into $folder ..." >&2
  work=$(mktemp -d)
  chmod 755 "$work"
  mkdir -p "$work/lists/partial"
  # A package list of its own: the system's stays as it is. The package manager checks the source by the signed index.
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror trixie main" >"$work/sources.list"
  options=(-o "Dir::Etc::sourcelist=$work/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$work/lists"
    -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= -o APT::Sandbox::User=root)
  for driver in HDK HYDRA NS PSMV PSSENSE RIFT_S STEAMVR_LIGHTHOUSE TWRAP VIVE WMR ARDUINO DAYDREAM; do
    off+=("-DXRT_BUILD_DRIVER_$driver=OFF")
  done
  result=0
  { as_root apt-get "${options[@]}" update &&
    (cd "$work" && as_root apt-get "${options[@]}" source --tar-only monado) && mkdir "$work/source" &&
    tar -xf "$work"/monado_*.orig.tar.xz -C "$work/source" --strip-components=1 &&
    cmake -S "$work/source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$folder" \
      -DCMAKE_INSTALL_LIBDIR=lib -DGIT_DESC=v25.0.0 -DBUILD_TESTING=OFF -DBUILD_DOC=OFF -DXRT_FEATURE_SERVICE=OFF \
      -DXRT_MODULE_IPC=OFF -DXRT_MODULE_MONADO_CLI=OFF -DXRT_MODULE_MONADO_GUI=OFF -DXRT_BUILD_SAMPLES=OFF \
      -DXRT_FEATURE_STEAMVR_PLUGIN=OFF -DXRT_BUILD_DRIVER_SIMULATED=ON -DXRT_BUILD_DRIVER_REMOTE=ON "${off[@]}" &&
    ninja -C "$work/build" && ninja -C "$work/build" install; } >"$work/log" 2>&1 || result=$?
  if [ "$result" -ne 0 ]; then
    tail -n 30 "$work/log" >&2
    echo "Monado could not be built: the headset's tests will fail." >&2
  fi
  as_root rm -rf "$work"
  return $result
}

# Eight CC0 panoramas of Blender's, from its data package, unpacked into the ignored cache. Flying works without them.
fetch_panoramas() {
  local cache=${RAPIDITY_CACHE_DIR:-$PWD/cache} folder world
  if [ -d "$cache/studiolights/world" ] || ! is_debian; then
    return 0
  fi
  folder=$(mktemp -d)
  chmod 755 "$folder"
  echo "Fetching panoramas (package blender-data) ..." >&2
  if (cd "$folder" && { apt-get download blender-data >/dev/null 2>&1 || { refresh_package_lists && apt-get download blender-data >&2; }; } &&
    dpkg -x blender-data_*.deb unpacked) &&
    world=$(find "$folder/unpacked" -type d -path '*/studiolights/world' | head -n 1) && [ -n "$world" ]; then
    mkdir -p "$cache/studiolights"
    rm -rf "$cache/studiolights/world.part"
    cp -r "$world" "$cache/studiolights/world.part"
    cp "$folder/unpacked/usr/share/doc/blender-data/copyright" "$cache/studiolights/world.part/COPYRIGHT"
    mv "$cache/studiolights/world.part" "$cache/studiolights/world"
  else
    echo "The panoramas could not be fetched; the built-in sky is used in their place." >&2
  fi
  rm -rf "$folder"
}

# install_for flight | install_for tests
install_for() {
  local packages=("${flight_packages[@]}") missing
  if [ "$1" = tests ]; then
    packages+=("${test_packages[@]}")
  fi
  if ! is_debian; then
    [ "$1" != tests ] || packages+=("catch2 (3 or newer)")
    echo "Not a Debian system: what these Debian packages hold is needed: ${packages[*]}" >&2
    return 0
  fi
  mapfile -t missing < <(missing_packages "${packages[@]}")
  if [ "${#missing[@]}" -gt 0 ]; then
    echo "Installing: ${missing[*]}" >&2
    refresh_package_lists && apt_install "${missing[@]}" || return 1
  fi
  if [ "$1" = tests ] && ! have_catch2_3; then
    install_catch2_3 || return 1
  fi
  if [ "$1" = tests ]; then
    install_monado || return 1
  fi
  fetch_panoramas
}
