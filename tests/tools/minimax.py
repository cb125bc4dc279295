"""The constants of kin-runtime/src/math/{sine,remainder,angle}.rs, computed here from their definitions.

Needs mpmath. Prints the polynomials, the three parts of a quarter turn and the bits of 2/pi as Rust writes them.
Polynomials are minimax: Remez's exchange algorithm (E. Ya. Remez, 1934), for the relative error of the whole function.
"""

from mpmath import atan, cos, floor, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.prec = 400


def remez(function, weight, high, count):
    """Coefficients c with |weight(z) (function(z) - sum c_k z^k)| least on (0, high], and that error."""
    grid = [high * (1 - cos(pi * (2 * i + 1) / 1600)) / 2 for i in range(800)]
    values, weights = [function(z) for z in grid], [weight(z) for z in grid]
    nodes = [high * (1 - cos(pi * (i + mpf(1) / 2) / (count + 1))) / 2 for i in range(count + 1)]
    for _ in range(12):
        rows = matrix(count + 1, count + 1)
        right = matrix(count + 1, 1)
        for i, z in enumerate(nodes):
            for k in range(count):
                rows[i, k] = z**k
            rows[i, count] = (-1) ** i / weight(z)
            right[i] = function(z)
        solution = lu_solve(rows, right)
        found = [solution[k] for k in range(count)]
        errors = []
        for z, value, scale in zip(grid, values, weights):
            sum_ = mpf(0)
            for c in reversed(found):
                sum_ = sum_ * z + c
            errors.append(scale * (value - sum_))
        nodes, largest, sign = [], None, 0
        for z, error in zip(grid, errors):
            here = 1 if error > 0 else -1
            if here != sign:
                if largest is not None:
                    nodes.append(largest[1])
                sign, largest = here, (abs(error), z)
            elif abs(error) > largest[0]:
                largest = (abs(error), z)
        nodes.append(largest[1])
        assert len(nodes) == count + 1, len(nodes)
        worst = max(abs(e) for e in errors)
        if worst < abs(solution[count]) * mpf("1.001"):
            break
    return found, worst


def show(name, polynomial):
    coefficients, worst = polynomial
    print(f"{name}: relative error 2^{float(mp.log(worst, 2)):.1f}")
    for c in coefficients:
        print(f"    {float(c)!r},")


def top_bits(x, bits):
    """The leading bits of x, cut off."""
    scale = mpf(2) ** (bits - 1 - int(floor(mp.log(x, 2))))
    return floor(x * scale) / scale


# sin r = r - r z S(z), cos r = 1 - z/2 + z^2 C(z), atan r = r - r z A(z); all with z = r^2.
EIGHTH = (pi / 4 * (1 + mpf(2) ** -40)) ** 2
show("SINE", remez(lambda z: (1 - sin(sqrt(z)) / sqrt(z)) / z, lambda z: z * sqrt(z) / sin(sqrt(z)), EIGHTH, 6))
show("COSINE", remez(lambda z: (cos(sqrt(z)) - 1 + z / 2) / z**2, lambda z: z**2 / cos(sqrt(z)), EIGHTH, 6))
HALF = mpf(1) / 4 * (1 + mpf(2) ** -40)
show("ARCTANGENT", remez(lambda z: (1 - atan(sqrt(z)) / sqrt(z)) / z, lambda z: z * sqrt(z) / atan(sqrt(z)), HALF, 12))

first = top_bits(pi / 2, 39)
second = top_bits(pi / 2 - first, 39)
third = pi / 2 - first - second
print("QUARTER:", [repr(float(part)) for part in (first, second, third)])
print("PI / 2 - rounded:", repr(float(pi / 2 - float(pi / 2))), " PI - rounded:", repr(float(pi - float(pi))))
print("PI / 4 - rounded:", repr(float(pi / 4 - float(pi / 4))))
nearest = min((abs(n * pi / 2 - float(n * pi / 2)), n) for n in range(1, 2**14 + 1))
assert 3 * mpf(float(pi / 4)) == 3 * float(pi / 4), "three times the double of PI / 4 is a double"
print("closest to a multiple of a quarter turn below 2^14:", float(mp.log(nearest[0], 2)), nearest[1])

mp.prec = 1600
bits = int(floor(2 / pi * mpf(2) ** (21 * 64)))
print("TWO_OVER_PI:")
for limb in reversed(range(21)):
    print(f"    0x{bits >> (64 * limb) & (2**64 - 1):016x},")
print("PI / 2 as 2 + 126 bits:", hex(int(floor(pi / 2 * mpf(2) ** 126 + mpf(1) / 2))))
