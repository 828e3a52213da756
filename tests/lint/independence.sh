#!/bin/sh
# What is held against something else does not share its code with it, or a fault in one would not be seen by the other.
# apart FOLDERS USED WHY: no file of the folders includes a header that matches.
apart() {
  # shellcheck disable=SC2086
  git ls-files $1 | xargs grep -nE "^#include \"$2" 2>/dev/null | sed "s/\$/  <- $3/"
}
{
  apart 'include/durero/model src/model' 'durero/(scene|surface|trace|oracle|spec|zed)/' 'the model is the text, and nothing else'
  apart 'include/durero/zed src/zed' 'durero/(model|scene|surface|trace|oracle|spec)/' 'the evaluated text knows no model of itself'
  apart 'include/durero/spec src/spec' 'durero/(surface|trace|oracle)/' 'the text does not know what it judges'
  apart 'include/durero/oracle src/oracle' 'durero/(surface|trace|spec|zed)/' 'an oracle does not know what it judges'
  apart 'include/durero/written src/written include/durero/algebra src/algebra' 'durero/(surface|trace)/' \
    'what a surface is, its text says alone'
  apart 'tests/conform/reference.hpp' 'durero/(model/(puntos|interseccion)|surface|trace|oracle)' "the tests' reference stands alone"
} | { ! grep .; }
