# What scripts/test, scripts/sanitize and scripts/demo share: sourced by them, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$root/.build

# ROS belongs to the system's Python; another one may come first on PATH.
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH
export LC_ALL=C.UTF-8
# Nodes talk on this machine alone, whatever its name resolves to, and their logs stay in the build folder.
export ROS_HOSTNAME=localhost
export ROS_HOME=$build_dir/ros

# Debian 12's packages, by what needs them. On Noetic package.xml says the same to rosdep.
build_packages=(
  build-essential catkin cmake libdiagnostic-msgs-dev libdiagnostic-updater-dev
  libdynamic-reconfigure-config-init-mutex-dev libeigen3-dev libgeographiclib-dev libgeometry-msgs-dev
  libnav-msgs-dev librosbag-dev libsensor-msgs-dev libstd-srvs-dev libtf2-geometry-msgs-dev libtf2-ros-dev
  libtinyxml2-dev libtopic-tools-dev libvisualization-msgs-dev libyaml-cpp-dev nlohmann-json3-dev
  ros-core-dev ros-message-generation ros-message-runtime
)
run_packages=(
  python3-diagnostic-msgs python3-dynamic-reconfigure python3-geometry-msgs python3-matplotlib
  python3-nav-msgs python3-rosbag python3-roslaunch python3-rospy python3-sensor-msgs python3-std-msgs
  python3-std-srvs python3-tf2-ros python3-visualization-msgs python3-yaml rosout
)
test_packages=(
  catkin-lint chromium clang clang-format clangd git libbenchmark-dev libclang-rt-14-dev libgtest-dev mkdocs mkdocs-material
  python3-nose python3-rostest python3-rosunit rviz universal-ctags
)
view_packages=(rviz)

say() { printf '\n== %s\n' "$*"; }

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi
}

# install_missing PACKAGE...: nothing happens when everything is there.
install_missing() {
  if [ -f /opt/ros/noetic/setup.bash ]; then
    install_by_rosdep
  elif grep -qs '^VERSION_CODENAME=bookworm' /etc/os-release; then
    install_by_apt "$@"
  else
    echo "This system is neither Debian 12 nor Ubuntu 20.04 with ROS Noetic in /opt/ros/noetic." >&2
    return 1
  fi
}

install_by_apt() {
  local package missing=()
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  say "Installing with apt: ${missing[*]}"
  as_root apt-get update -q || echo "apt-get update failed; going on with the package lists there are"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
}

install_by_rosdep() {
  set +u  # ROS's own scripts read variables that are not set
  . /opt/ros/noetic/setup.bash
  set -u
  if command -v rosdep >/dev/null && rosdep check -q --from-paths "$root" --ignore-src >/dev/null 2>&1; then
    return 0
  fi
  say "Installing with rosdep what package.xml names"
  as_root apt-get update -q || echo "apt-get update failed; going on with the package lists there are"
  command -v rosdep >/dev/null || as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q python3-rosdep
  [ -d /etc/ros/rosdep/sources.list.d ] || as_root rosdep init
  rosdep update --rosdistro noetic
  DEBIAN_FRONTEND=noninteractive rosdep install -y --from-paths "$root" --ignore-src
}

# As many compilers at once as there are cores, and 1.5 GB of memory for each.
jobs() {
  local by_memory cores
  by_memory=$(awk '/^MemTotal/ { print int($2 / 1.5e6) }' /proc/meminfo)
  cores=$(nproc)
  echo $((by_memory < 1 ? 1 : by_memory < cores ? by_memory : cores))
}

# build TARGET [CMAKE_OPTION...]: configures and builds in .build and enters the environment that catkin makes.
build() {
  local target=$1
  shift
  say "Building in ${build_dir#"$PWD"/} with $(jobs) jobs"
  mkdir -p "$build_dir"
  cmake -S "$root" -B "$build_dir" -DPYTHON_EXECUTABLE=/usr/bin/python3 -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "$@" \
    >"$build_dir/configure.log" 2>&1 || { cat "$build_dir/configure.log"; return 1; }
  cmake --build "$build_dir" --target "$target" -- --no-print-directory -j"$(jobs)"
  set +u
  . "$build_dir/devel/setup.bash"
  set -u
}

# build_tests_once [CMAKE_OPTION...]: builds everything, tests too; they may lack part of their environment.
build_tests_once() {
  build all -DCATKIN_ENABLE_TESTING=ON -DWARNINGS_AS_ERRORS=ON "$@"
  cmake --build "$build_dir" --target tests -- --no-print-directory -j"$(jobs)"
}

# build_tests [CMAKE_OPTION...]: builds everything, tests too, ready to run.
build_tests() {
  build_tests_once "$@"
  # Configured again: catkin notes for the tests' environment only those folders that exist by then.
  cmake "$build_dir" >>"$build_dir/configure.log" 2>&1
}

# run_tests: runs them all and names each as it ends; what they say goes to tests.log of the build folder.
run_tests() {
  say "Testing"
  cmake --build "$build_dir" --target run_tests -- --no-print-directory 2>&1 | tee "$build_dir/tests.log" |
    sed -nuE 's#.*verify result ".*/(gtest|rostest)-(test_rostest_|test_)?(.*)\.xml".*#  \1 \3#p' || true
}

# record NAME [failed]: one more test case among the results.
record() {
  mkdir -p "$build_dir/test_results/checks"
  printf '<testsuite name="check"><testcase name="%s">%s</testcase></testsuite>\n' \
    "$1" "${2:+<failure message=\"$2\"/>}" >"$build_dir/test_results/checks/$1.xml"
}
