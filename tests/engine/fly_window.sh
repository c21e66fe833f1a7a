#!/usr/bin/env bash
# usage: fly_window.sh PROGRAM SCENARIO FOLDER
# Flies a window on a display of its own by scripted keys: thrust, turn, every view of the picture, help, settings,
# screenshots, quit. Leaves in FOLDER the recording f.rapidity, the screenshots f-1.png (luminance in four panes with
# lines, glare and probe) and f-2.png (light again), and what the program printed, output.txt.
set -euo pipefail
program=$1 scenario=$2 folder=$3
source "$(dirname "$0")/../x_display.sh"
start_display 800x600

"$program" fly "$scenario" --size 640x360 --record "$folder/f.rapidity" --seconds 60 >"$folder/output.txt" 2>&1 &
flight=$!
focus_window "$folder/output.txt"
# Held for seconds of wall time: even a slow frame falls in it.
xdotool keydown w; sleep 2
xdotool keydown Left; sleep 2
xdotool keyup w keyup Left
press() {
  for key in "$@"; do xdotool key "$key"; sleep 0.4; done
}
# No key twice in a row: presses within one slow frame count once.
press F1 F2 Tab F4 F1 F2 Tab F4 F3 F2 F9 F10
screenshot "$folder/f-1.png"
press F10 F9 F4 F3 F2
screenshot "$folder/f-2.png"
xdotool key Escape
wait $flight
