#!/bin/sh
# Each commit since this rule says what it does where one looks for it: a subject `area: imperative` of 72 characters at
# most without a full stop, and the reason in the body. Merges are not read. A tree without history, as an archive or a
# copy is, has nothing to read, and a shallow clone only what it holds: the rule says so.
LC_ALL=C.UTF-8
export LC_ALL
since='2026-11-25T22:13:09+00:00'  # later commits keep the rule
if ! git rev-parse -q --verify HEAD >/dev/null 2>&1; then
  echo "commits: no history here, so that no commit was read"
  exit 0
fi
[ "$(git rev-parse --is-shallow-repository)" = false ] || echo "commits: a shallow clone, so that only the commits in it were read"
tab=$(printf '\t')
{ git log --no-merges --since="$since" --format='%x01%h%x02%s%x02%b' HEAD | tr '\t\n\001\002' '  \n\t'; echo; } |
  while IFS=$tab read -r commit subject body; do
    [ -n "$commit" ] || continue
    said() { echo "commit $commit: $1: $subject"; }
    [ "${#subject}" -le 72 ] || [ "$(printf %s "$subject" | wc -m)" -le 72 ] || said "a subject of more than 72 characters"
    [ -n "${body# }" ] || said "no reason; expected one in the body"
    area=${subject%%: *}
    [ "$area" != "$subject" ] && printf '%s\n' "$area" | grep -qE '^[A-Za-z0-9_./+-]+((, | and )[A-Za-z0-9_./+-]+)*$' ||
      { said "no area; expected area: imperative"; continue; }
    word=${subject#*: }
    word=$(printf %s "${word%%[ ,:]*}" | tr '[:upper:]' '[:lower:]')
    case $word in
      embed | feed | need | seed | speed | shed | proceed | exceed | succeed | bring | string | ring | bias) ;;
      *ss | *us) ;;
      *ed | *ing | *s | [!a-z]* | the | a | an | no | any | all | what | who | where | as | so | it | each | every)
        said "\"$word\" is no imperative" ;;
    esac
    case $subject in *.) said "a full stop" ;; esac
  done | { ! grep .; }
