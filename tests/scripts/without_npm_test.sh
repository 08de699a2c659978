#!/usr/bin/env bash
# usage: without_npm_test.sh REPOSITORY
# The page of the report where npm's registry, npm or node is out of reach: left out with one sentence, never half there, and
# brought by the next build that reaches them. A copy of report/ is built, so the repository's own page stays.
set -euo pipefail
repository=$1

failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cp -r "$repository/report" "$place/report"
cd "$place"
bundle=build/report/bundle
export npm_config_cache=$place/cache npm_config_fetch_retries=0 npm_config_registry=http://127.0.0.1:9/ npm_config_userconfig=$place/npmrc

# Runs report/build with PATH $1 and the words that follow; sets status and words.
build() {
  local path=$1
  shift
  status=0
  words=$(PATH=$path report/build "$@" 2>&1) || status=$?
}

left_out() { # what was tried, what the sentence has to say
  [[ "$status" == 0 ]] || fail "$1: exit status $status"
  [[ "$(wc -l <<<"$words")" == 1 && "$words" == *"no report page"* && "$words" == *"$2"* ]] || fail "$1: said '$words'"
  for file in report.js report.css notices.txt; do
    [[ -f "$bundle/$file" && ! -s "$bundle/$file" ]] || fail "$1: $file is not there, or not empty"
  done
}

# Folders that stand for a PATH with no node, and with a node and an npm that always succeed.
mkdir bare able
for tool in bash cat cmp cp dirname env find mkdir rm sha256sum sort touch xargs; do ln -s "$(command -v $tool)" bare/; done
cp -P bare/* able/
printf '#!/usr/bin/env bash\nif [[ "$1" == config ]]; then echo a-registry; fi\n' >able/npm
printf '#!/usr/bin/env bash\nif [[ "$1" == -e ]]; then exit 0; fi\nfor f in report.js report.css notices.txt report.d; do echo made >build/report/bundle/$f; done\n' >able/node
chmod +x able/*

build "$PWD/bare" --or-without
left_out "without node" "node 18"

# A page of other sources, and half of one, are not used.
mkdir -p $bundle
echo old >$bundle/report.js
echo another >$bundle/sources.sha256
if command -v npm >/dev/null; then
  build "$PATH" --or-without
  left_out "registry out of reach" NODE_EXTRA_CA_CERTS
  [[ "$words" == *http://127.0.0.1:9/* ]] || fail "the registry is not named: '$words'"
  build "$PATH"
  [[ "$status" == 1 && "$words" == *NODE_EXTRA_CA_CERTS* ]] || fail "strict: status $status, '$words'"
fi

# CMake keeps what scripts/build left out, and asks nobody; scripts/build tries again and brings the page.
before=$(stat -c %Y%i $bundle/report.js)
build "$PWD/able" --keep
[[ "$status" == 0 && -z "$words" && ! -s $bundle/report.js && "$(stat -c %Y%i $bundle/report.js)" == "$before" ]] ||
  fail "--keep: status $status, '$words'"
build "$PWD/able" --or-without
[[ "$status" == 0 && "$(cat $bundle/report.js)" == made ]] || fail "in reach again: status $status, '$words'"
build "$PWD/bare" --or-without
[[ "$status" == 0 && -z "$words" && "$(cat $bundle/report.js)" == made ]] || fail "a whole page needs no npm: '$words'"

exit $((failures > 0))
