"""Both bounds of the upright plate the way one writes them in Python: cvxpy on a uniform mesh.

Lower bound: linear stresses on three-node triangles that may jump across every edge. Upper bound: quadratic velocities on
six-node triangles that may jump at the plate only. Squares of four triangles, the plate along x = 0 down to y = -1, fixed
sides and base. Lengths in plates, stresses in unit weight times length. Prints one JSON line for each program.
"""

import argparse
import json
import time

import cvxpy as cp
import numpy as np
import scipy.sparse as sp

BEHIND, AHEAD, BELOW = 2.0, 5.0, 2.0


def mesh(per_unit):
    """Points, triangles (corners counter-clockwise); nodes on the plate above its tip are doubled, the copy behind."""
    nx, ny = round((BEHIND + AHEAD) * per_unit), round(BELOW * per_unit)
    h = 1.0 / per_unit
    points, index = [], {}

    def point(x, y, behind):
        on_plate = abs(x) < 1e-9 and y > -1.0 + 1e-9
        key = (round(x / h * 2), round(y / h * 2), behind and on_plate)
        if key not in index:
            index[key] = len(points)
            points.append((x, y))
        return index[key]

    triangles = []
    for i in range(nx):
        for j in range(ny):
            x, y = -BEHIND + i * h, -BELOW + j * h
            behind = x + h / 2 < 0
            c = [point(x + a * h, y + b * h, behind) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            m = point(x + h / 2, y + h / 2, behind)
            triangles += [(c[k], c[(k + 1) % 4], m) for k in range(4)]
    return np.array(points), np.array(triangles)


def doubled_area(p):
    (ax, ay), (bx, by) = p[1] - p[0], p[2] - p[0]
    return ax * by - ay * bx


def gradients(p, area2):
    """Gradients of the three linear shape functions."""
    ends = [(p[(k + 1) % 3], p[(k + 2) % 3]) for k in range(3)]
    return [((a[1] - b[1]) / area2, (b[0] - a[0]) / area2) for a, b in ends]


def edges(triangles):
    """For each edge (pair of nodes) the triangles at it with the local indices of its ends."""
    found = {}
    for t, tri in enumerate(triangles):
        for k in range(3):
            a, b = (k + 1) % 3, (k + 2) % 3
            found.setdefault(frozenset((tri[a], tri[b])), []).append((t, a, b))
    return found


def cone(radius, first, second, segments):
    """`radius >= |(first, second)|`, or a pyramid inside."""
    if segments is None:
        return [cp.SOC(radius, cp.vstack([first, second]), axis=0)]
    half = np.pi / segments
    return [
        radius * np.cos(half) >= np.cos(2 * half * k) * first + np.sin(2 * half * k) * second
        for k in range(segments)
    ]


def lower(points, triangles, phi, delta, segments):
    count = len(triangles)
    stress = cp.Variable((9 * count,))  # xx, yy, xy at each corner
    rows, cols, values, right = [], [], [], []

    def add(terms, value):
        for col, coefficient in terms:
            rows.append(len(right))
            cols.append(col)
            values.append(coefficient)
        right.append(value)

    for t, tri in enumerate(triangles):
        p = points[tri]
        area2 = doubled_area(p)
        g = gradients(p, area2)
        at = lambda k, c: 9 * t + 3 * k + c
        add([(at(k, 0), g[k][0]) for k in range(3)] + [(at(k, 2), g[k][1]) for k in range(3)], 0.0)
        add([(at(k, 2), g[k][0]) for k in range(3)] + [(at(k, 1), g[k][1]) for k in range(3)], 1.0)
    force_terms, constraints = np.zeros(9 * count), []
    tan = np.tan(np.radians(delta))
    face = [[], []]
    for key, sides in edges(triangles).items():
        t, a, b = sides[0]
        p, q = points[triangles[t][a]], points[triangles[t][b]]
        length = np.hypot(*(q - p))
        n = np.array([q[1] - p[1], p[0] - q[0]]) / length
        for local in (a, b):
            at = 9 * t + 3 * local
            traction = [[(at, n[0]), (at + 2, n[1])], [(at + 2, n[0]), (at + 1, n[1])]]
            if len(sides) == 2:
                other, c, d = sides[1]
                node = triangles[t][local]
                there = c if triangles[other][c] == node else d
                o = 9 * other + 3 * there
                minus = [[(o, -n[0]), (o + 2, -n[1])], [(o + 2, -n[0]), (o + 1, -n[1])]]
                for i in range(2):
                    add(traction[i] + minus[i], 0.0)
            elif abs(p[1]) < 1e-9 and abs(q[1]) < 1e-9:
                for i in range(2):
                    add(traction[i], 0.0)
            elif abs(p[0]) < 1e-9 and abs(q[0]) < 1e-9 and min(p[1], q[1]) > -1 - 1e-9:
                face[0].append(at)
                face[1].append(at + 2)
                force_terms[at] += n[0] * length / 2
                force_terms[at + 2] += n[1] * length / 2
    matrix = sp.csr_matrix((values, (rows, cols)), shape=(len(right), 9 * count))
    constraints.append(matrix @ stress == np.array(right))
    xx, yy, xy = stress[0::3], stress[1::3], stress[2::3]
    sin = np.sin(np.radians(phi))
    constraints += cone(-sin * (xx + yy) / 2, (xx - yy) / 2, xy, segments)
    normal, shear = stress[face[0]], stress[face[1]]
    constraints += [shear <= -tan * normal, -shear <= -tan * normal]
    # Force of the structure on the soil: tractions that the soil carries away through the faces.
    return cp.Problem(cp.Maximize(force_terms @ stress), constraints), count


def upper(points, triangles, phi, delta, segments):
    middles = {key: len(points) + i for i, key in enumerate(edges(triangles))}
    count = len(points) + len(middles)
    vx, vy = cp.Variable(count), cp.Variable(count)
    middle = lambda tri, k: middles[frozenset((tri[(k + 1) % 3], tri[(k + 2) % 3]))]
    nodes = [list(tri) + [middle(tri, k) for k in range(3)] for tri in triangles]
    gx, gy = ([], [], []), ([], [], [])
    gravity = np.zeros(count)
    for t, tri in enumerate(triangles):
        p = points[tri]
        area2 = doubled_area(p)
        g = gradients(p, area2)
        for k in range(3):
            row = 3 * t + k
            terms = [(nodes[t][k], 2 * np.array(g[k]))]
            terms += [(nodes[t][3 + (3 - k - i)], 2 * np.array(g[i])) for i in range(3) if i != k]
            for node, value in terms:
                for store, component in ((gx, value[0]), (gy, value[1])):
                    store[0].append(row)
                    store[1].append(node)
                    store[2].append(component)
        for node in nodes[t]:
            gravity[node] += area2 / 12
    shape = (3 * len(triangles), count)
    dx, dy = (sp.csr_matrix((s[2], (s[0], s[1])), shape=shape) for s in (gx, gy))
    sin, tan = np.sin(np.radians(phi)), np.tan(np.radians(delta))
    volume, difference, shear = dx @ vx + dy @ vy, dx @ vx - dy @ vy, dy @ vx + dx @ vy
    constraints = cone(volume / sin, difference, shear, segments)
    fixed = set()
    for key, sides in edges(triangles).items():
        if len(sides) == 2:
            continue
        t, a, b = sides[0]
        p, q = points[triangles[t][a]], points[triangles[t][b]]
        three = [triangles[t][a], triangles[t][b], middles[key]]
        if abs(p[1]) < 1e-9 and abs(q[1]) < 1e-9:
            continue
        if abs(p[0]) < 1e-9 and abs(q[0]) < 1e-9 and min(p[1], q[1]) > -1 - 1e-9:
            side = 1.0 if points[triangles[t][3 - a - b]][0] > 0 else -1.0
            opening, slip = side * (vx[three] - 1.0), vy[three]
            constraints += [opening >= tan * slip, opening >= -tan * slip]
        else:
            fixed.update(three)
    fixed = sorted(fixed)
    constraints += [vx[fixed] == 0, vy[fixed] == 0]
    return cp.Problem(cp.Minimize(gravity @ vy), constraints), len(triangles)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--per-unit", type=int, default=8, help="squares along the plate")
    parser.add_argument("--phi", type=float, default=40.0)
    parser.add_argument("--delta", type=float, default=25.0)
    parser.add_argument("--segments", type=int, help="pyramids with so many sides instead of cones")
    parser.add_argument("--solver", default="CLARABEL", choices=["CLARABEL", "HIGHS"])
    parser.add_argument("--seconds", type=float, default=300.0)
    args = parser.parse_args()
    for name, program in (("lower", lower), ("upper", upper)):
        start = time.perf_counter()
        problem, elements = program(*mesh(args.per_unit), args.phi, args.delta, args.segments)
        options = {"CLARABEL": {"time_limit": args.seconds}, "HIGHS": {"time_limit": args.seconds}}[args.solver]
        try:
            problem.solve(solver=args.solver, **options)
            status, value = problem.status, problem.value
        except cp.SolverError as error:
            status, value = str(error).splitlines()[0], None
        line = {"bound": name, "elements": elements, "status": status, "value": value}
        print(json.dumps(line | {"seconds": time.perf_counter() - start}), flush=True)


if __name__ == "__main__":
    main()
