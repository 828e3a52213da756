"""A picture in SVG of lines or rows of dots, on logarithmic scales."""
import html
import math

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 440, 150, 130, 60, 56
GREY = "#d9d9d9"


def number(value):
    """10⁴; ¼ and 16 as they are."""
    exponent = round(math.log10(value))
    if value < 1:
        return f"1/{round(1 / value)}"
    if value >= 10_000 and 10 ** exponent == value:
        return "10" + "".join("⁰¹²³⁴⁵⁶⁷⁸⁹"[int(digit)] for digit in str(exponent))
    return f"{value:g}"


class Scale:
    """From least to greatest over a stretch of the picture; a line at each power of 10, or of 4 where it begins below 1."""

    def __init__(self, least, greatest, begin, end):
        self.low, self.high, self.begin, self.end = math.log(least), math.log(greatest), begin, end
        base = 10 if least >= 1 else 4
        count = round((self.high - self.low) / math.log(base))
        self.ticks = [least * base ** i for i in range(count + 1)]

    def at(self, value):
        return self.begin + (math.log(value) - self.low) / (self.high - self.low) * (self.end - self.begin)


class Chart:
    def __init__(self, title, across, up, x, y=None, rows=None):
        self.parts, self.names = [], []
        self.x = Scale(*x, LEFT, WIDTH - RIGHT)
        self.y = Scale(*y, HEIGHT - BOTTOM, TOP) if y else None
        self.rows = rows
        self.write(LEFT, 26, title, size=17)
        for tick in self.x.ticks:
            self.rule(self.x.at(tick), TOP, self.x.at(tick), HEIGHT - BOTTOM)
            self.write(self.x.at(tick), HEIGHT - BOTTOM + 18, number(tick), anchor="middle")
        self.write((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 14, across, anchor="middle")
        if self.y:
            for tick in self.y.ticks:
                self.rule(LEFT, self.y.at(tick), WIDTH - RIGHT, self.y.at(tick))
                self.write(LEFT - 8, self.y.at(tick) + 4, number(tick), anchor="end")
            self.write(LEFT - 8, TOP - 14, up, anchor="end")

    def write(self, x, y, text, anchor="start", colour="#222222", size=13):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}" font-size="{size}">'
                          f"{html.escape(text)}</text>")

    def rule(self, x1, y1, x2, y2, colour=GREY, width=1):
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" '
                          f'stroke-width="{width}"/>')

    def dot(self, x, y, colour, radius=4):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{colour}" stroke="#ffffff"/>')

    def line(self, points, colour, name, width=2):
        """Named where it ends."""
        at = [(self.x.at(x), self.y.at(y)) for x, y in points]
        self.parts.append('<polyline fill="none" stroke="%s" stroke-width="%g" points="%s"/>' % (
            colour, width, " ".join(f"{x:.1f},{y:.1f}" for x, y in at)))
        for x, y in at:
            self.dot(x, y, colour, 2.5)
        self.names.append([at[-1][1], name, colour])

    def row(self, name, points, note):
        height = (HEIGHT - BOTTOM - TOP) / len(self.rows)
        y = TOP + (self.rows.index(name) + 0.5) * height
        self.rule(LEFT, y, WIDTH - RIGHT, y)
        self.write(LEFT - 8, y + 4, name, anchor="end")
        self.write(WIDTH - RIGHT + 8, y + 4, note, size=12)
        for value, colour in points:
            self.dot(self.x.at(value), y, colour, 5)

    def legend(self, names):
        x = LEFT
        for name, colour in names:
            self.dot(x, 44, colour, 5)
            self.write(x + 9, 48, name)
            x += 30 + 7.5 * len(name)

    def mark(self, x, text):
        self.rule(self.x.at(x), TOP, self.x.at(x), HEIGHT - BOTTOM, "#555555")
        self.write(self.x.at(x) + 4, TOP + 12, text)

    def text(self):
        """The whole picture. Names at the ends of lines stand at least a line apart."""
        self.names.sort()
        for above, below in zip(self.names, self.names[1:]):
            below[0] = max(below[0], above[0] + 15)
        for y, name, colour in self.names:
            self.write(WIDTH - RIGHT + 8, y + 4, name, colour=colour)
        body = "\n".join(self.parts)
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
                f'font-family="sans-serif">\n<!-- by docs/figures/acceleration.py -->\n'
                f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>\n{body}\n</svg>\n')
