#!/usr/bin/env bash
# The pages of the API are made from the docstrings without a warning.
# usage: api_test.sh REPOSITORY FOLDER
set -euo pipefail
command -v doxygen >/dev/null || exit 77
mkdir -p "$2"
folder=$(cd "$2" && pwd)
cd "$1"
(cat docs/Doxyfile && echo "OUTPUT_DIRECTORY=$folder") | doxygen - >"$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
if [[ -s "$folder/said" ]]; then
  sort -u "$folder/said"
  exit 1
fi
pages=("$folder"/html/*.html)
echo "${#pages[@]} pages in $folder/html, no warning"
