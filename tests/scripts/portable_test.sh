#!/usr/bin/env bash
# A portable build takes the best library that the machine has, gives the bits of the native build of that instruction set, and says
# in one sentence where none will do.
# usage: portable_test.sh BUILD_FOLDER
set -euo pipefail
build=$1
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
program=$build/unbruised
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "portable_test: $1" >&2; exit 1; }
# $1 is what glibc must not know of the processor
without() { GLIBC_TUNABLES="glibc.cpu.hwcaps=$1" "${@:2}"; }
avx512=-AVX512F,-AVX512VL
avx2=$avx512,-AVX2

version=$("$program" --version)
if [[ $(/lib64/ld-linux-x86-64.so.2 --help) == *"x86-64-v4 (supported, searched)"* && -e $build/lib/unbruised/glibc-hwcaps/x86-64-v4/libunbruised.so ]]; then
  [[ $version == *", avx512f" ]] || fail "with AVX-512 the program is '$version'"
else
  [[ $version == *", avx2+fma" ]] || fail "without AVX-512 the program is '$version'"
fi
[[ $(without $avx512 "$program" --version) == *", avx2+fma" ]] || fail "AVX-512 left out, the program is '$(without $avx512 "$program" --version)'"

# The committed digests are those of native builds.
digests() { awk -v name="$1" '/^\[/ { on = index($0, "['"${version#*, }"']") == 1 } on && $1 == name { print $3 }' "$source/tests/golden/digests.txt"; }
version=$(without $avx512 "$program" --version)
for study in sweep sample; do
  wanted=$(digests $study)
  [[ -n $wanted ]] || { echo "portable_test: no digests of [${version#*, }]"; continue; }
  is=$(without $avx512 "$program" run "$source/tests/golden/studies/$study.toml" --quiet --no-replay --output "$folder/$study" 2>/dev/null | awk '$1 == "digest" { print $2 }')
  [[ $is == "$wanted" ]] || fail "$study has the digest $is, in the native build $wanted"
  echo "portable, $study: digest of the native build, $is, ${version##*, }"
done

sentence="unbruised: this build needs a processor with AVX2 and fused multiply-add"
too_old() { # WHAT COMMAND...
  local status=0
  "${@:2}" >"$folder/out" 2>"$folder/said" || status=$?
  [[ $status == 1 && ! -s $folder/out && $(wc -l <"$folder/said") == 1 && $(cat "$folder/said") == "$sentence"* ]] ||
    fail "$1 it ends with $status: $(cat "$folder/out" "$folder/said")"
}
too_old "without AVX2" without $avx2 "$program" --version
if command -v qemu-x86_64 >/dev/null; then
  too_old "on a processor of 2010" qemu-x86_64 -cpu Westmere "$program" --version
else
  echo "portable_test: no qemu-x86_64, so an older processor was not tried"
fi
if [[ -d $build/python ]]; then
  export PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1
  /usr/bin/python3 -c "import unbruised" || fail "import unbruised failed"
  said=$(without $avx2 /usr/bin/python3 -c "import unbruised" 2>&1) && fail "import unbruised without AVX2 succeeds"
  [[ $said == *"ImportError: this build needs a processor with AVX2"* ]] || fail "import unbruised without AVX2 says $said"
fi
