#!/usr/bin/env python3
"""Counterexamples to the lectures on realism and ray tracing, in exact rational arithmetic. spec/erratas.md cites them.

Each shows what the printed words allow or forbid; where the reading matters, that it does not.
"""
import unittest
from fractions import Fraction

from zcheck_test import HEAD, checked


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def minus(a, b):
    return tuple(p - q for p, q in zip(a, b))


def mirrored(v, n):
    """v beside its mirror image, for a unit normal."""
    return tuple(2 * dot(v, n) * a - b for a, b in zip(n, v))


UP = (0, 0, 1)
SLANTED = (Fraction(3, 5), 0, Fraction(4, 5))
OTHER = (Fraction(2, 3), Fraction(1, 3), Fraction(2, 3))


class Errata(unittest.TestCase):
    def test_ER01_two_letters_one_height(self):
        """The height is f_h, and d_u the derivative of f_t, which nothing defines: any normal fits."""
        height = {Fraction(k, 4): Fraction(k * k) for k in range(5)}
        flat = dict.fromkeys(height, Fraction(0))

        def slope(f, u, step=Fraction(1, 4)):
            return (f[u + step] - f[u - step]) / (2 * step)
        self.assertNotEqual(slope(height, Fraction(1, 2)), slope(flat, Fraction(1, 2)))

    def test_ER02_which_vector_is_mirrored(self):
        """The mirrored v dotted with v is no highlight: it has no light in it. With l it is that of the mirrored l."""
        for light in (UP, SLANTED):
            self.assertEqual(Fraction(7, 25), dot(mirrored(SLANTED, UP), SLANTED))
            self.assertEqual(dot(mirrored(light, UP), OTHER), dot(light, mirrored(OTHER, UP)))

    def test_ER03_a_highlight_behind_the_surface(self):
        """Without the factor, a light below the surface makes a highlight above it."""
        light = (Fraction(4, 5), 0, Fraction(-3, 5))
        seen_from = (Fraction(-12, 13), 0, Fraction(5, 13))
        self.assertLess(dot(UP, light), 0)
        self.assertGreater(dot(UP, seen_from), 0)
        self.assertGreater(dot(mirrored(light, UP), seen_from), 0)

    def test_ER04_the_mirror_once_a_light(self):
        """Inside the loop the mirror counts once for each light that is seen: with none it is black."""
        def printed(seen, mirror):
            return sum(mirror for _ in range(seen))
        self.assertEqual([0, 5, 15], [printed(seen, 5) for seen in (0, 1, 3)])

    def test_ER05_ambient_light_dies_in_shadow(self):
        """k_a C stands inside the sum: two lights count it twice, and in shadow nothing is left of it."""
        def printed(visible):
            return sum(v * Fraction(1, 5) for v in visible)
        self.assertEqual([0, Fraction(1, 5), Fraction(2, 5)], [printed(v) for v in ((0, 0), (1, 0), (1, 1))])

    def test_ER06_a_plane_shadows_itself(self):
        """The depth of a texel is that of one point of it: a point of the same plane beside it is farther, and dark."""
        light = (0, 0, 4)

        def squared_distance(q):
            return dot(minus(q, light), minus(q, light))
        centre, beside = (1, 0, 0), (Fraction(9, 8), 0, 0)  # both in the texel from 1/2 to 3/2
        self.assertLess(squared_distance(centre), squared_distance(beside))
        # Nothing stands between: of the plane z = 0 the segment to the light has its end alone.
        self.assertEqual([0], [t for t in (Fraction(k, 8) for k in range(9)) if 4 * t == 0])

    def test_ER07_no_point_is_a_number(self):
        """O ⊆ ℝ, and o + t v ∈ O: the checker refuses the membership, as a point has three components."""
        reals = HEAD + "%%Zchar \\real U+211D\n\\begin{axdef}\n  \\real : \\power \\arithmos\n\\end{axdef}\n"
        point = "\\begin{schema}{Punto}\n  x, y, z : \\real\n\\end{schema}\n"
        printed = reals + point + "\\begin{zed}\n  \\vdash? \\forall O : \\power \\real; w : Punto @ w \\in O\n\\end{zed}\n"
        meant = printed.replace("O : \\power \\real", "O : \\power Punto")
        self.assertEqual((0, []), checked(meant))
        status, lines = checked(printed)
        self.assertNotEqual(0, status)
        self.assertEqual(1, len(lines), lines)

    def test_ER08_a_disc_without_its_rim(self):
        """In its plane a ray comes as near to the disc as one likes, and nothing is the first point; with its rim, one is.

        And the plane "that contains the triangle", through v0: the problem has no triangle.
        """
        def on_disc(x, closed):
            return x * x <= 1 if closed else x * x < 1
        for k in range(1, 40):  # from -2 along the x axis: whatever point is on the open disc, one before it is too
            first = -1 + Fraction(1, 2 ** k)
            self.assertTrue(on_disc(first, False) and on_disc((first - 1) / 2, False))
        self.assertTrue(on_disc(-1, True) and not on_disc(-1 - Fraction(1, 2 ** 40), True))

    def test_ER09_a_power_of_zero(self):
        """With e = 0 the highlight is one everywhere, behind the mirror too, where zero to the zero is one; a negative e
        has no value there."""
        self.assertEqual(1, Fraction(0) ** 0)
        with self.assertRaises(ZeroDivisionError):
            Fraction(0) ** -1

    def test_ER10_sphere_tracing_from_a_surface(self):
        """Of a ray that leaves the surface it starts on, the loop ends at once and says that it is met."""
        def printed(origin, step, epsilon):
            p, d, steps = origin, Fraction(0), 0
            while True:
                p = tuple(a + d * b for a, b in zip(p, step))
                d = sum(abs(a) for a in p) - 1  # of the octahedron, whose faces are flat: a bound on the distance
                steps += 1
                if abs(d) <= epsilon or steps == 50:
                    return abs(d) <= epsilon, steps
        self.assertEqual((True, 1), printed((0, 0, 1), UP, Fraction(1, 1000)))
        # Beyond the origin the ray has no point of the surface.
        self.assertTrue(all(abs(1 + t) > 1 for t in (Fraction(1, 1000), 1, 50)))

    def test_ER11_the_group_of_the_hexagon(self):
        """Sixfold turns and mirrors of two kinds, in that order: 6mm. No plane group has two mirrors before a turn."""
        def times(a, b):
            return tuple(tuple(sum(a[i][k] * b[k][j] for k in range(2)) for j in range(2)) for i in range(2))
        turn, mirror = ((1, -1), (1, 0)), ((0, 1), (1, 0))
        group = {((1, 0), (0, 1))}
        while True:
            more = group | {times(a, b) for a in group for b in (turn, mirror)}
            if more == group:
                break
            group = more
        self.assertEqual(12, len(group))
        mirrors = [a for a in group if a[0][0] * a[1][1] - a[0][1] * a[1][0] == -1]
        kinds = {frozenset(times(times(g, m), h) for g in group for h in group if times(g, h) == ((1, 0), (0, 1)))
                 for m in mirrors}
        self.assertEqual([3, 3], sorted(map(len, kinds)))
        plane_groups = "p1 p2 pm pg cm pmm pmg pgg cmm p4 p4m p4g p3 p3m1 p31m p6 p6m".split()
        self.assertEqual(17, len(plane_groups))
        self.assertNotIn("pmm6", plane_groups)

    def test_ER12_a_normal_on_the_far_side(self):
        """With i·n < 0 the printed t goes back to the side that it came from: its sign is that of i·n."""
        i, ratio = SLANTED, Fraction(4, 3)
        cosine, beyond = Fraction(4, 5), Fraction(3, 5)  # 1 - ratio² (1 - cosine²) = 9/25
        self.assertEqual(beyond ** 2, 1 - ratio ** 2 * (1 - cosine ** 2))

        def printed(n):
            c = dot(i, n)
            return tuple((ratio * c - beyond) * a - ratio * b for a, b in zip(n, i))
        self.assertEqual(-beyond, dot(printed(UP), UP))
        down = (0, 0, -1)
        self.assertGreater(dot(printed(down), UP), 0)  # on the side of i: no refraction

    def test_ER13_irradiance_has_no_direction(self):
        """Two surroundings of one irradiance, light from the left or from the right: a mirror shows them apart."""
        left, right = (Fraction(-3, 5), 0, Fraction(4, 5)), SLANTED

        def irradiance(radiance):
            return sum(value * max(0, dot(way, UP)) for way, value in radiance.items())
        one, other = {left: 1, right: 0}, {left: 0, right: 1}
        self.assertEqual(irradiance(one), irradiance(other))
        self.assertNotEqual(one[mirrored(left, UP)], other[mirrored(left, UP)])

    def test_ER14_another_order_that_is_none(self):
        """Neither order in which two sheets can be drawn over what is behind gives the second of the printed sums."""
        x, y, z = Fraction(8, 10), Fraction(2, 10), Fraction(1, 10)
        share = {1: Fraction(1, 2), 2: Fraction(1, 4)}
        own = {1: y, 2: z}

        def drawn(order):
            colour = x
            for sheet in order:
                colour = own[sheet] + share[sheet] * colour
            return colour
        self.assertEqual(Fraction(25, 100), z + share[2] * y + share[1] * share[2] * x)
        self.assertEqual(Fraction(525, 1000), z + share[1] * x + share[2] * share[1] * y)
        self.assertEqual([Fraction(25, 100), Fraction(35, 100)], [drawn((1, 2)), drawn((2, 1))])


if __name__ == "__main__":
    unittest.main()
