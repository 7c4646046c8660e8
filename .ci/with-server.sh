#!/usr/bin/env bash
# with-server.sh PROGRAM COMMAND...: runs COMMAND while PROGRAM serves at BASE_URL on a free port.
# Fails as well where the server logs an error or does not end cleanly.
set -euo pipefail

program=$1
shift
log=$(mktemp)

exec {announced}< <(exec "$program" --listen 127.0.0.1:0 --log-format json 2>"$log")
server=$!
# A server that hangs hears no other signal.
trap 'kill -KILL "$server" 2>/dev/null || true; rm -f "$log"' EXIT

# The server says where its page is as soon as it listens.
read -r -t 30 line <&"$announced" || { cat "$log" >&2; echo "the server did not start" >&2; exit 1; }
[[ $line =~ (http://127\.0\.0\.1:[0-9]+)/ ]] || { echo "no address in: $line" >&2; exit 1; }

BASE_URL=${BASH_REMATCH[1]} "$@"

kill "$server"
timeout 30 tail --pid="$server" -f /dev/null || { tail -n 20 "$log" >&2; echo "the server does not end" >&2; exit 1; }
wait "$server" || { tail -n 20 "$log" >&2; echo "the server ended with status $?" >&2; exit 1; }
if grep '"level":"ERROR"' "$log" >&2; then
    echo "the server logged errors" >&2
    exit 1
fi
