#!/usr/bin/env python3
"""Counterexamples to the printed specification, one a defect, in exact rational arithmetic. spec/erratas.md cites them.

Each shows what the printed predicates allow or forbid; where the correction matters, that it does not.
"""
import unittest
from collections import namedtuple
from fractions import Fraction
from itertools import product

from zcheck_test import HEAD, checked

P = namedtuple("P", "x y z")  # Punto and Vector alike: see E28
O, Z = P(0, 0, 0), P(0, 0, 1)


def minus(a, b):
    return P(*(p - q for p, q in zip(a, b)))


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def along(p, t, v):
    return P(*(a + t * b for a, b in zip(p, v)))


def foot_distance(w, centre, axis):
    """The squared distance of w from the foot at its advance, and the advance."""
    s = dot(minus(w, centre), axis)
    return dot(*[minus(w, along(centre, s, axis))] * 2), s


def printed_invariant(s):
    """Escena as printed, with partial functions (E20)."""
    elements = set(s["tipo"])
    return elements == set(s["centro"]) and set(s["radio"]) <= elements and set(s["vector"]) <= elements


def corrected_invariant(s):
    has = {"radio": ("esfera", "cilindro"), "vector": ("cilindro", "cono"), "altura": ("cilindro", "cono"),
           "proporcion": ("cono",)}
    return set(s["tipo"]) == set(s["centro"]) and all(
        set(s[a]) == {e for e, t in s["tipo"].items() if t in types} for a, types in has.items())


def scene(**given):
    return {a: given.get(a, {}) for a in ("tipo", "centro", "radio", "vector", "altura", "proporcion")}


CYLINDER = scene(tipo={"c": "cilindro"}, centro={"c": O}, radio={"c": 1}, vector={"c": Z}, altura={"c": 2})


class Errata(unittest.TestCase):
    def test_E03_the_eye_is_at_distance_zero_from_itself(self):
        self.assertFalse(dot(minus(O, O), minus(O, O)) > 0)

    def test_E05_no_answer_is_two_answers(self):
        general = ("elemento_agregado", "elemento_eliminado")
        own = ("esfera_agregada", "cilindro_agregado", "cono_agregado", "esfera_eliminada", "cilindro_eliminado",
               "cono_eliminado")
        answers = general + own + ("puntos_agregados",)
        for included, including in product(general, own):
            self.assertEqual([], [r for r in answers if r == included and r == including])

    def test_E06_adding_a_sphere_may_move_a_cylinder(self):
        after = scene(tipo={"c": "cilindro", "s": "esfera"}, centro={"c": O, "s": O}, radio={"c": 1, "s": 1},
                      vector={"c": P(1, 0, 0)}, altura={"c": 99})
        for attribute, value in (("tipo", "esfera"), ("centro", O), ("radio", 1)):
            self.assertEqual(CYLINDER[attribute] | {"s": value}, after[attribute])
        self.assertTrue(printed_invariant(after) and corrected_invariant(after))
        self.assertNotEqual((CYLINDER["vector"], CYLINDER["altura"]), (after["vector"], after["altura"]))

    def test_E07_a_cylinder_may_have_no_radius_and_no_height(self):
        bare = scene(tipo={"c": "cilindro"}, centro={"c": O})
        self.assertTrue(printed_invariant(bare))
        self.assertFalse(corrected_invariant(bare))

    def test_E09_a_cylinder_removed_as_a_sphere_leaves_its_axis_and_height(self):
        after = scene(vector=CYLINDER["vector"], altura=CYLINDER["altura"])  # centre, radius and type subtracted
        self.assertFalse(printed_invariant(after))
        leftover = scene(altura=CYLINDER["altura"])  # the same for a cone's height and proportion
        self.assertTrue(printed_invariant(leftover))
        self.assertFalse(corrected_invariant(leftover))

    def test_E10_the_printed_cylinder_has_the_radius_sqrt_of_radio(self):
        distance2, s = foot_distance(P(4, 0, 1), O, Z)
        self.assertEqual((16, 1), (distance2, s))
        self.assertTrue(distance2 - 4**2 == 0)  # on the cylinder of radius 4
        self.assertFalse(distance2 - 4 == 0)  # not on the printed one

    def test_E11_the_printed_cone_is_a_plane(self):
        prop, h = Fraction(1, 2), 2
        for x, y in product((-1000, 0, 7), repeat=2):
            distance2, s = foot_distance(P(x, y, h), O, Z)
            self.assertTrue(prop * s - h * prop == 0)
            self.assertEqual((x, y) == (0, 0), distance2 - (prop * s - h * prop) ** 2 == 0)
        distance2, s = foot_distance(P(1, 0, 0), O, Z)  # the rim of the base is on the cone, not on the plane
        self.assertTrue(distance2 - (prop * s - h * prop) ** 2 == 0)
        self.assertFalse(prop * s - h * prop == 0)

    def test_E12_a_longer_axis_is_another_surface_and_a_null_direction_no_ray(self):
        self.assertEqual((1, 0), foot_distance(P(1, 0, 0), O, Z))
        self.assertEqual(9, foot_distance(P(0, 0, 1), O, P(0, 0, 2))[0])  # a point of the axis, 3 away from its foot
        self.assertEqual({O}, {along(O, t, P(0, 0, 0)) for t in (1, 2, 3)})

    def test_E13_another_function_satisfies_the_printed_axiom(self):
        sets = [frozenset(s) for s in ((), (1,), (2,), (1, 2))]
        wrong = {(a, b): frozenset() for a in sets for b in sets}
        self.assertTrue(any(wrong[a, b] == a & b for a, b in wrong))
        self.assertFalse(all(wrong[a, b] == a & b for a, b in wrong))

    def test_E14_every_point_is_the_least_of_its_own_singleton(self):
        points = {P(0, 0, 1), P(0, 0, 3)}
        distance2 = {w: dot(w, w) for w in points}
        self.assertEqual(points, {w for w in points if distance2[w] == min({distance2[w]})})
        self.assertEqual({P(0, 0, 1)}, {w for w in points if all(distance2[w] <= distance2[v] for v in points)})

    def test_E16_two_spheres_touch_in_a_point_of_both(self):
        point = P(0, 0, 1)
        self.assertEqual([1, 1], [dot(minus(point, c), minus(point, c)) for c in (O, P(0, 0, 2))])

    def test_E19_no_element_can_be_removed_by_restriction(self):
        tipo, gone = {"a": "esfera", "b": "esfera"}, {"a"}
        restricted = {e for e in tipo if e in gone}
        self.assertNotEqual(set(tipo) - gone, restricted)  # elementos' and dom de_que_tipo' must be one set
        self.assertEqual(set(tipo) - gone, {e for e in tipo if e not in gone})

    def test_E20_a_total_function_leaves_no_name_to_add(self):
        every = {"a", "b"}
        total = {e: "esfera" for e in every}
        self.assertEqual(set(), {e for e in every if e not in set(total)})

    def test_E21_the_printed_term_is_zero_at_the_far_end(self):
        prop, h = Fraction(1, 2), 2
        self.assertEqual((0, -1), (prop * h - h * prop, prop * 0 - h * prop))  # apex at s = h, radius 1 at the base

    def test_E22_accumulating_spheres_have_no_first(self):
        for n in range(1, 200):  # the sphere of radius 1 about z = 2 + 1/n begins at 1 + 1/n
            t = 1 + Fraction(1, n)
            self.assertEqual(1, (t - (2 + Fraction(1, n))) ** 2)
            self.assertLess(1 + Fraction(1, n + 1), t)
            self.assertLess(1, t)

    def test_E23_a_sphere_from_its_centre_has_many_nearest_points(self):
        points = [P(1, 0, 0), P(0, 1, 0), P(Fraction(3, 5), Fraction(4, 5), 0)]
        self.assertEqual({1}, {dot(w, w) for w in points})

    def test_E24_a_sphere_may_have_an_axis(self):
        odd = scene(tipo={"s": "esfera"}, centro={"s": O}, radio={"s": 1}, vector={"s": Z})
        self.assertTrue(printed_invariant(odd))
        self.assertFalse(corrected_invariant(odd))

    def test_E28_a_point_passes_for_a_vector(self):
        text = HEAD
        for name in ("Punto", "Vector"):
            text += f"\\begin{{schema}}{{{name}}} x, y, z : \\num \\end{{schema}}\n"
        text += r"\begin{axdef} f : Vector \fun \num \where \forall p : Punto @ f(p) = 0 \end{axdef}" + "\n"
        self.assertEqual((0, []), checked(text))

    def test_E30_a_sphere_behind_the_light_is_met_by_the_shadow_ray(self):
        light, centre = P(0, 0, 4), P(0, 0, 9)  # the shaded point is O, the ray's direction light - O
        t = Fraction(2)  # beyond the light, which is at t = 1
        self.assertEqual(1, dot(minus(along(O, t, light), centre), minus(along(O, t, light), centre)))
        self.assertFalse(any(dot(minus(along(O, u, light), centre), minus(along(O, u, light), centre)) <= 1
                             for u in (Fraction(k, 64) for k in range(1, 65))))

    def test_E31_one_object_is_met_in_two_points(self):
        met = [t for t in (3, 5) if dot(minus(along(O, t, Z), P(0, 0, 4)), minus(along(O, t, Z), P(0, 0, 4))) == 1]
        self.assertEqual([3, 5], met)

    def test_E32_a_surface_turned_away_has_negative_brightness(self):
        self.assertEqual(-1, dot(Z, P(0, 0, -1)))

    def test_E34_an_order_of_the_integers_leaves_one_half_out(self):
        def above(a, b):  # > as the toolkit has it, and nothing more
            return a.denominator == b.denominator == 1 and a > b
        integers, half = [Fraction(n) for n in range(-9, 10)], Fraction(1, 2)
        self.assertTrue(all(above(a, b) == (b < a) for a in integers for b in integers))
        self.assertTrue(0 <= half and half != 0)
        self.assertFalse(above(half, Fraction(0)))

    def test_E35_an_addition_of_integers_may_have_two_sums_elsewhere_or_none(self):
        def sums(a, b, elsewhere):
            return {a + b} if a.denominator == b.denominator == 1 else elsewhere
        integers, half = [Fraction(n) for n in range(-9, 10)], Fraction(1, 2)
        for elsewhere in (set(), {Fraction(0), Fraction(1)}):
            self.assertTrue(all(sums(a, b, elsewhere) == {a + b} for a in integers for b in integers))
            self.assertNotEqual(1, len(sums(half, half, elsewhere)))

    def test_E33_a_forgotten_height_makes_a_name_unusable(self):
        before = scene(altura={"c": 2})  # what removing a cone or cylinder by the wrong schema leaves (E09)
        self.assertTrue(printed_invariant(before) and "c" not in before["tipo"])
        joined = set(before["altura"].items()) | {("c", 3)}
        self.assertGreater(len(joined), len(dict(joined)))  # two heights of c: no function, so no after-state


if __name__ == "__main__":
    unittest.main()
