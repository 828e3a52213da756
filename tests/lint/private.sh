#!/bin/sh
# A header in include/ is read by more than one file of the program, or makes a public header whole. A header of one source
# stands beside that source. Listed here are the headers that only a user of the library needs.
public="accel/names.hpp model/distancias.hpp model/haces.hpp model/auditoria.hpp model/solidos.hpp web/call.hpp"
git grep -E '^#include "durero/' -- include src python | sed 's/^\([^:]*\):#include "durero\/\([^"]*\)".*/\2 \1/' | sort -u |
  awk -v public="$public" '
    BEGIN { count = split(public, name, " "); for (i = 1; i <= count; ++i) listed[name[i]] = 1 }
    { ++users[$1]; user[$1] = $2 }
    END {
      for (header in users) {
        single = users[header] == 1 && user[header] ~ /^src\//
        if (single && !(header in listed)) print "include/durero/" header ":1: only " user[header] " includes it; expected it in src"
        if (!single && header in listed) print "tests/lint/private.sh:1: others than its source include " header "; expected it off the list"
        delete listed[header]
      }
      for (header in listed) print "tests/lint/private.sh:1: nothing includes " header "; expected it off the list"
    }' | sort | { ! grep .; }
