#!/bin/sh
# What a command prints goes through durero/io/standard_output.hpp, for which what cannot be printed is an error: nothing
# in src/cli prints past it.
git ls-files src/cli | xargs grep -nE 'std::(cout|cerr|printf|puts|putchar|fputs|fwrite)\b|\bstdout\)|fmt::print\(|write_file\("-"' | { ! grep .; }
