# durero man and durero completion: every command and option that --help shows is in each, and each is well made.
sources=$(cd "$(dirname "$0")/../.." && pwd)  # before the harness goes elsewhere
. "$(dirname "$0")/harness.sh"
. "$(dirname "$0")/commands.sh"

run 0 man --directory man1
for shell in bash zsh fish; do
  run 0 completion $shell
  cp out $shell
done
run 0 man
same out man1/durero.1
run 0 man conform run
same out man1/durero-conform-run.1

# What --help shows.
commands >paths
lines paths "$(($(ls man1 | wc -l) - 1))"
options=0
while read -r path; do
  page=man1/durero-$(echo "$path" | tr ' ' -).1
  [ -f "$page" ] || fail "no page of $path"
  name=${path##* }
  for file in bash zsh fish; do has $file "$name"; done
  for section in NAME SYNOPSIS DESCRIPTION OPTIONS EXAMPLES 'SEE ALSO'; do has "$page" ".SH $section"; done
  # shellcheck disable=SC2086  # a path is words
  "$durero" $path --help >help
  called="durero $path --help"
  grep -q '^Commands:' help || has "$page" '.SH EXIT STATUS'
  for option in $(sed -n 's/^ *\(-., \)\{0,1\}--\([a-z-]*\)\( .*\)\{0,1\}$/\2/p' help); do
    options=$((options + 1))
    has "$page" "\\fB\\-\\-$(echo "$option" | sed 's/-/\\-/g')\\fR"
    sed -n "/^    '$path')/,/;;/p" bash | grep -qE -e "[ ']--$option[ ']" || fail "$path: bash knows no --$option"
    grep -qF "__durero_at '\\''$path'\\'''" fish && grep -F "__durero_at '\\''$path'\\'''" fish | grep -qF -e " -l $option " ||
      fail "$path: fish knows no --$option"
    sed -n "/^_durero_$(echo "$path" | tr ' -' __)() {/,/^}/p" zsh | grep -qE -e "--$option(=|\[)" || fail "$path: zsh knows no --$option"
  done
done <paths
[ "$options" -ge 60 ] || fail "only $options options"

# What an example reads of demo/ is there.
sed 's/\\-/-/g; s/\\//g' man1/* | grep -oE 'demo/[A-Za-z0-9._/-]+' | sort -u >examples
[ -s examples ] || fail 'no example reads a file of demo/'
while read -r file; do [ -e "$sources/$file" ] || fail "an example reads $file, which is not there"; done <examples

# Each description begins with a capital and ends without a full stop.
for page in man1/*; do
  checks=$((checks + 1))
  awk '/^\.SH/ { list = /ARGUMENTS|OPTIONS/ } /^\.TP/ { at = NR } list && at && NR == at + 2 && !/^[A-Z].*[^.]$/ { print FILENAME ": " $0; bad = 1 }
    END { exit bad }' "$page" || fail "$page: a description that is none"
done

# Dates: none, or that of SOURCE_DATE_EPOCH.
head -n 1 man1/durero.1 >title
has title '.TH DURERO 1 "" "durero '
SOURCE_DATE_EPOCH=1000000000 "$durero" man >out
head -n 1 out >title
has title '.TH DURERO 1 "2001-09-09" "durero '

# Every command and option of the examples is there.
sed -n '/^\.SH EXAMPLES/,/^\.fi/s/^durero //p' man1/* | sed 's/\\-/-/g; s/\\(rs/\\/g' >examples
[ "$(wc -l <examples)" -ge 25 ] || fail 'no examples'
while read -r first second _; do
  grep -qxF -e "$first" -e "$first $second" paths || fail "an example of no command: $first $second"
done <examples

# What the tools of each kind say.
SOURCE_DATE_EPOCH=1000000000 "$durero" man --directory dated
for page in dated/*; do
  if command -v mandoc >/dev/null; then
    checks=$((checks + 1))
    mandoc -T lint -W warning "$page" >lint 2>&1 || { fail "$page: mandoc"; cat lint; }
  fi
  if command -v groff >/dev/null; then
    checks=$((checks + 1))
    groff -man -ww -z -T utf8 -K utf8 "$page" >lint 2>&1
    [ ! -s lint ] || { fail "$page: groff"; cat lint; }
  fi
done
command -v mandoc >/dev/null || echo 'mandoc is absent: its lint was not asked'
command -v groff >/dev/null || echo 'groff is absent: its warnings were not asked'

# bash completes.
bash -n bash || fail 'bash cannot read it'
: >scene.json
mkdir folder
cat >complete <<'BASH'
. ./bash
compopt() { :; }  # known to bash only while it completes
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_durero
printf '%s\n' "${COMPREPLY[@]}"
BASH
completes() {  # completes EXPECTED WORD...: in bash, the last word to these
  expected=$1
  shift
  called="bash: $*"
  bash complete "$@" | sort >out
  is out "$expected"
}
completes trace durero tr
completes --engine durero trace --en
completes "$("$durero" engines | sed -n '/^$/q; s/^\([a-z][a-z-]*\) .*/\1/p' | sort)" durero trace --engine ''
completes exact durero trace --engine ex
completes exact durero trace scene.json --engine = ex
completes scene.json durero trace sc
completes scene.json durero trace -o sc
completes folder durero conform make f
completes judge durero conform j
completes tiny durero conform make --family tin
completes '' durero trace --threads ''
completes bash durero completion ba
completes --systems durero conform run --sys
completes eval durero spec ev
completes tachyon durero conform run tach

if command -v zsh >/dev/null; then
  checks=$((checks + 1))
  zsh -f -n zsh || fail 'zsh cannot read it'
  # Each line is typed into an interactive zsh, then Tab and Return; the words that it has become, one in brackets.
  cat >typed <<'ZSH'
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell 'PS1= PS2=; autoload -Uz compinit && compinit -u -D; source ./zsh
durero() { print -r -- "called: ${(@)${(@)@/#/[}/%/]}" :end }; print read"y"'
zpty -r shell said '*ready*'
for line; do
  zpty -w -n shell $line$'\t\n'
  zpty -r shell said '*called: *:end*'
  print -r -- ${${said##*called: }%% :end*}
done
zpty -d shell
ZSH
  zsh_completes() {  # zsh_completes EXPECTED LINE
    called="zsh: $2"
    HOME=$directory timeout 60 zsh -f typed "$2" >out 2>err
    empty err
    is out "$1"
  }
  zsh_completes '[trace]' 'durero tra'
  zsh_completes '[trace] [--engine]' 'durero trace --eng'
  zsh_completes '[trace] [--engine] [exact]' 'durero trace --engine ex'
  zsh_completes '[trace] [scene.json]' 'durero trace sc'
  zsh_completes '[trace] [-o] [scene.json]' 'durero trace -o sc'
  zsh_completes '[conform] [judge]' 'durero conform j'
  zsh_completes '[conform] [make] [folder]' 'durero conform make f'
  zsh_completes '[conform] [make] [--family] [tiny]' 'durero conform make --family tin'
  zsh_completes '[spec] [eval]' 'durero spec ev'
  zsh_completes '[conform] [run] [tachyon]' 'durero conform run tach'
else
  echo 'zsh is absent: its completion was not tried'
fi
if command -v fish >/dev/null; then
  fish_completes() {  # fish_completes EXPECTED LINE
    called="fish: $2"
    HOME=$directory fish --no-config -c 'source fish; complete -C "$argv[1]"' "$2" 2>err | cut -f 1 | sort >out
    empty err
    is out "$1"
  }
  fish_completes trace 'durero tra'
  fish_completes --engine 'durero trace --eng'
  fish_completes exact 'durero trace --engine ex'
  fish_completes scene.json 'durero trace sc'
  fish_completes judge 'durero conform j'
  fish_completes tiny 'durero conform make --family tin'
else
  echo 'fish is absent: its completion was not tried'
fi
finish
