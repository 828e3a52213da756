;;; durero-z.el --- Z by the language server of Durero -*- lexical-binding: t -*-

;; Eglot, of Emacs 29 or as a package of an earlier one, starts `durero spec lsp'.

;;; Code:

(require 'eglot)

(define-derived-mode durero-z-mode text-mode "Z"
  "Mode for Z text in Unicode mark-up."
  (setq-local comment-start "%"))

(add-to-list 'auto-mode-alist '("\\.\\(utf8\\|zed8?\\)\\'" . durero-z-mode))
(add-to-list 'eglot-server-programs '((durero-z-mode latex-mode tex-mode) . ("durero" "spec" "lsp")))

(provide 'durero-z)
;;; durero-z.el ends here
