#!/usr/bin/env bash
# usage: fly_window.sh PROGRAM SCENARIO FOLDER
# Flies a window on a display of its own by scripted keys: thrust, turn, every view of the picture, help, settings,
# screenshots, quit. Leaves in FOLDER the recording f.rapidity, the screenshots f-1.png (luminance in four panes with
# lines, glare and probe) and f-2.png (light again), and what the program printed, output.txt.
set -euo pipefail
program=$1 scenario=$2 folder=$3

# Xvfb picks a free display and says which. -noreset: else it starts afresh whenever its last client leaves, and refuses
# the flight that happens to come just after xdotool went.
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp -noreset 3>"$folder/display" 2>/dev/null &
xvfb=$!
trap 'kill $xvfb 2>/dev/null || true' EXIT
read -r -t 60 number <"$folder/display"
export DISPLAY=:$number

"$program" fly "$scenario" --size 640x360 --record "$folder/f.rapidity" --seconds 60 >"$folder/output.txt" 2>&1 &
flight=$!
for _ in $(seq 300); do
  window=$(xdotool search --name '^Rapidity' 2>/dev/null | head -n 1) && [ -n "$window" ] && break
  kill -0 $flight 2>/dev/null || { cat "$folder/output.txt" >&2; exit 1; }
  sleep 0.2
done
[ -n "$window" ] || { echo "no window appeared" >&2; exit 1; }
xdotool windowfocus --sync "$window" 2>/dev/null || true
# Held for seconds of wall time: even a slow frame falls in it.
xdotool keydown w; sleep 2
xdotool keydown Left; sleep 2
xdotool keyup w keyup Left
# A screenshot says that the keys before it were heard; a key that a panel swallows leaves none.
screenshot() {
  xdotool key F12
  for _ in $(seq 100); do
    [ -e "$folder/f-$1.png" ] && return
    kill -0 $flight 2>/dev/null || break
    sleep 0.2
  done
  echo "no screenshot $1" >&2
  kill $flight 2>/dev/null || true
  exit 1
}
press() {
  for key in "$@"; do xdotool key "$key"; sleep 0.4; done
}
# No key twice in a row: presses within one slow frame count once.
press F1 F2 Tab F4 F1 F2 Tab F4 F3 F2 F9 F10
screenshot 1
press F10 F9 F4 F3 F2
screenshot 2
xdotool key Escape
wait $flight
