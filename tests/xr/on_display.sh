#!/usr/bin/env bash
# usage: on_display.sh COMMAND...: runs it on an X display of its own, and returns what it returns.
set -uo pipefail
source "$(dirname "$0")/../x_display.sh"
start_display 1024x768
"$@"
