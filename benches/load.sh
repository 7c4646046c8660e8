#!/bin/bash
# CPU per request of the service under load, on loopback: one server core, one client core, 64 connections.
#
#   cargo build --release && benches/load.sh [OTHER_SERVER PORT PATH SCRIPT]
#
# Needs wrk. With a second server (a no-op to compare with, asked by its own wrk script), both are run in turn three times: on a shared machine only the
# ratio within one run means something. Prints requests, server CPU per request, and memory before and after.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
ours="$here/../target/release/terramechanics"
hz=$(getconf CLK_TCK)

cpu() { awk '{print $14 + $15}' "/proc/$1/stat"; }
memory() { awk '/VmRSS/ {print $2}' "/proc/$1/status"; }

# run LABEL URL SCRIPT PROGRAM [ARGUMENT …]
run() {
    local label=$1 url=$2 script=$3 idle before after out
    shift 3
    taskset -c 0 "$@" > /dev/null 2>&1 &
    server=$!
    trap 'kill $server 2> /dev/null' EXIT
    sleep 0.5
    idle=$(memory $server)
    taskset -c 1 wrk -t1 -c64 -d1s -s "$script" "$url" > /dev/null
    before=$(cpu $server)
    out=$(taskset -c 1 wrk -t1 -c64 -d6s --latency -s "$script" "$url")
    after=$(cpu $server)
    awk -v label="$label" -v ticks=$((after - before)) -v hz="$hz" -v idle="$idle" -v end="$(memory $server)" '
        /requests in/ { requests = $1 }
        /99%/ { p99 = $2 }
        /Non-2xx|Socket errors/ { bad = bad $0 }
        END { printf "%-10s %8d requests  p99 %s  server %.2f us/request  memory %d kB idle, %d kB after %s\n",
              label, requests, p99, ticks / hz * 1e6 / requests, idle, end, bad }' <<< "$out"
    kill $server
    wait $server 2> /dev/null || true
    trap - EXIT
}

for _ in 1 2 3; do
    if [ $# -ge 4 ]; then run other "http://127.0.0.1:$2$3" "$4" "$1"; fi
    run ours http://127.0.0.1:18082/v1/forces "$here/load.lua" "$ours" --listen 127.0.0.1:18082 --workers 1
done
