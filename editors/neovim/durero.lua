-- Neovim 0.7 or later starts `durero spec lsp` for Z in Unicode, and for LaTeX with a paragraph of Z.
vim.api.nvim_create_autocmd({ "BufRead", "BufNewFile" }, {
  pattern = { "*.zed", "*.zed8", "*.utf8" },
  callback = function() vim.bo.filetype = "z" end,
})

-- Neovim 0.8 has vim.lsp.start, which asks the same server about each file of a folder; before it each file has its own.
local function start(config, buffer)
  if vim.lsp.start then
    vim.lsp.start(config)
  else
    vim.lsp.buf_attach_client(buffer, vim.lsp.start_client(config))
  end
end

local function has_z(buffer)
  local text = table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), "\n")
  for _, paragraph in ipairs({ "z[es]", "schema}", "axdef}", "gendef}", "syntax}" }) do
    if text:find("\\begin{" .. paragraph) then return true end
  end
  return false
end

vim.api.nvim_create_autocmd("FileType", {
  pattern = { "z", "tex", "plaintex" },
  callback = function(event)
    if event.match == "z" or has_z(event.buf) then
      local folder = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(event.buf), ":p:h")
      start({ name = "durero", cmd = { "durero", "spec", "lsp" }, root_dir = folder }, event.buf)
    end
  end,
})
