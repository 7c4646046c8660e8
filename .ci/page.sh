#!/usr/bin/env bash
# Checks the code of the page without running it: its types against those of the contract, and the direction of its imports.
set -euo pipefail
cd "$(dirname "$0")"
tools=node_modules/.bin

mkdir -p .cache/page
"$tools/openapi-typescript" ../openapi/openapi.json --default-non-nullable=false --output .cache/page/contract.d.ts
"$tools/tsc" --project tsconfig.json
node imports.mjs ../static
