#!/usr/bin/env bash
# A build in any other folder writes nothing into the source tree, the bundle of the report's page neither.
# usage: elsewhere_test.sh SOURCE
set -euo pipefail
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
touch "$folder/before"
cmake -S "$source" -B "$folder/build" -DUNBRUISED_BENCHMARKS=OFF >"$folder/log" 2>&1 &&
  cmake --build "$folder/build" --target report_bundle unbruised_optimizer >>"$folder/log" 2>&1 || { tail -n 20 "$folder/log" >&2; exit 1; }
[[ -e $folder/build/report/bundle/report.js ]] || { echo "elsewhere_test: the page's bundle is not in $folder/build" >&2; exit 1; }
# Other builds and runs of this tree have folders of their own; only the shared bundle's is looked into.
written=$(find "$source" \( -path "$source/.git" -o -path "$source/results" -o -name __pycache__ -o \( -path "$source/build/*" -not -path "$source/build/report*" \) \) -prune -o \
  -type f -newer "$folder/before" -print)
[[ -z $written ]] || { echo "elsewhere_test: written into the source tree: $written" >&2; exit 1; }
