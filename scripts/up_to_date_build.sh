# Sourced by scripts/run: the build of the nodes.

# check_build BUILD: ends the script if nothing can be built in the folder BUILD, because it cannot be written.
check_build() {
  local build=$1 log=$1/build.log
  local problem="nothing can be written to $log, in the folder of the build; 'export FRONTIER_PILOT_BUILD=FOLDER' takes another folder"
  if ! mkdir -p -- "$build" 2>/dev/null || ! { : >>"$build/.lock"; } 2>/dev/null; then cannot_begin "$problem"; fi
  if [ -e "$log" ] && { [ ! -f "$log" ] || [ ! -w "$log" ]; }; then cannot_begin "$problem"; fi
}

# bring_up_to_date ROOT BUILD: builds the nodes of the sources in ROOT in the folder BUILD, after any other scripts/run that builds
# there. What the compiler prints goes to build.log in it, which is removed unless the build fails. Ends the script if it does.
bring_up_to_date() {
  local root=$1 build=$2 log=$2/build.log
  (
    flock -n 9 || { say "Waiting for another scripts/run that builds in $build ..."; flock 9; }
    if [ -e "$build/CMakeCache.txt" ]; then
      say "Bringing the build in $build up to date (tail -f $log shows how far it is) ..."
    else
      say "Building in $build (the first time some ten minutes; tail -f $log shows how far it is) ..."
    fi
    build_nodes "$root" "$build" 9>&- >"$log" 2>&1 && rm -f "$log"
  ) 9>>"$build/.lock" || {
    tail -n 40 "$log" >&2
    cannot_begin "the build failed; all of its output is in $log; if it was interrupted, remove $build and try again"
  }
}

# build_nodes ROOT BUILD: a build that is configured configures itself again when that is needed.
build_nodes() {
  local root=$1 build=$2
  if ! [ -e "$build/CMakeCache.txt" ] || ! { [ -e "$build/build.ninja" ] || [ -e "$build/Makefile" ]; }; then
    cmake -S "$root" -B "$build" -DPYTHON_EXECUTABLE=/usr/bin/python3 || return
  fi
  cmake --build "$build" --target frontier_pilot_nodes -j "$(nproc)"
}
