#!/bin/sh
# SPDX-License-Identifier: MIT
# Records the pictures of the docs on the GPU of a machine that has neither compiler nor Python:
#
#   pictures.sh OUT [SECONDS]
#
# writes each recording to OUT/NAME, and begins none after SECONDS (default: a day). Start it again, with the same OUT, until it says that
# all are done: it goes on where it was.
#
# RUN (default: run.sh beside this) is called as RUN demo.pck SIZE [OPTIONS] -- ARGUMENTS, with TIMEOUT in its environment, and runs the
# pack in an export template of the engine. ONLY="forces film": only these.
set -u
mkdir -p "${1:?usage: pictures.sh OUT [SECONDS]}" && out=$(cd "$1" && pwd) || exit 2
end=$(($(date +%s) + ${2:-86400}))
pack=$(cd "$(dirname "$0")" && pwd)
run=${RUN:-$pack/run.sh}

todo=
while read -r name size folder options <&3; do
	case " ${ONLY:-$name} " in *" $name "*) ;; *) continue ;; esac
	[ ! -e "$out/$name.done" ] || continue
	left=$((end - $(date +%s)))
	if [ $left -le 0 ]; then
		todo="$todo $name"
		continue
	fi
	mkdir -p "$out/$folder"
	began=$(date +%s)
	if TIMEOUT=$left "$run" "$pack/demo.pck" "$size" $options -- --place "$name" --out "$out/$folder" >"$out/$name.log" 2>&1 </dev/null &&
		[ -n "$(ls "$out/$folder")" ]; then
		: >"$out/$name.done"
		echo "$name: $(($(date +%s) - began)) s"
	else
		echo "$name: FAILED after $(($(date +%s) - began)) s; $out/$name.log ends with"
		tail -3 "$out/$name.log"
		todo="$todo $name"
	fi
	sleep 1 # until the screen of the one is gone that the next would start
done 3<"$pack/recordings"
[ -z "$todo" ] && echo "all recordings are done" || echo "not done yet:$todo"
[ -z "$todo" ]
