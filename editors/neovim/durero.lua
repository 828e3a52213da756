-- Neovim 0.8 or later starts `durero spec lsp` for Z in Unicode, and for LaTeX with a paragraph of Z.
vim.filetype.add({ extension = { zed = "z", utf8 = "z" } })

vim.api.nvim_create_autocmd("FileType", {
  pattern = { "z", "tex", "plaintex" },
  callback = function(event)
    local text = table.concat(vim.api.nvim_buf_get_lines(event.buf, 0, -1, false), "\n")
    if event.match ~= "z" and not text:find("\\begin{z[es]") and not text:find("\\begin{schema}") and
        not text:find("\\begin{axdef}") and not text:find("\\begin{gendef}") then
      return
    end
    vim.lsp.start({ name = "durero", cmd = { "durero", "spec", "lsp" }, root_dir = vim.fs.dirname(event.file) })
  end,
})
