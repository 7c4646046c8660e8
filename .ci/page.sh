#!/usr/bin/env bash
# Checks the code of the page without running it: its types against those of the contract, those of its checks in browser/, and the
# direction of its imports.
set -euo pipefail
cd "$(dirname "$0")"
tools=node_modules/.bin

mkdir -p .cache/page
"$tools/openapi-typescript" ../openapi/openapi.json --default-non-nullable=false --output .cache/page/contract.d.ts
"$tools/tsc" --project tsconfig.json
"$tools/tsc" --project tsconfig.browser.json
node imports.mjs ../static
