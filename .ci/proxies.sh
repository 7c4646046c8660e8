#!/usr/bin/env bash
# proxies.sh PROGRAM [ROWS]: nginx and HAProxy in front of the service, as they come and as deploy/proxy sets them. A table of
# telemetry has to come back whole through each, the same as without one, and the page has to work under a path.
set -euo pipefail
cd "$(dirname "$0")/.."
program=$1 rows=${2:-1000000}
scratch=$(mktemp -d)
started=()
trap 'for one in "${started[@]}"; do kill "$one" 2>/dev/null || true; done; wait 2>/dev/null || true; rm -rf "$scratch"' EXIT

# free NAME...: a free port for each.
free() {
    python3 - "$#" <<'PORTS'
import socket, sys
held = [socket.create_server(("127.0.0.1", 0)) for _ in range(int(sys.argv[1]))]
print(*(of.getsockname()[1] for of in held))
PORTS
}
read -r service plain settled unnamed balanced bare <<< "$(free a b c d e f)"

"$program" --listen "127.0.0.1:$service" --public-url "http://127.0.0.1:$settled/soil" > /dev/null 2> "$scratch/log" &
started+=($!)

# What every nginx needs that runs beside another one.
own="user $(id -un) $(id -gn); pid $scratch/nginx.pid; error_log $scratch/nginx.log;"
paths="access_log off; client_body_temp_path $scratch/a; proxy_temp_path $scratch/b; fastcgi_temp_path $scratch/c; uwsgi_temp_path $scratch/d; scgi_temp_path $scratch/e;"
others="server { listen 127.0.0.1:$plain; client_max_body_size 0; location / { proxy_pass http://127.0.0.1:$service; } }
server { listen 127.0.0.1:$unnamed; client_max_body_size 0; location / { proxy_pass http://soil; proxy_http_version 1.1; proxy_set_header Connection ''; } }"
{
    echo "$own"
    sed -e "s/127\.0\.0\.1:8080/127.0.0.1:$service/; s/listen 8000/listen 127.0.0.1:$settled/" deploy/proxy/nginx.conf |
        awk -v paths="$paths" -v others="$others" '{ print } /^http \{/ { print paths; print others }'
} > "$scratch/nginx.conf"
nginx -c "$scratch/nginx.conf" -g 'daemon off;' 2>> "$scratch/nginx.log" &
started+=($!)

{
    sed -e "s/127\.0\.0\.1:8080/127.0.0.1:$service/; s/bind :8000/bind 127.0.0.1:$balanced/" deploy/proxy/haproxy.cfg
    cat <<BARE
defaults
    mode http
    timeout connect 5s
    timeout client 60s
    timeout server 60s
frontend bare
    bind 127.0.0.1:$bare
    default_backend service
BARE
} > "$scratch/haproxy.cfg"
haproxy -f "$scratch/haproxy.cfg" 2>> "$scratch/haproxy.log" &
started+=($!)

for port in "$service" "$plain" "$unnamed" "$balanced" "$bare"; do
    curl -sS -o /dev/null --retry 30 --retry-all-errors --retry-delay 1 --fail "http://127.0.0.1:$port/readyz" 2> "$scratch/curl.log" ||
        { tail -n 3 "$scratch"/*log >&2; exit 1; }
done

awk -v rows="$rows" 'BEGIN {
    print "time_s,forward_velocity_m_s,angular_velocity_rad_s"
    for (i = 0; i < rows; i++) printf "%.2f,%.4f,%.4f\n", i / 100, 0.1 + 0.05 * sin(i / 700), 0.9 + 0.1 * cos(i / 900)
}' > "$scratch/table.csv"
question='v1/track?wheel.preset=letter&soil.preset=letter-sand&static_sinkage_m=0.02&method=explicit'

# ask PLACE [OPTION...]: the last line and the digest of the answer there.
ask() {
    local place=$1
    shift
    curl -sS -X POST -H 'Content-Type: text/csv' -H 'Expect:' --max-time 300 -T "$scratch/table.csv" "$@" -o "$scratch/answer.csv" "$place/$question"
    echo "$(tail -n 1 "$scratch/answer.csv" | cut -c 1-200) $(sha256sum < "$scratch/answer.csv" | cut -c 1-16)"
}

wanted=$(ask "http://127.0.0.1:$service")
[[ $wanted == "#end,$rows "* ]] || { echo "without a proxy: $wanted" >&2; exit 1; }
try() {
    local name=$1 found
    shift
    found=$(ask "$@")
    [[ $found == "$wanted" ]] || { echo "$name: $found instead of $wanted" >&2; tail -n 3 "$scratch"/*.log >&2; exit 1; }
    echo "$name: $found"
}
chunked=(-H 'Transfer-Encoding: chunked')
try 'nginx as it comes' "http://127.0.0.1:$plain"
try 'nginx as it comes, in chunks' "http://127.0.0.1:$plain" "${chunked[@]}"
try 'nginx with HTTP/1.1 that does not say who it is' "http://127.0.0.1:$unnamed"
try 'nginx of deploy/proxy, under a path' "http://127.0.0.1:$settled/soil"
try 'nginx of deploy/proxy, in chunks' "http://127.0.0.1:$settled/soil" "${chunked[@]}"
try 'HAProxy of deploy/proxy' "http://127.0.0.1:$balanced"
try 'HAProxy of deploy/proxy, in chunks' "http://127.0.0.1:$balanced" "${chunked[@]}"
try 'HAProxy that does not say who it is' "http://127.0.0.1:$bare"
try 'HAProxy that does not say who it is, in chunks' "http://127.0.0.1:$bare" "${chunked[@]}"

# The pages and what they name, under a path.
site="http://127.0.0.1:$settled/soil"
for page in '' docs; do
    curl -sS --fail "$site/$page" > "$scratch/page.html"
    grep -o '\(src\|href\)="[^"#]*"' "$scratch/page.html" | sed 's/.*="//; s/"$//' | sort -u | while read -r link; do
        curl -sS --fail --location -o /dev/null "$site/$link" || { echo "$site/$page leads to nothing: $link" >&2; exit 1; }
    done
done
curl -sS --fail --location -o /dev/null "$site/docs/"
curl -sS --fail "$site/openapi.json" | python3 -c '
import json, sys, urllib.request
server = json.load(sys.stdin)["servers"][0]["url"]
urllib.request.urlopen(server + "/v1/limits").read()'
echo 'the pages work under a path'
