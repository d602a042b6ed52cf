# Sourced by scripts/run: the environment variables and limits with which ROS' tools work, and a line for those with which they cannot.

# prepare_environment FOLDER: makes the paths absolute that were given relative to FOLDER, because roslaunch starts the nodes in
# another folder, and removes what ROS' tools cannot work with.
prepare_environment() {
  local name
  for name in ROS_HOME ROS_LOG_DIR ROS_MASTER_URI; do [ -n "${!name:-}" ] || unset "$name"; done
  case ${ROS_HOME:-/} in /*) ;; *) export ROS_HOME=$1/$ROS_HOME ;; esac
  case ${ROS_LOG_DIR:-/} in /*) ;; *) export ROS_LOG_DIR=$1/$ROS_LOG_DIR ;; esac
  unset PYTHONWARNINGS PYTHONINSPECT PYTHONVERBOSE PYTHONIOENCODING  # ROS' tools warn, they have to end, and what they print is read
}

# check_surroundings: the first thing with which nothing can be launched is named, with what would help, and ends the script.
check_surroundings() {
  local needed_files=256  # of the ROS master, which has connections to every node
  local open_files ros_home=${ROS_HOME:-~/.ros} master=${ROS_MASTER_URI:-http://localhost:11311}
  open_files=$(ulimit -n)
  [ "$open_files" = unlimited ] || [ "$open_files" -ge "$needed_files" ] ||
    cannot_begin "only $open_files files may be open at once, too few for the ROS master; 'ulimit -n 1024' allows more"
  mkdir -p "$ros_home" 2>/dev/null && [ -w "$ros_home" ] ||
    cannot_begin "ROS cannot write its logs to $ros_home; 'export ROS_HOME=FOLDER' takes another folder"
  [[ $master =~ ^http://[^/]+:([0-9]{1,5})/?$ ]] && [ "$((10#${BASH_REMATCH[1]}))" -ge 1 ] && [ "$((10#${BASH_REMATCH[1]}))" -le 65535 ] ||
    cannot_begin "ROS_MASTER_URI is ${master@Q}, which is not the address of a ROS master, such as http://localhost:11311"
  [ -d "${TMPDIR:-/tmp}" ] && [ -w "${TMPDIR:-/tmp}" ] ||
    cannot_begin "temporary files cannot be made in ${TMPDIR:-/tmp}; 'export TMPDIR=FOLDER' takes another folder"
}

# check_master ROOT: a robot or a simulation that runs at the ROS master is named, and ends the script. ROOT holds the sources.
check_master() {
  local problem
  problem=$("$1/scripts/running_system.py") || cannot_begin "${problem:-running_system.py failed, see above}"
}

# claim_master: from now on, and as long as a process that this script starts lives, another scripts/run of this user at the same ROS
# master is refused: its nodes would take the names of these, and what it watches would be these. `claim` is the file that says so.
claim_master() {
  local master=${ROS_MASTER_URI:-http://localhost:11311} held name
  name=${master%/}
  name=${name/localhost/127.0.0.1}
  claim=/tmp/frontier_pilot_run.$(id -u).${name//[^[:alnum:]]/_}.lock
  { exec {held}>>"$claim"; } 2>/dev/null || return 0
  flock -n "$held" ||
    cannot_begin "another scripts/run at the ROS master $master is about to begin or to end: end it first, or choose another port for this run: export ROS_MASTER_URI=http://127.0.0.1:PORT"
}

# cannot_begin WHY: ends the script with this line.
cannot_begin() {
  echo "scripts/run: $1" >&2
  exit 1
}
