#!/bin/sh
# The name of a type stands once in the program, and is a noun: type_names.py tells which does not.
git ls-files 'include/*.hpp' 'include/*.h' 'src/*.[ch]pp' | xargs python3 "$(dirname "$0")/type_names.py"
