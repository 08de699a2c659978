#!/usr/bin/env bash
# usage: scripts_test.sh REPOSITORY PROGRAM
# The shell scripts parse, can be executed and explain themselves; setup is quiet where nothing is missing.
set -euo pipefail
program=$2
cd "$1"

failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

bash_scripts() {
  local file
  for file in scripts/* report/build .ci/run; do
    if [[ -f "$file" && "$(head -c 19 "$file" | tr '\0' ' ')" == "#!/usr/bin/env bash" ]]; then echo "$file"; fi
  done
}

for script in $(bash_scripts); do
  bash -n "$script" || fail "$script does not parse"
  [[ -x "$script" ]] || fail "$script is not executable"
  grep -q '^set -euo pipefail$' "$script" || fail "$script does not stop at errors"
done
for script in setup build run test format fuzz coverage; do
  [[ "$(scripts/$script --help)" == usage:\ scripts/$script* ]] || fail "scripts/$script --help does not explain it"
done
[[ "$(report/build --help)" == usage:\ report/build* ]] || fail "report/build --help does not explain it"
[[ "$(scripts/setup --tests --list)" == *chromium* && "$(scripts/setup --list)" != *chromium* ]] ||
  fail "scripts/setup --tests, and only that, names the browser"
for script in setup build format fuzz; do
  status=0
  scripts/$script --no-such-option >/dev/null 2>&1 || status=$?
  ((status == 2)) || fail "scripts/$script --no-such-option gave exit status $status, not 2"
done

# setup names each package once, and `--check` and dpkg agree.
[[ -z "$(scripts/setup --clang --coverage --list | sort | uniq -d)" ]] || fail "scripts/setup --list names a package twice"
if command -v dpkg-query >/dev/null; then
  missing=$(scripts/setup --check) && status=0 || status=$?
  if ((status == 0)); then
    [[ -z "$missing" ]] || fail "scripts/setup --check says '$missing' and exits 0"
    [[ -z "$(scripts/setup 2>&1)" ]] || fail "scripts/setup is not quiet where nothing is missing"
  else
    [[ "$status" == 1 && "$missing" == missing:* ]] || fail "scripts/setup --check gave status $status, '$missing'"
  fi
fi

# A package that is known to dpkg but not installed counts as missing.
fake=$(mktemp -d)
trap 'rm -rf "$fake"' EXIT
printf '#!/bin/sh\necho "deinstall ok config-files"\n' >"$fake/dpkg-query"
chmod +x "$fake/dpkg-query"
status=0
missing=$(PATH="$fake:$PATH" scripts/setup --check) || status=$?
[[ "$status" == 1 && "$missing" == *libtbb-dev* ]] || fail "a removed package counts as installed"

# scripts/run sorts its words into studies and options of the program: a stand-in program shows what it gets.
mkdir -p "$fake/repository/scripts" "$fake/repository/build/release"
cp scripts/run "$fake/repository/scripts/"
printf '#!/bin/sh\n' >"$fake/repository/scripts/build"
cat >"$fake/repository/build/release/unbruised" <<'EOF'
#!/bin/sh
echo "$@"
case "$2" in bad.toml) exit 2 ;; diverged.toml) exit 3 ;; esac
EOF
chmod +x "$fake/repository/scripts/build" "$fake/repository/build/release/unbruised"
expect_run() { # status, output, arguments
  local status=0 output
  output=$("$fake/repository/scripts/run" "${@:3}" 2>&1) || status=$?
  [[ "$status" == "$1" ]] || fail "scripts/run ${*:3}: exit status $status, not $1"
  [[ "$output" == "$2" ]] || fail "scripts/run ${*:3}: ran '$output', not '$2'"
}
expect_run 0 "run configs/kiwi_first.toml"
expect_run 0 "run configs/kiwi_first.toml --threads 2" --threads 2
expect_run 0 "run a.toml --set cell.support=false product.use=b.toml --fresh" \
  --set cell.support=false product.use=b.toml a.toml --fresh
expect_run 0 "run a.toml --threads=1 -j 1 -j1 -q" a.toml --threads=1 -j 1 -j1 -q
expect_run 0 "run a.toml -j 1 --output b.toml" -j 1 --output b.toml a.toml
expect_run 3 "run a.toml"$'\n'"run diverged.toml"$'\n'"run bad.toml" a.toml diverged.toml bad.toml

# Every option of the program goes to it whole: "  -j,--threads N   threads ..." takes a value, "  -q,--quiet   no progress" none.
program_options() { # name and value word of each option of `run`
  "$program" run --help | sed -n '/^Options:/,/^$/p' | grep '^ *-' | sed 's/^ *//; s/   *.*//' |
    while read -r names value; do
      for name in ${names//,/ }; do echo "$name ${value%% *}"; done
    done
}
[[ "$(program_options | wc -l)" -ge 8 ]] || fail "the options of run --help could not be read"
while read -r name value; do
  [[ "$name" != --help && "$name" != -h ]] || continue
  if [[ -z "$value" ]]; then
    expect_run 0 "run a.toml $name" "$name" a.toml
    continue
  fi
  expect_run 0 "run a.toml $name 7" "$name" 7 a.toml
  expect_run 0 "run a.toml $name other.toml" "$name" other.toml a.toml
  if [[ "$name" == --* ]]; then
    expect_run 0 "run a.toml $name=7" "$name=7" a.toml
  else
    expect_run 0 "run a.toml ${name}7" "${name}7" a.toml
  fi
done <<<"$(program_options)"

exit $((failures > 0))
