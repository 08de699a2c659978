#!/usr/bin/env bash
# `cmake --install` puts below a prefix all that the program needs: from an empty folder it finds what ships, and shells complete its words.
# usage: install_test.sh BUILD_FOLDER
set -euo pipefail
build=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "install_test: $1" >&2; exit 1; }

cmake --install "$build" --prefix "$folder/usr" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; fail "cmake --install failed"; }
program=$folder/usr/bin/unbruised
mkdir "$folder/empty"
cd "$folder/empty"
unset UNBRUISED_CONFIGS
export HOME=$folder/home XDG_DATA_HOME=

"$program" list >list || fail "list ended with $?"
grep -qF "in $folder/usr/share/unbruised/configs:" list || fail "list names another library: $(head -n 1 list)"
"$program" check configs/kiwi_first.toml >check || fail "a study that ships is not found by the name that the documentation gives it"
"$program" check kiwi_first.toml >/dev/null || fail "nor without configs/"
if "$program" check configs/nobody_has_this.toml 2>said; then fail "what nobody has was found"; fi
grep -q "configs/nobody_has_this.toml" said || fail "the message does not name what was asked for: $(cat said)"

# What was set by hand comes before what was installed.
cp -r "$folder/usr/share/unbruised/configs" "$folder/mine"
sed -i 's/^description = .*/description = "mine"/' "$folder/mine/kiwi_first.toml"
UNBRUISED_CONFIGS=$folder/mine "$program" list >mine
grep -q "kiwi_first.toml.*mine" mine || fail "UNBRUISED_CONFIGS is not looked into"
mkdir -p "$folder/home/.local/share/unbruised"
mv "$folder/mine" "$folder/home/.local/share/unbruised/configs"
"$program" list >mine
grep -q "kiwi_first.toml.*mine" mine || fail "~/.local/share is not looked into"

[[ -s $folder/usr/share/man/man1/unbruised.1 ]] || fail "no man page"
for command in $("$program" --help | awk '/^Subcommands:/ { on = 1; next } on && /^  [a-z]/ { print $1 } /^$/ { on = 0 }'); do
  grep -q "^\.BI* $command" "$folder/usr/share/man/man1/unbruised.1" || fail "the man page leaves out $command"
done
# shellcheck source=/dev/null
source "$folder/usr/share/bash-completion/completions/unbruised"
COMP_WORDS=("$program" che) COMP_CWORD=1
_unbruised
[[ ${COMPREPLY[*]} == check ]] || fail "che is completed to '${COMPREPLY[*]}'"
COMP_WORDS=("$program" run --thr) COMP_CWORD=2
_unbruised
[[ ${COMPREPLY[*]} == --threads ]] || fail "run --thr is completed to '${COMPREPLY[*]}'"
