#!/usr/bin/env bash
# usage: on_display.sh COMMAND...: runs it on an X display of its own, and returns what it returns.
set -uo pipefail
folder=$(mktemp -d)
mkfifo "$folder/display"
# Xvfb picks a free display and says which; -noreset: it stays when a client leaves.
Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp -noreset 3>"$folder/display" 2>/dev/null &
xvfb=$!
trap 'kill $xvfb 2>/dev/null; rm -rf "$folder"' EXIT
read -r -t 60 number <"$folder/display" || { echo "no X display" >&2; exit 1; }
DISPLAY=:$number "$@"
