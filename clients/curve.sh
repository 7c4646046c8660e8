#!/usr/bin/env bash
# A curve from an address, with curl: curve.sh [SERVER]
set -euo pipefail
server=${1:-http://127.0.0.1:8080}
folder=$(mktemp --directory)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

curl -sS --fail-with-body -o curve.csv "$server/v1/slip-sweep?wheel.preset=letter&soil.preset=letter-sand\
&soil.cohesion_pa=200&slip.from=0&slip.to=1&slip.points=101&normal_load_n=80&format=csv"
head -n 5 curve.csv | cut -d, -f1-3

# From here on the example is checked. The curve is the table that a POST answers with, and carries the load.
curl -sS --fail-with-body -o posted.csv -H 'Content-Type: application/json' -H 'Accept: text/csv' "$server/v1/slip-sweep" \
    -d '{"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand", "cohesion_pa": 200},
         "slip": {"from": 0, "to": 1, "points": 101}, "normal_load_n": 80}'
cmp curve.csv posted.csv
awk -F, 'NR == 1 { ok = $4 == "normal_force_n" }
         NR > 1 && ($4 < 80 - 1e-6 || $4 > 80 + 1e-6) { ok = 0 }
         END { exit !(ok && NR == 102) }' curve.csv || { echo 'not a curve of 101 slips at 80 N' >&2; exit 1; }

# At 20 mm and 20 % slip: an independent integration of the stresses over 401 000 points, rounded to the digits given.
curl -sS --fail-with-body -o forces.csv \
    "$server/v1/forces?wheel.preset=letter&soil.preset=letter-sand&slip=0.2&sinkage_m=0.02&format=csv"
awk -F, 'function near(value, expected, within) { return value > expected - within && value < expected + within }
         NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
         NR == 2 { ok = near($at["longitudinal_force_n"], 16.906, 5e-4) && near($at["normal_force_n"], 89.716, 5e-4) \
                     && near($at["torque_n_m"], 7.3396, 5e-5) }
         END { exit !ok }' forces.csv || { echo 'not the forces of the independent integration:' >&2; cat forces.csv >&2; exit 1; }
