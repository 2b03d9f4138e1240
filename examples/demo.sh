#!/usr/bin/env bash
# The demo: which links of a robot arm meet, which tracks of a board, which coastlines, which polygons are valid, which
# craters overlap, whether a line goes through all error bars; with proofs that two verifiers check.
#
#   examples/demo.sh PROGRAM [OUT_DIR]        PROGRAM: the built `sunder`; OUT_DIR: build/demo by default
#
# Exit code: 0 when all went as it should, 1 otherwise.
set -euo pipefail

if [ $# -lt 1 ] || [ $# -gt 2 ] || [ ! -x "$1" ]; then
  echo "demo.sh: name the program: examples/demo.sh build/bin/sunder [OUT_DIR]" >&2
  exit 2
fi
program=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
out=${2:-}
[ -n "$out" ] && mkdir -p "$out" && out=$(cd "$out" && pwd)
cd "$(dirname "$0")/.."
[ -n "$out" ] || { out=build/demo && mkdir -p "$out"; }

bold= dim= plain=
if [ -t 1 ] && [ -z "${NO_COLOR:-}" ]; then bold=$'\e[1m' dim=$'\e[2m' plain=$'\e[0m'; fi
say() { printf '\n%s%s%s\n' "$bold" "$*" "$plain"; }
show() { printf '%s$ %s%s\n' "$dim" "$*" "$plain"; }
fail() { printf 'demo: %s\n' "$*" >&2; exit 1; }
started=$(date +%s.%N)

question=(cases/panda/panda.urdf --joints-file cases/scene/ready.joints --joints-file cases/scene/folded.joints
          --allow adjacent)
proofs=$out/panda.proofs.json

say "A Franka Emika Panda in two placements: which links meet?"
show "sunder scene ${question[*]}"
code=0
"$program" scene "${question[@]}" --certificate "$proofs" --svg "$out/panda.svg" \
  --title "Franka Emika Panda: which links meet?" || code=$?
[ $code -eq 1 ] || fail "expected that some links meet (exit code 1), but the exit code is $code"
echo "Allowed: neighbours only, whose shapes overlap by design: links joined by a joint (link7 and the hand through link8,"
echo "which has no shape). No other pair is excused."
"$program" scene "${question[@]}" --json > "$out/panda.json" 2> /dev/null || [ $? -eq 1 ]
echo "report: $out/panda.json"

say "Every answer is proved. A short verifier in Python, which shares no code with Sunder, checks all proofs:"
show "python3 verifier/python/sunder_verify $proofs | tail -n 1"
python3 verifier/python/sunder_verify "$proofs" > "$out/verified.txt" || fail "the Python verifier refuses: $out/verified.txt"
tail -n 1 "$out/verified.txt"
show "sunder verify $proofs"
"$program" verify "$proofs" || fail "sunder verify refuses"

say "One digit of one proof changed, and it is refused:"
show "python3 examples/change_a_digit.py $proofs > $out/changed.json"
python3 examples/change_a_digit.py "$proofs" > "$out/changed.json"
show "python3 verifier/python/sunder_verify --quiet $out/changed.json"
code=0
python3 verifier/python/sunder_verify --quiet "$out/changed.json" || code=$?
[ $code -eq 1 ] || fail "the Python verifier did not refuse the changed proof"
show "sunder verify $out/changed.json"
code=0
"$program" verify "$out/changed.json" || code=$?
[ $code -eq 1 ] || fail "sunder verify did not refuse the changed proof"

board=cases/boards/tinyfpga/TinyFPGA-BX.kicad_pcb
say "A routed board: do two nets cross on a layer?"
show "sunder segments $board --centre-lines --certificate $out/board.json"
"$program" segments "$board" --centre-lines --certificate "$out/board.json" || fail "expected that none meet (exit code 0)"
show "sunder verify $out/board.*.Cu.json"
"$program" verify "$out"/board.*.Cu.json || fail "sunder verify refuses"
say "And seen through all layers?"
show "sunder segments $board --centre-lines --all --across-layers --svg $out/board.svg | head -n 8"
code=0
"$program" segments "$board" --centre-lines --all --across-layers --svg "$out/board.svg" > "$out/board.txt" || code=$?
[ $code -eq 1 ] || fail "expected that some meet (exit code 1), but the exit code is $code"
head -n 8 "$out/board.txt"

coast=cases/coastline/coastline_50m.wkt
say "The coastlines of the world: does any cross itself or another? (Segments that follow each other share ends.)"
show "sunder segments $coast --allow shared-endpoint --certificate $out/coast.proof.json"
"$program" segments "$coast" --allow shared-endpoint --certificate "$out/coast.proof.json" \
  || fail "expected that none meet (exit code 0)"
show "python3 verifier/python/sunder_verify $out/coast.proof.json"
python3 verifier/python/sunder_verify "$out/coast.proof.json" || fail "the Python verifier refuses"
show "sunder verify $out/coast.proof.json"
"$program" verify "$out/coast.proof.json" || fail "sunder verify refuses"

say "Fifty polygons that have troubled a triangulator: which are valid?"
show "for f in cases/polygons/*.json; do sunder simple \$f; done"
valid=0 invalid=0 refused=0
for file in cases/polygons/*.json; do
  code=0
  "$program" simple "$file" > "$out/simple.txt" 2> "$out/refused.txt" || code=$?
  case $code in
    0) valid=$((valid + 1)) ;;
    1) invalid=$((invalid + 1)); [ $invalid -gt 1 ] || head -n 3 "$out/simple.txt" ;;
    2) refused=$((refused + 1)); [ $refused -gt 1 ] || cat "$out/refused.txt" ;;
    *) fail "exit code $code for $file" ;;
  esac
done
echo "valid: $valid; not valid, with what is wrong: $invalid; refused, with the reason: $refused"

say "Named craters of the Moon's near side, as circles of the plane (a stereographic projection keeps circles circles): which overlap?"
show "sunder circles cases/circles/moon.csv --all --svg $out/craters.svg | head -n 5"
code=0
"$program" circles cases/circles/moon.csv --all --svg "$out/craters.svg" > "$out/craters.txt" || code=$?
[ $code -eq 1 ] || fail "expected that some meet (exit code 1), but the exit code is $code"
head -n 5 "$out/craters.txt"

say "Census tracts: they share borders; do any two overlap?"
show "sunder polygons cases/tracts/tracts.wkt --allow touch"
"$program" polygons cases/tracts/tracts.wkt --allow touch || fail "expected that none overlap (exit code 0)"

say "A drawing of two bodies seen from above: can one hide a part of the other?"
show "python3 examples/hidden_lines.py z cases/mesh/cube.obj cases/mesh/tetrahedron.obj > $out/outlines.geojson"
python3 examples/hidden_lines.py z cases/mesh/cube.obj cases/mesh/tetrahedron.obj > "$out/outlines.geojson"
show "sunder polygons $out/outlines.geojson --allow touch"
code=0
"$program" polygons "$out/outlines.geojson" --allow touch || code=$?
[ $code -eq 1 ] || fail "expected that their outlines overlap (exit code 1), but the exit code is $code"

say "CO2 at Mauna Loa, 1959 to 2025: is there a line through all error bars?"
show "sunder region cases/half-planes/co2.csv --certificate $out/co2.json"
code=0
"$program" region cases/half-planes/co2.csv --certificate "$out/co2.json" || code=$?
[ $code -eq 1 ] || fail "expected that there is none (exit code 1), but the exit code is $code"
python3 verifier/python/sunder_verify "$out/co2.json" || fail "the Python verifier refuses"
say "And through those of the first five years? The steepest:"
show "sunder region cases/half-planes/co2-five-years.csv --maximize 1,0 --svg $out/co2.svg"
"$program" region cases/half-planes/co2-five-years.csv --maximize 1,0 --svg "$out/co2.svg" || fail "expected that there is one"

printf '\nAll of this took %.1f s. Pictures: %s\n' "$(echo "$(date +%s.%N) $started" | awk '{print $1 - $2}')" \
  "$out/panda.svg, $out/board.svg, $out/craters.svg, $out/co2.svg"
