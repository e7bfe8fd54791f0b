#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the benchmarks of this pack on the GPU of a machine that has neither compiler nor Python:
#
#   all.sh SECONDS OUT
#
# starts the next parts that fit into SECONDS, each a process of its own, and writes their tables and records to OUT. Start it again, with
# the same OUT, until it says that all are done: it goes on where it was. A part that failed is tried once in each start.
#
# RUN (default: run.sh beside this) is called as RUN bench.pck SIZE [OPTIONS] -- ARGUMENTS, with RENDERING_METHOD and TIMEOUT in its
# environment, and runs the pack in an export template of the engine. ONLY="draw rest": only these. QUICK=yes: as small as in software.
set -u
left=${1:?usage: all.sh SECONDS OUT}
out=${2:?usage: all.sh SECONDS OUT}
pack=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$out" && out=$(cd "$out" && pwd) || exit 2
run=${RUN:-$pack/run.sh}
end=$(($(date +%s) + left))
commit=$(cat "$pack/commit")
homes=${TMPDIR:-/tmp}/grass_bench # the engine's and the driver's caches
if [ -e "$out/commit" ] && [ "$(cat "$out/commit")" != "$commit" ]; then
	echo "all.sh: $out holds results of $(cat "$out/commit"), this pack is of $commit: name another folder." >&2
	exit 2
fi
echo "$commit" >"$out/commit"

# play NAME SCENE METHOD SIZE TAKES OUT OPTIONS...
play() {
	name=$1 scene=$2 method=$3 size=$4 takes=$5 to=$6
	shift 6
	set -- "$@" -- --only "$scene" --as "$name" --commit "$commit" --out "$to" ${QUICK:+--quick "$QUICK"}
	case $takes in *spirv*) set -- "$@" --spirv "$pack" ;; esac
	case $takes in *packs*) set -- "$@" --packs "$pack/packs" ;; esac
	limit=$((end - $(date +%s)))
	[ $limit -gt 0 ] || return # for timeout, 0 would be no limit
	[ -n "${QUICK:-}" ] || [ $limit -lt $((60 + 3 * seconds)) ] || limit=$((60 + 3 * seconds)) # a part that hangs leaves time to the others
	mkdir -p "$home/cache"
	HOME=$home XDG_DATA_HOME=$home/data XDG_CACHE_HOME=$home/cache __GL_SHADER_DISK_CACHE_PATH=$home/cache \
		RENDERING_METHOD=$method TIMEOUT=$limit "$run" "$pack/bench.pck" "$size" "$@" >"$to/$name.log" 2>&1 </dev/null
}

todo=
while read -r name scene seconds method size cache takes options <&3; do
	case " ${ONLY:-$name} " in *" $name "*) ;; *) continue ;; esac
	[ ! -e "$out/$name.json" ] || continue
	now=$(date +%s)
	if [ $((now + seconds + seconds / 4)) -gt $end ]; then
		todo="$todo $name"
		continue
	fi
	home=$homes/shared
	[ "$cache" = shared ] || home=$homes/own
	[ "$cache" != empty ] || rm -rf "$home"
	[ -z "${QUICK:-}" ] || size=640x360
	mkdir -p "$homes/first"
	if [ "$cache" = filled ] && [ ! -d "$home" ]; then
		play "$name" "$scene" "$method" "$size" "$takes" "$homes/first" $options
	fi
	play "$name" "$scene" "$method" "$size" "$takes" "$out" $options
	took=$(($(date +%s) - now))
	if [ -e "$out/$name.json" ]; then
		echo "$name: $took s"
	else
		echo "$name: FAILED after $took s; $out/$name.log ends with"
		tail -3 "$out/$name.log"
		todo="$todo $name"
	fi
	[ -n "${QUICK:-}" ] || sleep 1 # until the screen of the one is gone that the next would start
done 3<"$pack/parts"
[ -z "$todo" ] && echo "all parts are done" || echo "not done yet:$todo"
[ -z "$todo" ]
