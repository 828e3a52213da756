"""The tests of stores on a PostgreSQL server: `FILE STORE_TESTS [SPECIFICATION]`. Each store of KeptStore is a schema there.
Left out is what a file of SQLite alone has: turned bits."""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "cli"))
import postgresql  # noqa: E402

program = sys.argv[1]
specification = sys.argv[2] if len(sys.argv) > 2 else "~[long]~[#spoiled_files_test]"
if postgresql.programs() is None:
    print("skipped: there is no PostgreSQL server (Debian: postgresql)")
    sys.exit(0)
with postgresql.Server() as server:
    sys.exit(subprocess.run([program, "--warn", "NoTests", "--filenames-as-tags", specification],
                            env={**os.environ, "DURERO_STORE_SERVER": server.uri()}).returncode)
