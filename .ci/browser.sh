#!/usr/bin/env bash
# Runs every check in browser/ with node against the page at BASE_URL, all of them even where one fails.
set -euo pipefail
cd "$(dirname "$0")/.."
: "${BASE_URL:?address of the server}"

export CHROMIUM=${CHROMIUM:-/usr/bin/chromium}
shopt -s nullglob
checks=(.ci/browser/*.mjs)
[[ ${#checks[@]} -gt 0 ]] || { echo 'there are no checks in .ci/browser' >&2; exit 1; }

failed=()
for check in "${checks[@]}"; do
    echo "--> $check"
    timeout 300 node "$check" || failed+=("$check")
done
[[ ${#failed[@]} -eq 0 ]] || { echo "failed: ${failed[*]}" >&2; exit 1; }
echo "${#checks[@]} browser checks passed"
