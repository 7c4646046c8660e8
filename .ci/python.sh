#!/usr/bin/env bash
# The package for Python: builds the wheel, and checks it by its types, by its tests against the server at BASE_URL, and by the
# programs in clients/ that use it, in threads and on a cluster that loses a process.
set -euo pipefail
cd "$(dirname "$0")/.."
: "${BASE_URL:?address of the server}"
python=$PWD/.ci/.cache/python/bin
export PYTHONDONTWRITEBYTECODE=1

# The dependencies are those of the program, which are built already.
rm -rf .ci/.cache/wheels
"$python/maturin" build --release --locked --manifest-path crates/python/Cargo.toml --interpreter "$python/python" \
    --target-dir "${CARGO_TARGET_DIR:-target}" --out .ci/.cache/wheels
"$python/pip" install --quiet --disable-pip-version-check --no-deps --no-index --force-reinstall .ci/.cache/wheels/*.whl

cd crates/python
"$python/mypy" --strict --cache-dir ../../.ci/.cache/mypy python/terramechanics
"$python/python" -m mypy.stubtest --mypy-config-file pyproject.toml terramechanics._native
"$python/pytest" --quiet -p no:cacheprovider tests

cd ../../clients
"$python/python" ../.ci/cluster.py terrain_map.py 150
"$python/python" ../.ci/cluster.py monte_carlo.py 200000
