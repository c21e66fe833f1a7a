#!/usr/bin/env bash
# usage: fly_cockpit.sh PROGRAM SCENARIO FOLDER BUTTON_X BUTTON_Y
# Flies windows of 640x360 on a display of their own. First in the cockpit: a picture before and one after a click at
# BUTTON on a screen of the panel, left as c-1.png and c-2.png beside the recording c.rapidity. Then a demonstration
# that is touched, left alone until it has returned to its start, and asked in vain to show its menus and to quit; its
# recordings lie in FOLDER/flights. What the program printed: cockpit.txt, demo.txt.
set -euo pipefail
program=$1 scenario=$2 folder=$3 x=$4 y=$5
source "$(dirname "$0")/../x_display.sh"
start_display 800x600

"$program" fly "$scenario" --cockpit --snap-turn 45 --size 640x360 --record "$folder/c.rapidity" --seconds 60 \
  >"$folder/cockpit.txt" 2>&1 &
flight=$!
focus_window "$folder/cockpit.txt"
screenshot "$folder/c-1.png"
xdotool mousemove --window "$window" "$x" "$y"
sleep 1
xdotool mousedown 1; sleep 0.6; xdotool mouseup 1; sleep 0.6
xdotool key Control_L; sleep 0.5
xdotool keydown Left; sleep 0.6; xdotool keyup Left; sleep 0.4
screenshot "$folder/c-2.png"
xdotool key Escape
wait $flight

RAPIDITY_FLIGHTS_DIR="$folder/flights" "$program" fly "$scenario" --demo --demo-idle 2 --size 640x360 --seconds 14 \
  >"$folder/demo.txt" 2>&1 &
flight=$!
focus_window "$folder/demo.txt"
xdotool keydown w; sleep 1.5; xdotool keyup w
xdotool key Tab; sleep 0.2; xdotool key Escape; sleep 0.2; xdotool key F12
wait $flight
