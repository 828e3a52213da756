#!/bin/sh
# emacs_test.sh CONFIGURATION DURERO: Emacs in batch shows the defect of a text in Unicode. Status 77 where there is no Emacs,
# or no Eglot (of Emacs 29, or elpa-eglot of Debian).
set -eu
command -v emacs >/dev/null || { echo "absent: emacs (emacs-nox and elpa-eglot of Debian)"; exit 77; }
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
for folder in /usr/share/emacs/site-lisp/elpa-src/eglot-*; do [ ! -d "$folder" ] || set -- "$1" "$2" -L "$folder"; done
configuration=$1 program=$2
shift 2
HOME=$tmp emacs -Q --batch "$@" --eval "(require 'eglot)" 2>/dev/null || { echo "absent: Eglot (elpa-eglot of Debian)"; exit 77; }
printf '┌ S\nn : ℕ\n|\nn = nm\n└\n' >"$tmp/unicode.zed8"
cat >"$tmp/look.el" <<'END'
(find-file (getenv "TEXT"))
(let ((eglot-sync-connect 60)) (apply #'eglot (eglot--guess-contact)))
(let ((end (+ (float-time) 60)))
  (while (and (< (float-time) end) (not (flymake-diagnostics)))
    (accept-process-output nil 0.1)
    (flymake-start)))
(dolist (found (flymake-diagnostics))
  (message "%d: %s" (line-number-at-pos (flymake-diagnostic-beg found)) (flymake-diagnostic-text found)))
(kill-emacs 0)
END
HOME=$tmp PATH=${program%/*}:$PATH TEXT=$tmp/unicode.zed8 emacs -Q --batch "$@" -l "$configuration" -l "$tmp/look.el" >"$tmp/said" 2>&1 ||
  { cat "$tmp/said"; echo "emacs: the text is not shown"; exit 1; }
grep -q '^4: .*nm is not declared' "$tmp/said" || { cat "$tmp/said"; echo "emacs: no defect on line 4"; exit 1; }
