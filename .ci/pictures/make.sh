#!/bin/sh
# The pictures of the README and the manual: a session at the prompt, and DrRacket.
#
#     make pictures
#
# DrRacket is the real one, on a display that Xvfb makes up, with this checkout installed in a
# home that is thrown away.  It takes a minute.

set -eu
cd "$(dirname "$0")/../.."

for program in drracket Xvfb xdotool convert import; do
    command -v "$program" >/dev/null 2>&1 || {
        echo "make pictures needs the program $program" \
             "(Debian: apt install drracket xvfb xdotool imagemagick)" >&2
        exit 1
    }
done

target=scribblings/mechanics/screenshots
home=$(mktemp -d)
server= drracket=
stop() {
    [ -z "$drracket" ] || kill "$drracket" 2>/dev/null || :
    [ -z "$server" ] || kill "$server" 2>/dev/null || :
    rm -rf "$home"
}
trap stop EXIT

# small PICTURE: of few colors, as a screen is
small() { convert "$1" -strip +dither -colors 96 -define png:compression-level=9 "PNG8:$2"; }

# -- The prompt

"$RACKET" .ci/pictures/terminal.rkt .ci/pictures/terminal.txt "$home/terminal.png"
small "$home/terminal.png" "$target/terminal.png"

# -- DrRacket

export HOME="$home" PLTUSERHOME="$home"
unset PLTCOLLECTS
"$RACKET" -N raco -l- raco pkg install --link --no-setup --scope user --name mechanics "$PWD" \
    >"$home/log" 2>&1 || { cat "$home/log" >&2; exit 1; }
cp .ci/pictures/DrRacket.rkt "$home/motion.rkt"

mkfifo "$home/display"
Xvfb -displayfd 3 -screen 0 1000x900x24 -nolisten tcp 3>"$home/display" 2>/dev/null &
server=$!
read -r number <"$home/display"
export DISPLAY=":$number"

drracket "$home/motion.rkt" >"$home/log" 2>&1 &
drracket=$!

# shows PIXELS SECONDS: wait until the lower half of the window shows that many dark or colored
# pixels, at most so long.
shows() {
    seconds=$2
    while [ "$seconds" -gt 0 ]; do
        ink=$(import -window root -crop 700x330+0+400 +repage png:- |
                  convert - -colorspace Gray -threshold 60% -negate -format '%[fx:mean*w*h]' info:)
        [ "${ink%%.*}" -lt "$1" ] || break
        sleep 1
        seconds=$((seconds - 1))
    done
    sleep 3
}

window=
while [ -z "$window" ]; do
    sleep 1
    window=$(xdotool search --onlyvisible --name 'motion.rkt.*DrRacket' 2>/dev/null | tail -n 1) || :
done
xdotool windowsize "$window" 720 780
sleep 5
xdotool mousemove 300 300 click 1 key F5
shows 4000 90
import -window root -crop 720x780+0+0 +repage "$home/DrRacket.png"
small "$home/DrRacket.png" "$target/DrRacket.png"

ls -l "$target"/*.png
