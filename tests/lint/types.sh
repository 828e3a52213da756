#!/bin/sh
# The name of a type stands once in the program, and is a noun: types.py tells which does not.
git ls-files 'include/*.hpp' 'include/*.h' 'src/*.[ch]pp' | xargs python3 "$(dirname "$0")/types.py"
