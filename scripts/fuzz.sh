#!/usr/bin/env bash
# fuzz.sh SECONDS [TARGET...]: builds the fuzz targets (preset fuzz) and runs each for SECONDS; without TARGET all of them.
#   --build FOLDER   builds in FOLDER, instead of in build/fuzz
#   --runs N         makes N runs instead, with a fixed seed: the same inputs every time. Not optimised, as compiling takes
#                    longer than so few runs
#   --built FOLDER   for such runs: takes the libraries that were built in FOLDER. libFuzzer then sees the coverage only of
#                    targets, readers and the oracle
#   --seed S         for the long run: another seed finds other inputs (default: the clock)
# Starts from tests/fuzz/corpus. Inputs that the fuzzer adds stay in FOLDER/corpus, inputs of failures in FOLDER/findings:
# run FOLDER/tests/fuzz/TARGET_fuzz with such a file to repeat the failure. Exit code 77 if clang is absent.
set -euo pipefail
cd "$(dirname "$0")/.."

build=build/fuzz runs="" built="" seed=0 targets=()
while (($#)); do
  case $1 in
    --build) build=$2; shift 2 ;;
    --runs) runs=$2; shift 2 ;;
    --built) built=$2; shift 2 ;;
    --seed) seed=$2; shift 2 ;;
    *) targets+=("$1"); shift ;;
  esac
done
seconds=""
if [[ -z $runs ]]; then
  seconds=${targets[0]:?give the seconds a target}
  targets=("${targets[@]:1}")
fi
if ! ((${#targets[@]})); then
  targets=(tests/fuzz/*_fuzz.cpp)
  targets=("${targets[@]##*/}")
  targets=("${targets[@]%_fuzz.cpp}")
fi

clang=$(scripts/clang.sh) || { echo "$clang"; exit 77; }
runtime=$("$clang" --print-file-name=libclang_rt.fuzzer-x86_64.a)
[[ -e $runtime || -e ${runtime/-x86_64/} ]] || { echo "skipped: no libFuzzer (libclang-rt-dev of the same version)"; exit 77; }
cmake --preset fuzz -B "$build" -DCMAKE_CXX_COMPILER="$clang" -DTAMIS_BUILT="$built" ${runs:+-DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O0 -g1"} >/dev/null
cmake --build "$build" --parallel "$(nproc)" --target "${targets[@]/%/_fuzz}"

for target in "${targets[@]}"; do
  echo "fuzzing: $target"
  # Without -error_exitcode libFuzzer ends with 77 at a finding, which ctest takes for "skipped". An input takes a second or
  # two on a free core; on a machine with ten times more work than cores one took more than 60.
  options=(-error_exitcode=1 -print_final_stats=1 -timeout=300 -rss_limit_mb=4096 -artifact_prefix="$build/findings/$target-")
  mkdir -p "$build/findings" "$build/corpus/$target"
  if [[ $target == pair ]]; then options+=(-max_len=320); fi
  if [[ $target == mesh ]]; then options+=(-max_len=600); fi
  if [[ -n $runs ]]; then
    rm -rf "$build/short/$target" && mkdir -p "$build/short/$target"
    "$build/tests/fuzz/${target}_fuzz" "${options[@]}" -seed=1 -runs="$runs" -verbosity=0 \
      "$build/short/$target" "tests/fuzz/corpus/$target"  # new inputs go into the first folder
  else
    "$build/tests/fuzz/${target}_fuzz" "${options[@]}" -seed="$seed" -max_total_time="$seconds" \
      "$build/corpus/$target" "tests/fuzz/corpus/$target" -verbosity=0
  fi
done
