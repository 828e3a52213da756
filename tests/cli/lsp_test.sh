# durero spec lsp, driven by a client (lsp_client.py).
. "$(dirname "$0")/harness.sh"
run 0 spec lsp --help
has out 'Language Server Protocol'
checks=$((checks + 1))
python3 "$(dirname "$0")/lsp.py" "$durero" || fail lsp.py
finish
