"""Writes reference.txt:  python3 reference.py > reference.txt  (with mpmath 1.3)

A real is written `-<hex>p<exponent>`: the hexadecimal fraction 0.<hex> times two to that power, exactly.
A double is written as its 64 bits.
"""

import random
import struct
from fractions import Fraction

from mpmath import mp, mpf

random.seed(6)
BITS = 256
mp.prec = BITS


def text(x):
    """A real of at most 256 bits."""
    sign, man, exp, count = x._mpf_
    if man == 0:
        return "0"
    assert count <= BITS, count
    digits = f"{man << (BITS - count):064x}".rstrip("0")
    return f"{'-' if sign else ''}{digits}p{exp + count}"


def rounded(compute):
    """A result to 256 bits, from one to 1600."""
    with mp.workprec(1600):
        exact = compute()
    return +exact


def real(bits, low, high):
    """A random real of so many bits, its first one between 2^low and 2^high."""
    man = random.getrandbits(bits) | 1 | 1 << (bits - 1)
    return mpf(random.choice((man, -man))) * mpf(2) ** (random.randint(low, high) - bits + 1)


def limbs():
    """A real whose limbs are all zeros, all ones or nearly so: the rare branches of long division."""
    man = 0
    for _ in range(4):
        man = man << 64 | random.choice((0, 1, 2**63, 2**64 - 2, 2**64 - 1, random.getrandbits(64)))
    return mpf(man | 1 << 255) * mpf(2) ** -255


def line(name, arguments, *results):
    print(name, *map(text, arguments), *map(text, results))


def double(x):
    """The bits of the double nearest to a fraction."""
    try:
        value = x.numerator / x.denominator  # Python divides integers with correct rounding.
    except OverflowError:
        value = float("inf") if x > 0 else float("-inf")
    return f"{struct.unpack('>Q', struct.pack('>d', value))[0]:016x}"


def fraction(x):
    sign, man, exp, _ = x._mpf_
    return Fraction(int(man)) * Fraction(2) ** exp * (-1 if sign else 1)


def arithmetic():
    for i in range(40):
        a, b = (limbs(), limbs()) if i < 16 else (real(256, -3, 3), real(random.choice((53, 256)), -3, 3))
        if i >= 32:
            b = real(256, -330, -200)
        line("add", (a, b), rounded(lambda: a + b))
        line("mul", (a, b), rounded(lambda: a * b))
        line("div", (a, b), rounded(lambda: a / b))
        line("sqrt", (abs(a),), rounded(lambda: mp.sqrt(abs(a))))
    for _ in range(30):
        a, b = limbs(), limbs()
        line("div", (a, b), rounded(lambda: a / b))


def angles():
    for i in range(90):
        bits = random.choice((24, 53, 256))
        x = real(bits, *((-4, 3), (-4, 3), (-300, -2), (3, 64), (64, 190))[i % 5])
        if i % 10 == 9:
            n = random.getrandbits(random.choice((2, 20, 60, 120))) | 1
            with mp.workprec(bits):
                x = n * mp.pi / 2
        line("sin_cos", (x,), rounded(lambda: mp.sin(x)), rounded(lambda: mp.cos(x)))
    for i in range(90):
        bits = random.choice((24, 53, 256))
        y, x = real(bits, -4, 4), real(bits, *((-4, 4), (-4, 4), (-300, 300))[i % 3])
        line("atan2", (y, x), rounded(lambda: mp.atan2(y, x)))


def sums():
    """a/b · π + c/d, the rational part all but cancelling the other in some."""
    for i in range(24):
        a, b = random.getrandbits(random.choice((8, 60, 126))) - 2**59, random.getrandbits(60) | 1
        c, d = random.getrandbits(random.choice((8, 126))) - 2**125, random.getrandbits(random.choice((8, 126))) | 1
        if i % 2:
            with mp.workprec(1600):
                near = -mp.pi * a / b
                close = Fraction(int(mp.floor(near * 2**900)), 2**900).limit_denominator(2**100)
            c, d = close.numerator, close.denominator
        with mp.workprec(1600):
            value = mp.pi * a / b + mpf(c) / d
        if max(abs(a), abs(c)) < 2**127:
            print("angle", a, b, c, d, text(rounded(lambda: value)))


def doubles():
    for i in range(80):
        man = random.getrandbits(53) | 1 << 52
        x = mpf(man) * mpf(2) ** random.randint(-1140 + 52, 1030 - 53)
        if i % 4:
            # Between two doubles, or between two subnormal ones: on the mark, just below, just above.
            x = (mpf(man) + mpf("0.5")) * mpf(2) ** random.randint(-100, 100)
            if i % 8 > 3:
                kept = random.randint(0, 52)
                x = (mpf(random.getrandbits(kept)) + mpf("0.5")) * mpf(2) ** -1074
            x += x * mpf(2) ** -190 * (0, 0, 1, -1)[i % 4]
        x *= random.choice((1, -1))
        print("double", text(x), double(fraction(x)))
    for man, exp in ((2**54 - 1, 970), (2**54 - 2, 970), (2**55 - 3, 969), (1, 1024), (1, -1075), (3, -1076), (3, -1075)):
        print("double", text(mpf(man) * mpf(2) ** exp), double(Fraction(man) * Fraction(2) ** exp))
    for _ in range(40):
        num = random.getrandbits(random.choice((4, 53, 54, 90, 127))) - 8
        den = random.getrandbits(random.choice((4, 20, 53, 127))) | 1
        print("ratio", num, den, double(Fraction(num, den)))


print("# python3 reference.py > reference.txt")
arithmetic()
angles()
sums()
doubles()
