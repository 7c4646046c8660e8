#!/usr/bin/env bash
# Installs what the checks need beyond Rust, Python and node: system packages, and the versions pinned in
# requirements.txt and package-lock.json. What is there already is kept.
set -euo pipefail
cd "$(dirname "$0")"

# Without a font a page has no text to measure or to see.
missing=()
for package in chromium curl fonts-dejavu-core haproxy nginx-light octave python3-venv; do
    dpkg-query --show --showformat='${db:Status-Status}\n' "$package" 2>/dev/null | grep --quiet '^installed$' || missing+=("$package")
done
if [[ ${#missing[@]} -gt 0 ]]; then
    export DEBIAN_FRONTEND=noninteractive
    apt-get --option Acquire::Retries=3 update
    apt-get --option Acquire::Retries=3 install --yes --no-install-recommends "${missing[@]}"
fi

# The copy of the pins is written last, so that an installation that broke off is done again.
if ! cmp --silent requirements.txt .cache/python/requirements.txt; then
    rm -rf .cache/python
    python3.11 -m venv .cache/python
    .cache/python/bin/pip install --quiet --disable-pip-version-check --no-deps --requirement requirements.txt
    .cache/python/bin/pip check
    cp requirements.txt .cache/python/requirements.txt
fi

npm ci --ignore-scripts --no-audit --no-fund
