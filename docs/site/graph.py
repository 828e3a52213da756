"""A graph as an SVG to click, laid out by Graphviz. Colours come from site.css, by the class of a node."""
import html
import re
import subprocess


class Graph:
    def __init__(self, name, says):
        self.name, self.says = name, says
        self.nodes, self.edges, self.ranks = {}, {}, []

    def node(self, key, label, kind, target, tip=""):
        """A box of a kind that site.css knows, which leads to target."""
        self.nodes.setdefault(key, (label, kind, target, tip or label))

    def edge(self, tail, head):
        if tail in self.nodes and head in self.nodes:
            self.edges[tail, head] = None

    def column(self, keys):
        """These stand in one column, from left to right as they are given."""
        self.ranks.append(list(keys))

    def text(self):
        def quoted(text):
            return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
        lines = ["digraph chain {", 'rankdir=LR; bgcolor=transparent; nodesep=0.09; ranksep=0.7; pad=0.1; newrank=true;',
                 'node [shape=box, fontname="DejaVu Sans", fontsize=11, height=0.26, margin="0.08,0.02", style=rounded];',
                 'edge [arrowsize=0.5];']
        for key, (label, kind, target, tip) in self.nodes.items():
            lines.append(f'{quoted(key)} [label={quoted(label)}, class="{kind} key--{css(key)}", href={quoted(target)}, tooltip={quoted(tip)}];')
        for tail, head in self.edges:
            lines.append(f'{quoted(tail)} -> {quoted(head)} [class="{css(tail)} {css(head)}"];')
        anchors = [f'"rank{i}" [style=invis, label=""];' for i in range(len(self.ranks))]
        lines += anchors + [" -> ".join(f'"rank{i}"' for i in range(len(self.ranks))) + " [style=invis];"] * (len(self.ranks) > 1)
        for i, keys in enumerate(self.ranks):
            lines.append("{rank=same; " + " ".join(quoted(key) for key in [f"rank{i}", *keys] if key == f"rank{i}" or key in self.nodes) + "}")
        return "\n".join([*lines, "}"])

    def svg(self):
        made = subprocess.run(["dot", "-Tsvg"], input=self.text(), check=True, capture_output=True, encoding="utf-8").stdout
        made = made[made.index("<svg"):].replace("&#45;", "-")
        width, height = (float(number) for number in re.search(r'<svg width="([\d.]+)pt" height="([\d.]+)pt"', made).groups())
        made = re.sub(r'<svg [^>]*viewBox="([^"]*)"[^>]*>', rf'<svg class="graph" role="group" aria-label="{html.escape(self.says)}" '
                      rf'width="{width * 4 / 3:.0f}" height="{height * 4 / 3:.0f}" viewBox="\1" xmlns="http://www.w3.org/2000/svg" '
                      'xmlns:xlink="http://www.w3.org/1999/xlink">', made, 1)
        made = re.sub(r"<title>[^<]*</title>\n|<!--.*?-->\n?| (?:fill|stroke)=\"[^\"]*\"| font-family=\"[^\"]*\"", "", made, flags=re.S)
        made = re.sub(r'<g id="node\d+" class="node (\w+) key--([^"]*)">', r'<g class="node \1" data-key="\2">', made)
        made = re.sub(r'<a xlink:href="([^"]*)" xlink:title="([^"]*)">', r'<a href="\1" xlink:title="\2"><title>\2</title>', made)
        return f'<div class="graph-frame" tabindex="0">\n{made}</div>\n'


def css(key):
    return re.sub(r"\W+", "-", key)
