#!/bin/bash
# A million samples through /v1/track as a table, on loopback: rows a second, CPU per row, growth of the server's memory, time to the first row.
#
#   cargo build --release && benches/track.sh [ROWS]
#
# Needs curl. The server has one worker and one thread for computations on core 0, the client core 1.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
program="$here/../target/release/terramechanics"
rows=${1:-1000000}
scratch=$(mktemp -d)
trap 'kill "$server" 2> /dev/null || true; rm -rf "$scratch"' EXIT

awk -v rows="$rows" 'BEGIN {
    print "time_s,forward_velocity_m_s,angular_velocity_rad_s"
    for (i = 0; i < rows; i++) printf "%.2f,%.4f,%.4f\n", i / 100, 0.1 + 0.05 * sin(i / 700), 0.9 + 0.1 * cos(i / 900)
}' > "$scratch/in.csv"
awk -F, 'NR == 1 { print $0 ",sinkage_m,torque_n_m"; next }
    { printf "%s,%.5f,%.4f\n", $0, 0.02 + 0.005 * sin(NR / 800), 5 + sin(NR / 600) }' "$scratch/in.csv" > "$scratch/measured.csv"

exec {announced}< <(exec taskset -c 0 "$program" --listen 127.0.0.1:0 --workers 1 --compute-threads 1 2> "$scratch/log")
server=$!
read -r -t 30 line <&"$announced"
[[ $line =~ (http://127\.0\.0\.1:[0-9]+)/ ]]
base="${BASH_REMATCH[1]}/v1/track?wheel.preset=letter&soil.preset=letter-sand"
hz=$(getconf CLK_TCK)
cpu() { awk '{print $14 + $15}' "/proc/$server/stat"; }
memory() { awk -v name="$1" '$1 == name ":" {print $2}' "/proc/$server/status"; }

# run LABEL SETTINGS [TABLE]: sends the table, once small to warm up.
run() {
    local before start end idle table="$scratch/${3:-in.csv}"
    head -n 2000 "$table" | curl -sS -o /dev/null -H 'Content-Type: text/csv' -T - -X POST "$base&$2"
    idle=$(memory VmRSS) before=$(cpu)
    echo 5 > "/proc/$server/clear_refs" 2> /dev/null || true # the peak from here on
    start=$(date +%s%N)
    taskset -c 1 curl -sS -H 'Content-Type: text/csv' -H 'Expect:' -T "$table" -X POST -o "$scratch/out.csv" \
        -w '%{time_starttransfer}' "$base&$2" > "$scratch/first"
    end=$(date +%s%N)
    [ "$(tail -n 1 "$scratch/out.csv")" = "#end,$rows" ] || { echo "the answer is not whole"; tail -n 2 "$scratch/out.csv"; exit 1; }
    awk -v label="$1" -v rows="$rows" -v ns=$((end - start)) -v ticks=$(($(cpu) - before)) -v hz="$hz" -v first="$(cat "$scratch/first")" \
        -v growth=$(($(memory VmHWM) - idle)) 'BEGIN {
            printf "%-28s %8.0f rows/s  server %.2f us/row  first byte after %.0f ms  memory +%d kB\n",
                label, rows / ns * 1e9, ticks / hz * 1e6 / rows, first * 1000, growth }'
}

for _ in 1 2 3; do
    run 'explicit, static sinkage' 'static_sinkage_m=0.02&method=explicit'
    run 'explicit, load' 'normal_load_n=80&method=explicit'
    run 'explicit, measured' 'normal_load_n=80&method=explicit' measured.csv
    run 'explicit, running strength' 'normal_load_n=80&method=explicit&strength=true' measured.csv
done
run 'quadrature, static sinkage' 'static_sinkage_m=0.02'
run 'quadrature, load' 'normal_load_n=80'
