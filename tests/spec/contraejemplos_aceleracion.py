#!/usr/bin/env python3
"""Counterexamples to the text on acceleration (Ramos, Tema VI), in exact rational arithmetic.
spec/erratas.md cites them.

Each shows what the printed words allow or forbid; where the reading matters, that it does not.
"""
import unittest
from fractions import Fraction


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def along(p, t, v):
    return tuple(a + t * b for a, b in zip(p, v))


def minus(a, b):
    return tuple(p - q for p, q in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def surface(x, y, z):
    return 2 * (x * y + y * z + z * x)


def loop(cells, hit, goes_on, most=50):
    """The cells that a loop looks through: it goes on from a cell where there is no hit, for as long as it is told."""
    visited, at = [], 0
    while len(visited) < most:
        if at < len(cells):
            visited.append(cells[at])
        is_hit = at < len(cells) and cells[at] == hit
        at += 0 if is_hit else 1
        if not goes_on(is_hit, at < len(cells)):
            break
    return visited


class Errata(unittest.TestCase):
    def test_EA01_a_plane_across_a_plane(self):
        """Of the planes across a plane through the origin of the ray, two give a box two areas of projection."""
        box, through = (1, 2, 3), (0, 0, 1)
        areas = set()
        for normal in ((1, 0, 0), (0, 1, 0)):
            self.assertEqual(0, dot(normal, through))
            x, y, z = box
            areas.add(dot(normal, (y * z, z * x, x * y)))
        self.assertEqual({6, 3}, areas)

    def test_EA02_the_distance_of_a_plane_counted_twice(self):
        """With D in S as well, the point at t is not on the plane; and S is no longer one number for all slabs."""
        normal, p, v = (1, 2, 2), (3, 1, 4), (1, 0, 1)

        def at(S, D):
            return along(p, -(S + D) / Fraction(dot(normal, v)), v)
        for D in (5, -7):
            self.assertEqual(0, dot(normal, at(dot(normal, p), D)) + D)
            self.assertNotEqual(0, dot(normal, at(dot(normal, p) + D, D)) + D)

    def test_EA03_of_which_node_the_area_is(self):
        """Over its immediate parent, a box in a box in a box is met more often than the middle one is."""
        root, middle, least = surface(4, 4, 4), surface(2, 2, 2), surface(1, 1, 1)
        self.assertEqual(Fraction(1, 4), Fraction(middle, root))
        self.assertEqual(Fraction(1, 16), Fraction(least, root))
        self.assertEqual(Fraction(least, root), Fraction(middle, root) * Fraction(least, middle))
        self.assertGreater(Fraction(least, middle), Fraction(least, root))

    def test_EA04_a_child_more_is_a_test_more(self):
        """The printed increment leaves out that there is one child more to test."""
        k, old, new = 2, surface(1, 1, 1), surface(1, 1, 2)
        self.assertNotEqual((k + 1) * new - k * old, k * (new - old))
        self.assertEqual((k + 1) * new - k * old, k * (new - old) + new)

    def test_EA05_while_there_is_a_child(self):
        """What is asked never changes, so that the first child is searched for ever and the others never."""
        children, searched = ["first", "second"], []
        while children and len(searched) < 50:
            searched.append(children[0])
        self.assertEqual((50, {"first"}), (len(searched), set(searched)))

    def test_EA06_or_where_and_is_meant(self):
        """With a hit it never ends; while there is none, and a cell, it looks through what it should."""
        row = [0, 1, 2, 3]
        self.assertEqual([0, 1] + 48 * [1], loop(row, 1, lambda is_hit, is_in: is_hit or is_in))
        for hit, expected in ((1, [0, 1]), (None, row)):
            self.assertEqual(expected, loop(row, hit, lambda is_hit, is_in: not is_hit and is_in))

    def test_EA07_a_hit_beyond_the_cell(self):
        """A long element in the first cell is met in the third one, behind a small one that only the second has."""
        cells = {0: {"long": Fraction(5, 2)}, 1: {"long": Fraction(5, 2), "small": Fraction(3, 2)}, 2: {"long": Fraction(5, 2)}}

        def first(accepts):
            for cell, elements in cells.items():
                met = {e: t for e, t in elements.items() if accepts(t, cell)}
                if met:
                    return min(met, key=met.get)
        self.assertEqual("long", first(lambda t, cell: True))
        self.assertEqual("small", first(lambda t, cell: t < cell + 1))

    def test_EA08_a_ray_that_is_centred(self):
        """From the middle of its square the ray meets what it passes by."""
        p, v, middle = (Fraction(1, 10), Fraction(1, 10)), (1, 0), (Fraction(1, 2), Fraction(1, 2))
        square = ((2, Fraction(2, 5)), (3, Fraction(3, 5)))

        def meets(origin):
            return square[0][1] <= origin[1] + 2 * v[1] <= square[1][1]
        self.assertFalse(meets(p))
        self.assertTrue(meets(middle))

    def test_EA09_a_difference_of_weights(self):
        """Less what is let through, the weight of a ray in the second of two glasses is below 0; the product is its share."""
        through = Fraction(3, 5)
        after, share = 1, Fraction(1)
        for _ in range(2):
            after, share = after - through, share * through
        self.assertLess(after, 0)
        self.assertEqual(Fraction(9, 25), share)

    def test_EA10_one_polygon_that_shades(self):
        """From the light at z = 3 one triangle at z = 1 is alone in its list; what lies below it is in its shadow, whether
        the triangle faces the light or, as the back of something open, faces away."""
        light, point, faces = (0, 0, 3), (0, 0, 0), set()
        corners = ((-1, -1, 1), (2, -1, 1), (-1, 2, 1))
        crossing = along(point, Fraction(1, 3), minus(light, point))
        self.assertEqual(1, crossing[2])
        weights = (Fraction(1, 3), Fraction(1, 3), Fraction(1, 3))
        self.assertEqual(crossing, tuple(dot(weights, column) for column in zip(*corners)))
        for a, b, c in (corners, corners[::-1]):
            normal = cross(minus(b, a), minus(c, a))
            faces.add(dot(normal, minus(light, a)) > 0)
        self.assertEqual({True, False}, faces)

    def test_EA11_crossed_or_crossed_in_vain(self):
        """Of a box as its own volume the void area is 0, and yet rays cross it."""
        projected = 2 * 3
        void = projected - projected
        self.assertEqual((0, True), (void, projected > 0))

    def test_EA12_a_label_of_another_year(self):
        """IEEE Computer Graphics and Applications 4(10) is of 1984: volume 1 is 1981's."""
        self.assertEqual(1984, 1981 + 4 - 1)


if __name__ == "__main__":
    unittest.main()
