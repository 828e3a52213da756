#!/usr/bin/env python3
"""Random draws in an order that the compiler chooses: a seed then names other cases under another compiler.

The arguments of a call and the operands of an operator are evaluated in any order; what stands between braces, on the
two sides of && || ?: and in declarations one after the other is not. A draw is random.NAME(...), random_.NAME(...),
engine(), a function that is given `random`, or a function of the same file that is made of draws ([&] { ... }).
"""

import re
import sys

DRAW = r"\brandom_?\.\w+\(|\bengine_?\((?=\))|\b\w+\(random\b(?=[,)])"
TOKEN = r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|//[^\n]*|/\*.*?\*/|&&|\|\||[<>=!]=|[(){}\[\];,?:=]|<DRAW>|\n'
CONTROL = re.compile(r"\b(?:if|for|while|switch)(?: constexpr)?\s*$")


def local_draws(text):
    """The names of the lambdas that draw."""
    found = re.findall(r"\bauto (\w+) = \[[^\]]*\](?:\([^)]*\))?\s*\{([^{}]*)\}", text)
    return [name for name, body in found if re.search(DRAW, body)]


def hazards(text):
    """The lines where a second draw stands in one part of an expression."""
    draw = DRAW + "".join(rf"|\b{name}\(" for name in local_draws(text))
    line, at, found = 1, 0, []
    stack = [["{", 0]]  # each bracket that is open: its sort, and how many draws its present part holds

    def drew():
        stack[-1][1] += 1
        if stack[-1][1] == 2:
            found.append(line)

    for match in re.finditer(TOKEN.replace("<DRAW>", draw), text, re.S):
        word, before = match.group(), text[at : match.start()]
        at = match.end()
        if word[0] in "\"'/":
            pass  # a text or a comment
        elif word in "([{":
            stack.append(["control" if word == "(" and CONTROL.search(before) else word, 0])
        elif word in ")]}":
            sort, draws = stack.pop() if len(stack) > 1 else ("{", 0)
            if sort == "control":
                stack[-1][1] = 0
            elif sort == "draw" or (draws > 0 and sort != "{"):
                drew()
        elif word in (";", "&&", "||", "?", ":", "=") or (word == "," and stack[-1][0] == "{"):
            stack[-1][1] = 0
        elif word.endswith(("(", "random")):
            stack.append(["draw", 0])  # it draws where it ends: its own arguments come first
        line += word.count("\n")
    return found


def main():
    bad = False
    for path in sys.argv[1:]:
        with open(path, encoding="utf-8") as file:
            for line in hazards(file.read()):
                print(f"{path}:{line}: two draws whose order is the compiler's; expected each named, or between braces")
                bad = True
    return bad


if __name__ == "__main__":
    sys.exit(main())
