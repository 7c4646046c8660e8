#!/usr/bin/env bash
# Sends damaged requests to the server at BASE_URL. Every run sends others; SEED=… repeats one.
set -euo pipefail
cd "$(dirname "$0")/.."
: "${BASE_URL:?address of the server}"
: "${SEED:=$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}"
echo "the requests are those of SEED=$SEED"

export SEED PYTHONDONTWRITEBYTECODE=1
timeout 900 python3 .ci/contract/mutations.py
