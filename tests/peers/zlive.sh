# The conjectures that ZLive, the animator of CZT, is tested with, asked of this program: the folder DURERO_ZLIVE has its
# files (zlive/src/test/resources/animate_*.tex of CZT). They are read and never kept here.
#
# Each is true by ZLive's own word; one that says `= undefnum` is of a value that there is none of, and false here. What
# this program cannot decide it says. Three are false, and it is right: ⟨0⟩ is no sequence of members of 1‥5, and two
# schemas say of their outputs and after-states what their own equations deny.
durero=$1
[ -n "$DURERO_ZLIVE" ] || { echo "DURERO_ZLIVE names no folder with ZLive's animate_*.tex: skipped"; exit 77; }
[ -d "$DURERO_ZLIVE" ] || { echo "DURERO_ZLIVE: no folder $DURERO_ZLIVE"; exit 1; }
directory=$(mktemp -d) || exit 1
trap 'rm -rf "$directory"' EXIT
failures=0 files=0
: >"$directory/verdicts"

for file in "$DURERO_ZLIVE"/animate_*.tex; do
  [ -e "$file" ] || continue
  files=$((files + 1))
  # A theorem is an environment of CZT, which ISO Z writes as a paragraph; `..` is \upto in its mark-up.
  sed -e 's/\\begin{theorem}{[^}]*}/\\begin{zed}/; s/\\end{theorem}/\\end{zed}/; s/\.\./\\upto /g' "$file" \
    >"$directory/read.tex"
  "$durero" spec check --quiet "$directory/read.tex" >"$directory/out" 2>"$directory/err"
  if [ $? = 2 ] || ! grep -q ': section .* ok' "$directory/out"; then
    failures=$((failures + 1))
    printf 'FAILED: %s cannot be read\n' "$file"
    head -3 "$directory/out" "$directory/err"
    continue
  fi
  grep -E '^[^ ]*:[0-9]+:[0-9]+: conjecture' "$directory/out" | while IFS=: read -r _ line _ verdict; do
    theorem=$(sed -n "${line},$((line + 1))p" "$file")
    case $theorem in *'\end{'*'\begin{'*) theorem=$(sed -n "${line}p" "$file") ;; esac
    case $theorem in
      *'= undefnum'* | *'=undefnum'* | *'\langle 0 \rangle \in \seq_1'* | *"x'==1] \semi A"* | *'\exists_1 A @ out!=16'*) expected=false ;;
      *) expected=true ;;
    esac
    case $verdict in
      *'not tried'*) said=open ;;
      *'is false'*) said=false ;;
      *) said=true ;;
    esac
    printf '%s %s %s:%s\n' "$said" "$expected" "$(basename "$file")" "$line"
  done >>"$directory/verdicts"
done

wrong=$(awk '$1 != "open" && $1 != $2' "$directory/verdicts")
if [ -n "$wrong" ]; then
  failures=$((failures + 1))
  printf 'FAILED: answered, expected, where:\n%s\n' "$wrong"
fi
[ "$files" -gt 0 ] || { echo "no animate_*.tex in $DURERO_ZLIVE"; exit 1; }
awk '{ ++said[$1] } END { printf "%d conjectures: %d true, %d false, %d not tried\n",
       NR, said["true"], said["false"], said["open"] }' "$directory/verdicts"
exit $((failures > 0))
