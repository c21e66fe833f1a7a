# Sourced by scripts that need an X display of their own, for windows and scripted keys.

# usage: start_display WIDTHxHEIGHT. Exports DISPLAY; the display goes when the script ends.
start_display() {
  local folder number
  folder=$(mktemp -d)
  mkfifo "$folder/number"
  # Xvfb picks a free display and says which. -noreset: else it starts afresh whenever its last client leaves, and
  # refuses the program that happens to come just after.
  Xvfb -displayfd 3 -screen 0 "$1x24" -nolisten tcp -noreset 3>"$folder/number" 2>/dev/null &
  xvfb=$!
  trap 'kill $xvfb 2>/dev/null || true' EXIT
  read -r -t 60 number <"$folder/number" || { echo "no X display" >&2; exit 1; }
  rm -r "$folder"
  export DISPLAY=:$number
}

# The rest is for the process that `flight` names.

# usage: wait_while_flying TRIES COMMAND...: until COMMAND succeeds, looking five times a second.
wait_while_flying() {
  local tries=$1
  shift
  for _ in $(seq "$tries"); do
    "$@" && return
    kill -0 "$flight" 2>/dev/null || break
    sleep 0.2
  done
  return 1
}

find_window() {
  window=$(xdotool search --name '^Rapidity' 2>/dev/null | head -n 1) && [ -n "$window" ]
}

# usage: focus_window OUTPUT: waits for the flight's window and gives it the keyboard. Names it `window`; without one,
# shows what the flight printed into OUTPUT.
focus_window() {
  wait_while_flying 300 find_window || { echo "no window appeared" >&2; cat "$1" >&2; exit 1; }
  xdotool windowfocus --sync "$window" 2>/dev/null || true
}

# usage: screenshot FILE: asks for one, which will be FILE. It says that the keys before it were heard; a key that a
# panel swallows leaves none.
screenshot() {
  xdotool key F12
  wait_while_flying 100 test -e "$1" && return
  echo "no $1" >&2
  kill "$flight" 2>/dev/null || true
  exit 1
}
