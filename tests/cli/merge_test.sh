# durero merge: two changes of one scene, and what git makes of them.
page=$(cd "$(dirname "$0")/../.." && pwd)/docs/scene-differences.md  # before the harness goes elsewhere
. "$(dirname "$0")/harness.sh"
sample >base.json
sed 's/"altura":2}/"altura":3}/' base.json >ours.json
sed 's/"radio":1,"material":"red"/"radio":2,"material":"red"/' base.json >theirs.json
sed 's/"altura":2}/"altura":3}/; s/"radio":1,"material":"red"/"radio":2,"material":"red"/' base.json >both.json

run 0 merge base.json ours.json theirs.json -o merged.json
empty out
empty err
run 0 diff merged.json both.json
run 0 edit both.json --script /dev/null -o canonical.json
same merged.json canonical.json
run 0 merge base.json theirs.json ours.json -o merged.json
same merged.json canonical.json

# A conflict: a line each, and nothing is written.
rm merged.json
sed 's/"radio":1,"material":"red"/"radio":3,"material":"red"/' base.json >other.json
run 1 merge base.json other.json theirs.json -o merged.json
is out '{"part":"/elementos/s1","violated":"merge.pre.1","predicate":"∀ p : dom ours ∩ dom theirs ⦁ ours p = theirs p ∨ p ↦ ours p ∈ base ∨ p ↦ theirs p ∈ base","base":{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"red"},"ours":{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":3,"material":"red"},"theirs":{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":2,"material":"red"}}'
absent merged.json
run 0 edit base.json --op 'group g=g elementos=s1' -o grouped.json
run 0 edit base.json --op 'Eliminar_Esfera e=s1' -o removed.json
run 1 merge base.json grouped.json removed.json -o merged.json
is out '{"part":"/groups/g","violated":"group.pre.2","predicate":"elementos? ⊆ elementos","message":"\"s1\" is no element; expected elementos? ⊆ elementos (group.pre.2)","ours":{"elementos":["s1"]}}'
absent merged.json

# An empty base is the empty scene; empty sides are none.
: >empty.json
run 0 merge empty.json ours.json ours.json -o merged.json
run 0 diff merged.json ours.json
run 1 merge empty.json ours.json theirs.json -o none.json
lines out 3
refused 'empty.json:1:1: ' merge base.json empty.json theirs.json -o none.json
refused 'merge: ' merge base.json ours.json theirs.json
refused 'none.stl: ' merge base.json ours.json theirs.json -o none.stl
absent none.json

# In git: two branches that change elements in lines side by side.
export HOME="$PWD" GIT_CONFIG_NOSYSTEM=1 GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@example.org GIT_COMMITTER_NAME=a \
  GIT_COMMITTER_EMAIL=a@example.org
# in_git STATUS ARGUMENT...: runs git, and expects whether it is 0.
in_git() {
  want=$1
  shift
  called="git $*"
  git "$@" >out 2>err </dev/null
  got=$?
  checks=$((checks + 1))
  [ "$got" = "$want" ] || { fail "$called: status $got, expected $want"; sed 's/^/  /' out; }
}
mkdir repository
cd repository || exit 1
in_git 0 init -q -b main .
cp ../base.json scene.json
in_git 0 add scene.json
in_git 0 commit -q -m base
# branch NAME FILE: a branch from main on which the scene is that file.
branch() {
  in_git 0 checkout -q -b "$1" main
  cp "../$2" scene.json
  in_git 0 commit -q -a -m "$1"
}
sed 's/"proporcion":0.5/"proporcion":0.25/' ../base.json >../cone.json
branch cone cone.json
branch sphere theirs.json
branch other-sphere other.json

# git alone finds a conflict in lines that stand side by side.
in_git 0 checkout -q -b alone cone
in_git 1 merge -q sphere
in_git 0 merge --abort

# With the drivers it is none. They are those of the page, with the program that is tested.
mkdir ../bin
ln -s "$durero" ../bin/durero
PATH=$(cd ../bin && pwd):$PATH
sed -n 's|^scenes/\(\*\.json .*\)|\1|p' "$page" >.git/info/attributes
lines .git/info/attributes 1
grep '^git config ' "$page" >../configure
lines ../configure 4
sh ../configure
in_git 0 merge -q -m both sphere
sed 's/"proporcion":0.5/"proporcion":0.25/; s/"radio":1,"material":"red"/"radio":2,"material":"red"/' ../base.json >../both.json
run 0 diff scene.json ../both.json

# A true conflict is refused with its line, and the file stays ours.
cp scene.json ../ours-now.json
in_git 1 merge -q other-sphere
has out '{"part":"/elementos/s1","violated":"merge.pre.1"'
same scene.json ../ours-now.json
in_git 0 ls-files --unmerged
lines out 3
in_git 0 merge --abort

# A scene that both branches add, from nothing.
branch one cone.json
cp ../base.json new.json
in_git 0 add new.json
in_git 0 commit -q -m new
branch two theirs.json
cp ../ours.json new.json
in_git 0 add new.json
in_git 0 commit -q -m new
in_git 1 merge -q one
has out '{"part":"/elementos/c1","violated":"merge.pre.1"'
in_git 0 merge --abort

# git diff and git log print operations, and lines of the canonical text.
in_git 0 diff main sphere -- scene.json
is out 'diff --durero a/scene.json b/scene.json
Cambiar_Radio_Esfera e?=s1 radio?=2'
in_git 0 diff main one
has out 'diff --durero a/new.json b/new.json'
tr -d '\n' <../base.json >scene.json
in_git 0 diff main -- scene.json
lines out 1
in_git 0 log -p -1 --format=%s sphere -- scene.json
has out '-{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"red"}'
has out '+{"id":"s1","tipo":"esfera","centro":[0,0,0],"radio":2,"material":"red"}'

finish
