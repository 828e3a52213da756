#!/bin/sh
# neovim_test.sh CONFIGURATION DURERO: Neovim, without a window, shows a defect of a text in Unicode and of one in LaTeX, and
# asks nothing about LaTeX without Z. Status 77 where there is no Neovim.
set -eu
command -v nvim >/dev/null || { echo "absent: neovim (neovim of Debian)"; exit 77; }
tmp=$(mktemp -d) && trap 'rm -rf "$tmp"' EXIT
printf '┌ S\nn : ℕ\n|\nn = nm\n└\n' >"$tmp/unicode.zed"
printf '\\documentclass{article}\n\\begin{document}\n\\begin{zed} a == b + 1 \\end{zed}\n\\end{document}\n' >"$tmp/paragraph.tex"
printf '\\documentclass{article}\n\\begin{document}\na == b + 1\n\\end{document}\n' >"$tmp/prose.tex"
cat >"$tmp/look.lua" <<'END'
vim.cmd("luafile " .. vim.env.CONFIGURATION)
vim.cmd("filetype on")
vim.cmd("edit " .. vim.env.TEXT)
local seconds = vim.env.TEXT:find("prose") and 2 or 60
vim.wait(seconds * 1000, function() return #vim.diagnostic.get(0) > 0 end, 50)
for _, found in ipairs(vim.diagnostic.get(0)) do
  io.stdout:write(found.lnum + 1, ":", found.col + 1, ": ", found.message, "\n")
end
vim.cmd("qall!")
END
# sees TEXT LINE: what Neovim shows of a text.
sees() {
  said=$(HOME=$tmp PATH=${2%/*}:$PATH CONFIGURATION=$1 TEXT=$tmp/$3 nvim --headless -u NONE -i NONE -c "luafile $tmp/look.lua")
  [ "$said" = "$4" ] || { echo "neovim: $3 shows '$said'; expected '$4'"; exit 1; }
}
sees "$1" "$2" unicode.zed '4:5: nm is not declared; expected a declared name'
sees "$1" "$2" paragraph.tex '3:18: b is not declared; expected a declared name'
sees "$1" "$2" prose.tex ''
