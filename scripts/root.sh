# What scripts/debian11 and scripts/arm64 share: sourced by them, not run. A Debian of its own in a folder, made from the
# archive that apt takes packages from here.

# The URI of Debian's archive, as apt is configured.
archive() {
  apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
    awk -v release="$(. /etc/os-release && echo "$VERSION_CODENAME")" '
      $1 == release && $2 == "main" { print $3; found = 1; exit }
      END { if (!found) print "apt has no archive of Debian " release > "/dev/stderr"; exit !found }'
}

# make_root FOLDER SUITE [PACKAGE...]: the system in FOLDER, with these packages. What is there already is not made again.
make_root() {
  local folder=$1 suite=$2
  shift 2
  if [ ! -d "$folder" ]; then
    local from
    from=$(archive) || return 1
    install_missing debootstrap
    say "Making a system of Debian's $suite in $folder"
    as_root rm -rf "$folder.part"
    as_root unshare --mount debootstrap --variant=minbase "$suite" "$folder.part" "$from"
    # Lost with the machine's power, and made again: there is no need to wait for the disk.
    echo force-unsafe-io | as_root tee "$folder.part/etc/dpkg/dpkg.cfg.d/unsafe" >/dev/null
    # Nodes find each other by a name that debootstrap does not write down.
    echo "127.0.0.1 localhost" | as_root tee "$folder.part/etc/hosts" >/dev/null
    as_root mkdir -p "$folder.part/src" "$folder.part/build"
    as_root mv "$folder.part" "$folder"
  fi
  say "Installing what is missing there"
  in_root "$folder" apt-get install -y -q --no-install-recommends "$@"
}

# in_root FOLDER COMMAND...: runs it as root of that system, with this repository at /src to be read. What it needs mounted
# is so for it alone and gone with it, and so are processes that it leaves.
in_root() {
  as_root nice unshare --mount --pid --fork --kill-child bash -c '
    set -e
    folder=$0 repository=$1
    shift
    mount -t proc proc "$folder/proc"
    mount --rbind /dev "$folder/dev"
    mount --bind "$repository" "$folder/src"
    mount -o remount,bind,ro "$folder/src"
    exec chroot "$folder" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root \
      DEBIAN_FRONTEND=noninteractive PYTHONDONTWRITEBYTECODE=1 "$@"' "$1" "$root" "${@:2}"
}

# unpack_packages FOLDER SUITE PACKAGE...: what these packages of a release hold, without what they depend on.
unpack_packages() {
  local folder=$1 suite=$2 package apt from
  shift 2
  from=$(archive) || return 1
  mkdir -p "$folder"/apt/{lists,cache}
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $from $suite main" >"$folder/apt/sources.list"
  apt=(apt-get -q -o Dir::State="$folder/apt" -o Dir::State::lists=lists -o Dir::Cache="$folder/apt/cache"
    -o Dir::Etc::SourceList="$folder/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::Etc::PreferencesParts=/dev/null
    -o APT::Sandbox::User=root -o Acquire::Languages=none)
  "${apt[@]}" update
  (cd "$folder/apt" && "${apt[@]}" download "$@")
  for package in "$folder"/apt/*.deb; do dpkg-deb -x "$package" "$folder"; done
  rm -rf "$folder/apt"
}
