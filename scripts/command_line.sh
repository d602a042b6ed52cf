# Sourced by the scripts: what their command lines have in common.

# The caller may have exported options of the shell (SHELLOPTS) with which no pattern matches a file and none is written
# anew, aliases (by BASH_ENV) for the commands that are used here, a limit to functions that call each other, or folders
# (CDPATH) in which cd looks as well, and then prints where it went.
set +f +C
unalias -a
unset FUNCNEST CDPATH

# A standard stream that was closed (>&-) would make each line an error, and its number would be given to the next file.
[ -e /proc/$$/fd/0 ] || exec 0</dev/null
[ -e /proc/$$/fd/1 ] || exec 1>/dev/null
[ -e /proc/$$/fd/2 ] || exec 2>/dev/null

# With --help or -h among the words, prints the comment at the head of the script, and ends.
help_if_asked() {
  local word
  for word in "$@"; do
    case $word in -h | --help) print_help; exit ;; esac
  done
}

print_help() {
  local text
  text=$(sed -n '2,/^[^#]/{s/^# \{0,1\}//p}' "$0" | grep -v '^set ')
  echo "$text" 2>/dev/null || { echo "scripts/${0##*/}: cannot write its output" >&2; return 1; }
}

# wrong_argument WORD [WHY]: one line on stderr, and exit code 2.
wrong_argument() {
  local name=scripts/${0##*/}
  echo "$name: ${2:-unknown argument '$1'}; '$name --help' lists what it takes" >&2
  exit 2
}
