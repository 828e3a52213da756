"""spec_run_own.py DURERO: thirty-five commands of a session with the program's own text, as a terminal sees them."""
import sys

from spec_run import Terminal

POINT = "⦉x == 0, y == 0, z == {}⦊"
BALL = f"e? = bola; centro? = {POINT.format(5)}; radio? = "
TUBE = f"e? = tubo; centro? = {POINT.format(0)}; radio? = 1; altura? = 2; vector? = "
UP, LONG = POINT.format(1), POINT.format(2)

SESSION = [
    ("show", ["0. Init"]),
    (f"Agregar_Esfera {BALL}1", ["1. Agregar_Esfera", "→  {bola ↦ 1}", "invariant: "]),
    ("show", ["1. Agregar_Esfera"]),
    ("try", ["true   spec/operaciones.tex", "pre Eliminar_Esfera_Total  (here)", "pre Eliminar_Elemento_Total  (here)"]),
    (f"Agregar_Esfera {BALL}1", ["Agregar_Esfera cannot go on here"]),
    (f"why Agregar_Esfera {BALL}1", ["false  e? ∉ elementos  % Agregar_Elemento.pre.1"]),
    (f"Agregar_Esfera_Total {BALL}1", ["2. Agregar_Esfera_Total", "r! = elemento_ya_existe"]),
    (f"Agregar_Esfera_Total e? = tubo; centro? = {UP}; radio? = -(1)", ["3. Agregar_Esfera_Total", "radio_no_positivo"]),
    ("back", ["2. Agregar_Esfera_Total"]),
    (f"Agregar_Cilindro {TUBE}{LONG}", ["Agregar_Cilindro cannot go on here"]),
    (f"Agregar_Cilindro_Total {TUBE}{LONG}", ["3. Agregar_Cilindro_Total", "r! = vector_no_unitario"]),
    (f"Agregar_Cilindro {TUBE}{UP}", ["4. Agregar_Cilindro", "→  {bola ↦ 1, tubo ↦ 1}"]),
    (f"Agregar_Cilindro_Total {TUBE}{UP}", ["5. Agregar_Cilindro_Total", "r! = elemento_ya_existe"]),
    ("Eliminar_Esfera e? = tubo", ["Eliminar_Esfera cannot go on here"]),
    ("Eliminar_Esfera_Total e? = tubo", ["6. Eliminar_Esfera_Total", "r! = tipo_incorrecto"]),
    ("Eliminar_Esfera e? = bola", ["7. Eliminar_Esfera", "→  {tubo ↦ 1}"]),
    ("Eliminar_Esfera_Total e? = bola", ["8. Eliminar_Esfera_Total", "r! = elemento_no_existe"]),
    ("back", ["7. Eliminar_Esfera"]),
    ("back", ["6. Eliminar_Esfera_Total"]),
    ("Eliminar_Esfera", ["7. Eliminar_Esfera"]),
    ("Eliminar_Cilindro e? = tubo", ["8. Eliminar_Cilindro", "→  ∅"]),
    ("Eliminar_Cilindro", ["Eliminar_Cilindro cannot go on here"]),
    (f"Agregar_Plano e? = bola; centro? = {UP}; vector? = {UP}", ["9. Agregar_Plano"]),
    (f"Agregar_Disco e? = tubo; centro? = {UP}; radio? = 3; vector? = {UP}", ["10. Agregar_Disco", "{tubo ↦ 3}"]),
    ("trace", ["0. Init", "4. Agregar_Cilindro", "10. Agregar_Disco"]),
    ("save way.txt", []),
    ("Eliminar_Disco", ["11. Eliminar_Disco"]),
    ("Eliminar_Plano", ["12. Eliminar_Plano"]),
    ("restart", ["0. Init"]),
    ("Agregar_Esfera e? = bola; radio? = 1", ["20 ways:", "2. Agregar_Esfera", "a greater --choices"]),
    ("2", ["1. Agregar_Esfera"]),
    ("back", ["0. Init"]),
    ("replay way.txt", ["11 steps, each as the text says", "10. Agregar_Disco"]),
    ("Agregar_Nada", ["no operation or command Agregar_Nada"]),
    ("9", ["no way 9 is listed"]),
]

terminal = Terminal(sys.argv[1], "--given", "Elemento=bola,tubo")
terminal.expect("0. Init")
terminal.expect("> ")
for command, answers in SESSION:
    terminal.type(command, answers)
terminal.quit(0)
