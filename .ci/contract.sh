#!/usr/bin/env bash
# The contract is valid OpenAPI, and the server at BASE_URL keeps it. Without SEED every run sends other requests.
set -euo pipefail
cd "$(dirname "$0")/.."
: "${BASE_URL:?address of the server}"
[[ ${SEED:-random} != random ]] || SEED=$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')
echo "the requests are those of SEED=$SEED"

# That the committed document is the served one is a test of the workspace.
.ci/.cache/python/bin/openapi-spec-validator openapi/openapi.json

export PYTHONDONTWRITEBYTECODE=1 HYPOTHESIS_STORAGE_DIRECTORY=.ci/.cache/hypothesis
# The configuration bounds the number of examples; the time limit is for a run that hangs.
timeout 1500 .ci/.cache/python/bin/schemathesis \
    --config-file .ci/contract/schemathesis.toml run "$BASE_URL/openapi.json" --phases examples,coverage,fuzzing --checks all \
    --seed "$SEED" || { status=$?; echo "repeat with SEED=$SEED" >&2; exit "$status"; }
