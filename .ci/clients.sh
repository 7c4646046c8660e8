#!/usr/bin/env bash
# Runs every program in clients/ against the server at BASE_URL, all of them even where one fails. Before, a Python package,
# pydantic models and types for TypeScript are generated from the contract that the server shows, for the programs that use
# them: with the generators' defaults wherever these serve.
set -euo pipefail
cd "$(dirname "$0")/.."
: "${BASE_URL:?address of the server}"

# The programs stand beside what is generated, as in a user's folder.
place=.ci/.cache/clients
rm -rf "$place"
mkdir -p "$place"
cp clients/* "$place"
cd "$place"
python=../python/bin
node=../../node_modules/.bin

"$python/openapi-python-client" generate --meta none --url "$BASE_URL/openapi.json" \
    --config ../../openapi-python-client.yaml --fail-on-warning
"$python/datamodel-codegen" --url "$BASE_URL/openapi.json" --allow-private-network --output terramechanics_models.py
"$node/openapi-typescript" "$BASE_URL/openapi.json" --default-non-nullable=false --output terramechanics.d.ts

export PYTHONDONTWRITEBYTECODE=1
failed=()
passed=0
check() {
    echo "--> $*"
    if timeout 120 "$@"; then passed=$((passed + 1)); else failed+=("$*"); fi
}

for program in ../../../clients/*.py; do
    # What uses the package for Python is run with it.
    if grep --quiet '^import terramechanics$' "$program"; then continue; fi
    program=${program##*/}
    check "$python/python" "$program" "$BASE_URL"
done
for program in *.mjs; do
    check "$node/tsc" --noEmit --strict --checkJs --target es2022 --module nodenext --types node "$program"
    check node "$program" "$BASE_URL"
done
for program in *.m; do
    check octave-cli --no-history --norc --eval "${program%.m}('$BASE_URL')"
done
for program in *.sh; do
    check bash "$program" "$BASE_URL"
done

[[ ${#failed[@]} -eq 0 ]] || { printf 'failed: %s\n' "${failed[@]}" >&2; exit 1; }
echo "$passed checks of clients passed"
