# Source it after harness.sh.

# below [COMMAND]: prints the names of its commands, as its help lists them.
below() { "$durero" ${1+"$1"} --help | sed -n 's/^  \([a-z][a-z-]*\)  .*/\1/p'; }

# commands: prints every command, one a line, with the command that it belongs to before it.
commands() {
  for command in $(below); do
    echo "$command"
    below "$command" | sed "s/^/$command /"
  done
}
