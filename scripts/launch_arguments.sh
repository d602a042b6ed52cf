# Sourced by scripts/run: refuses arguments that launch/system.launch does not have, and values that do not exist.

# expand_home WORD...: sets `words` to these words with the home folder where a value begins with ~/, which bash expands only where
# a word begins with it.
expand_home() {
  local word
  words=()
  for word in "$@"; do
    case $word in [a-z]*:='~/'*) word=${word%%:=*}:=$HOME/${word#*:='~/'} ;; esac
    words+=("$word")
  done
}

# check_launch_arguments ROOT OWN WORD...: each word has to be NAME:=VALUE, where NAME is an argument of
# launch/system.launch or OWN. The first wrong one is named, with what there is instead, and ends the script.
check_launch_arguments() {
  local root=$1 own=$2 known word map= world
  world=$(sed -n 's/^  <arg name="world" default="\([^"]*\)".*/\1/p' "$root/launch/system.launch")
  world=${world/'$(find frontier_pilot)'/$root}
  shift 2
  known="$own $(sed -n 's/^  <arg name="\([a-z_]*\)" default=.*/\1/p' "$root/launch/system.launch" | tr '\n' ' ')"
  for word in "$@"; do
    case $word in
      [a-z]*:=*) ;;
      *) wrong_argument "$word" ;;
    esac
    case $word in
      map:= | map:=/*) map=${word#map:=} ;;
      map:=*) map=$PWD/${word#map:=} ;;
      world:=*) world=${word#world:=} ;;
    esac
    case " $known" in
      *" ${word%%:=*} "*) check_value "$root" "${word%%:=*}" "${word#*:=}" ;;
      *) wrong_argument "$word" "there is no argument '${word%%:=*}', only: ${known% }" ;;
    esac
  done
  [ -n "$map" ] || { can_make_files_in "$PWD/maps" && map=$PWD/maps; } ||
    wrong_argument maps "map: nothing can be written to the folder ${PWD@Q}/maps, where the map would be saved; give another path with map:=PATH"
  iconv -f UTF-8 -t UTF-8 <<<"$map" >/dev/null 2>&1 ||
    wrong_argument "$map" "map: no map can be saved as ${map@Q}, because that is not UTF-8; give another path with map:=PATH"
  ! replaces_world "$map" "$(world_file "$root" "$world")" ||
    wrong_argument "$map" "map: '$map' is the world, which the map would replace; give another path with map:=PATH"
  [[ " $* " != *' localize_only:=true '* ]] || [[ " $* " =~ ' map_file:='[^\ ] && " $* " != *' map_file:=none '* ]] ||
    wrong_argument localize_only:=true "localize_only: needs a saved map, map_file:=PATH"
}

# world_file ROOT WORLD: the world's YAML; a bare word is the name of a world of ours.
world_file() {
  case $2 in
    */* | *.* | '') echo "$2" ;;
    *) echo "$1/config/worlds/$2.yaml" ;;
  esac
}

# replaces_world MAP WORLD: whether a file of the map that is saved as MAP is the world's YAML or its picture.
replaces_world() {
  local map=$1 world=$2 picture ending
  case $map in *.pgm | *.yaml | *.bt) map=${map%.*} ;; esac  # which the mapper leaves out
  picture=$(sed -n "s/\r$//; s/ #.*//; s/^image: *[\"']\{0,1\}\([^\"']*[^\"' ]\).*/\1/p" "$world" | head -n 1)
  case $picture in /*) ;; *) picture=$(dirname -- "$world")/$picture ;; esac
  for ending in pgm yaml bt; do
    [[ $map.$ending -ef $world || $map.$ending -ef $picture ]] && return
  done
  return 1
}

# can_make_files_in FOLDER: whether files can be made in it, or it can be made.
can_make_files_in() {
  if [ -e "$1" ] || [ -L "$1" ]; then [ -d "$1" ] && [ -w "$1" ] && [ -x "$1" ]; else [ -w "${1%/*}/" ]; fi
}

# names_in FOLDER: the YAML files in it, without the ending.
names_in() { find "$1" -maxdepth 1 -name '*.yaml' -printf '%f\n' | sed 's/\.yaml$//' | sort | paste -s -d ' '; }

check_value() {
  local root=$1 name=$2 value=$3
  [[ $value != *:=* ]] || wrong_argument "$value" "$name: a value must not contain ':=', with which ROS writes arguments"
  [ "$name" = map ] || [[ $value != *'$('* ]] || wrong_argument "$value" "$name: a value must not contain '\$(', with which a substitution of roslaunch begins"
  case $name in
    world)
      [ -f "$(world_file "$root" "$value")" ] ||
        wrong_argument "$value" "world: there is no file '$value'; in $root/config/worlds are $(names_in "$root/config/worlds")" ;;
    robot)
      # Like the launch files: a word alone is a name, whatever file there is.
      [ -f "$root/config/robots/$value.yaml" ] || { [[ $value == */* || $value == *.yaml ]] && [ -f "$value" ]; } ||
        wrong_argument "$value" \
          "robot: there is neither a robot nor a file '$value'; robots are $(names_in "$root/config/robots")" ;;
    map)
      [[ $value == /* || $PWD != *:=* ]] ||
        wrong_argument "$value" "map: the path of this folder contains ':='; give the whole path of another one"
      case ${value##*/} in *[[:cntrl:]]*) wrong_argument "$value" "map: a name cannot have a control character" ;; esac
      [ "$(printf %s.yaml "${value##*/}" | wc -c)" -le 255 ] ||
        wrong_argument "$value" "map: the name '${value##*/}' is too long for a file"
      [ ! -d "$value" ] && [[ $value != */ ]] || wrong_argument "$value" "map: '$value' is a folder; give the path of the map's files, such as ${value%/}/floor"
      [ -d "$(dirname -- "$value")" ] ||
        wrong_argument "$value" "map: there is no folder '$(dirname -- "$value")'; make it first, or give another path"
      [ -w "$(dirname -- "$value")" ] ||
        wrong_argument "$value" "map: nothing can be written to the folder of '$value'" ;;
    map_file)
      [ -z "$value" ] || [ "$value" = none ] || [ -f "$value" ] || [ -f "$value.yaml" ] || [ -f "$value.bt" ] ||
        wrong_argument "$value" \
          "map_file: there is no saved map '$value', neither a YAML file nor the path of one without extension" ;;
    limits)
      [ -z "$value" ] || [ "$value" = auto ] || [ -f "$root/config/limits_$value.yaml" ] ||
        wrong_argument "$value" "limits: must be burger (0.22 m/s) or fast (0.5 m/s), not '$value'" ;;
    speed)
      [[ $value =~ ^([0-9]{1,9}(\.[0-9]{0,20})?|\.[0-9]{1,20})$ ]] ||
        wrong_argument "$value" "speed: must be a number of at most nine digits, 1 for real time, 2 to 5 for faster, not '$value'"
      [[ $value == *[1-9]* ]] || wrong_argument "$value" "speed: 0, as fast as possible, is for the simulator alone; the other nodes cannot keep up with it" ;;
    x | y | yaw)
      [[ $value =~ ^(auto|[+-]?([0-9]{1,9}(\.[0-9]{0,20})?|\.[0-9]{1,20}))?$ ]] ||
        wrong_argument "$value" "$name: must be a number of at most nine digits, not '$value'" ;;
    seed)
      [[ $value =~ ^[0-9]{0,10}$ ]] && [ "$((10#${value:-0}))" -le 1000000000 ] ||
        wrong_argument "$value" "seed: must be a whole number from 0 to 1000000000, not '$value'" ;;
    gui | rviz | explore | odom_noise | localize_only | avoider | record)
      [[ $value =~ ^(true|false)$ ]] || wrong_argument "$value" "$name: must be true or false, not '$value'" ;;
  esac
}
