# Every option of every command that takes a number reads it whole or refuses it, with the option and the value first.
. "$(dirname "$0")/harness.sh"
. "$(dirname "$0")/commands.sh"

options=0
commands >paths
while read -r path; do
  # shellcheck disable=SC2086  # a path is words
  run 0 $path --help
  cp out help
  grep -E ' (TEXT|INT|UINT|FLOAT|BOOLEAN)( |$)' help >unnamed && fail "$path: a value without a name of its own: $(cat unnamed)"
  sed -n 's/^ *\(-., \)\{0,1\}\(--[a-z-]*\) N\( .*\)\{0,1\}$/\2/p' help >whole
  sed -n 's/^ *\(-., \)\{0,1\}\(--[a-z-]*\) NUMBER\( .*\)\{0,1\}$/\2/p' help >real
  while read -r option; do
    options=$((options + 1))
    for value in -1 1x x1 1e3 1.5 +1 0x10 ' 1' '1 ' 1, 18446744073709551616 99999999999999999999999; do
      # shellcheck disable=SC2086
      refused "$path: $option $value: no whole number from " $path "$option" "$value"
    done
  done <whole
  while read -r option; do
    options=$((options + 1))
    for value in nan inf -inf 1x x 1,5 '1 ' 1e999 -1 --; do
      # shellcheck disable=SC2086
      refused "$path: $option $value: no number from " $path "$option" "$value"
    done
  done <real
done <paths
[ "$options" -ge 19 ] || fail "only $options options take a number"
refused 'conform shard: N 1x: no whole number from ' conform shard campaign.json 1x
refused 'conform shard: N 1.5: no whole number from ' conform shard campaign.json 1.5
finish
