#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# picture.sh ZIP FOLDER: makes FOLDER/blender.png, Blender's window with the add-on's answer. docs/hosts/blender.md shows its
# part from (0, 70) to (1240, 900). Needs no screen, but Debian's blender, xvfb and xdotool.
set -euo pipefail
zip=$(realpath "$1") folder=$(realpath "$2") here=$(dirname "$(realpath "$0")")
rm -f "$folder"/{shown,taken}
export BLENDER_USER_SCRIPTS=$folder/scripts BLENDER_USER_CONFIG=$folder/config LIBGL_ALWAYS_SOFTWARE=1
export here zip folder

in_window() {
  wait_for() { for _ in $(seq 600); do [[ -e $folder/$1 ]] && return; sleep 1; done; echo "picture.sh: no $1" >&2; exit 1; }
  drag() { xdotool mousemove "$1" "$2" mousedown 1 sleep 0.3 mousemove "$1" $((($2 + $3) / 2)) sleep 0.3 mousemove "$1" "$3" sleep 0.3 mouseup 1; }
  blender -p 0 0 1500 900 --python "$here/picture.py" -- "$zip" "$folder" &
  wait_for shown
  sleep 3
  xdotool mousemove 1226 244 click 1 sleep 1  # opens the add-on's tab
  drag 600 814 740                            # makes the timeline higher, so that its markers are seen
  xdotool mousemove 400 600
  wait_for taken
  kill %1
}
export -f in_window
xvfb-run -a -s "-screen 0 1500x900x24 +extension GLX" bash -c in_window
