#!/usr/bin/env bash
# `cmake --install` puts below a prefix all that the program needs: from an empty folder it finds what ships, and shells complete its words.
# A project outside builds an example against it; it inherits no flag.
# usage: install_test.sh BUILD_FOLDER
set -euo pipefail
build=$1
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$(cd "$tests/../.." && pwd)
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

# The same in zsh and fish, with a new user's settings.
export PATH="$folder/usr/bin:$PATH"
for shell in zsh fish; do command -v "$shell" >/dev/null || echo "install_test: no $shell, so its completions were not tried"; done
if command -v fish >/dev/null; then
  in_fish() { fish --no-config --command "source '$folder/usr/share/fish/vendor_completions.d/unbruised.fish'; complete --do-complete '$1'"; }
  [[ $(in_fish 'unbruised che') == check* ]] || fail "fish completes che to '$(in_fish 'unbruised che')'"
  [[ $(in_fish 'unbruised run --thr') == --threads* ]] || fail "fish completes run --thr to '$(in_fish 'unbruised run --thr')'"
fi
if command -v zsh >/dev/null; then
  for words in "unbruised che|check" "unbruised run --thr|--threads"; do
    zsh -f "$tests/completion.zsh" "$folder/usr/share/zsh/vendor-completions" "${words%|*}" "${words#*|}" >said ||
      fail "zsh completes ${words%|*} to '$(tail -n 1 said)'"
  done
fi

# What Python finds there can be imported; a build without the module brings nothing.
module=$(find "$folder/usr/lib" -name "_unbruised*.so")
files=$(find "$folder/usr/lib" -path "*dist-packages/unbruised/*")
if [[ -n $module ]]; then
  PYTHONPATH=$folder/usr/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c "import unbruised as ub; assert ub.load('kiwi_first.toml').kind == 'sweep'" ||
    fail "import unbruised from the prefix failed"
else
  [[ -z $files ]] || fail "Python's files are there without the module: $files"
fi

# Built like this a project outside has the library and its headers, and neither -march nor -Werror.
if [[ -n $(find "$folder/usr/lib" -name libunbruised_core.a) ]]; then
  cp -r "$(dirname "$(find "$folder/usr/share" -name one_scenario.cpp)")" "$folder/examples"
  cmake -S "$folder/examples" -B "$folder/outside" -DCMAKE_PREFIX_PATH="$folder/usr" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >log 2>&1 &&
    cmake --build "$folder/outside" >>log 2>&1 || { cat log >&2; fail "a project outside does not build"; }
  if grep -E -e "-march|-Werror|$source" "$folder/outside/compile_commands.json"; then fail "a project outside inherits flags or folders of ours"; fi
  "$folder/outside/one_scenario" >said || fail "the example ended with $?: $(cat said)"
  grep -q "^held after" said || fail "the example says $(cat said)"
else
  echo "install_test: no library was built, so no project outside was tried"
fi
