#!/usr/bin/env bash
# Small pictures by the scalar renderers, and tests of what reads files, under valgrind: nothing may
# be read before it was written. $CLI and $TESTS are the programs. Ends at the first error.
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

checked() {  # NAME COMMAND...: what was found, if anything
    echo "  VALGRIND $1"
    if ! valgrind --quiet --error-exitcode=99 "${@:2}" >"$folder/log" 2>&1; then
        cat "$folder/log"
        exit 1
    fi
}

draw() {
    checked "$*" "$CLI" render "$@" -o "$folder/out.png" --threads 1 --resolution 48,36 --samples 4
}

for renderer in scalar-f32 scalar-f64; do
    for scene in models/scenes/*.toml; do
        draw "$scene" --renderer "$renderer"
    done
    for shading in flat gouraud phong; do
        for interpolation in perspective edges patch; do
            draw models/scenes/teapot.toml --renderer "$renderer" --shading "$shading" \
                --interpolation "$interpolation"
        done
    done
done
for tags in '[png]' '[obj]' '[mtl]' '[triangulate]' '[scene_file]' '[options]'; do
    checked "tests $tags" "$TESTS" "$tags"
done
echo "valgrind: no errors"
