#!/usr/bin/env bash
# usage: fly_cockpit.sh PROGRAM SCENARIO FOLDER BUTTON_X BUTTON_Y
# Flies windows of 640x360 on a display of their own. First in the cockpit: a picture before and one after a click at
# BUTTON on a screen of the panel, left as c-1.png and c-2.png beside the recording c.rapidity. Then a demonstration
# that is touched, left alone until it has returned to its start, and asked in vain to show its menus and to quit; its
# recordings lie in FOLDER/flights. What the program printed: cockpit.txt, demo.txt.
set -euo pipefail
program=$1 scenario=$2 folder=$3 x=$4 y=$5

# As fly_window.sh does: Xvfb picks a free display and says which.
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp -noreset 3>"$folder/display" 2>/dev/null &
xvfb=$!
trap 'kill $xvfb 2>/dev/null || true' EXIT
read -r -t 60 number <"$folder/display"
export DISPLAY=:$number

wait_for_window() {
  for _ in $(seq 300); do
    window=$(xdotool search --name '^Rapidity' 2>/dev/null | head -n 1) && [ -n "$window" ] && return
    kill -0 $flight 2>/dev/null || break
    sleep 0.2
  done
  echo "no window appeared" >&2
  exit 1
}
wait_for_file() {
  for _ in $(seq 100); do
    [ -e "$1" ] && return
    kill -0 $flight 2>/dev/null || break
    sleep 0.2
  done
  echo "no $1" >&2
  kill $flight 2>/dev/null || true
  exit 1
}

"$program" fly "$scenario" --cockpit --snap-turn 45 --size 640x360 --record "$folder/c.rapidity" --seconds 60 \
  >"$folder/cockpit.txt" 2>&1 &
flight=$!
wait_for_window
xdotool windowfocus --sync "$window" 2>/dev/null || true
xdotool key F12
wait_for_file "$folder/c-1.png"
xdotool mousemove --window "$window" "$x" "$y"
sleep 1
xdotool mousedown 1; sleep 0.6; xdotool mouseup 1; sleep 0.6
xdotool key Control_L; sleep 0.5
xdotool keydown Left; sleep 0.6; xdotool keyup Left; sleep 0.4
xdotool key F12
wait_for_file "$folder/c-2.png"
xdotool key Escape
wait $flight

RAPIDITY_FLIGHTS_DIR="$folder/flights" "$program" fly "$scenario" --demo --demo-idle 2 --size 640x360 --seconds 14 \
  >"$folder/demo.txt" 2>&1 &
flight=$!
wait_for_window
xdotool windowfocus --sync "$window" 2>/dev/null || true
xdotool keydown w; sleep 1.5; xdotool keyup w
xdotool key Tab; sleep 0.2; xdotool key Escape; sleep 0.2; xdotool key F12
wait $flight
