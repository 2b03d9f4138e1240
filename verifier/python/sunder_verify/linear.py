"""What many rules share: numbers that compare, weighted sums of rows, signs of roots, elimination, closed surfaces.
All of it is exact."""
from .reader import common, length, require
from .tables import dot


def aligned(m, e, n, f):
    """Two integers that compare as m * 2^e and n * 2^f do."""
    return m << max(e - f, 0), n << max(f - e, 0)


def weighted_sum(steps, weights, row_of, least=1, rule="weights", reason="a weight is not positive"):
    """Of rows of integers * 2^e, which stands last, those named times their weights: integers / d * 2^e, and d, e."""
    whole = length([weight for _, weight in weights])
    steps.take(len(weights) // 4 + 1, whole, whole)
    require(all(n >= least for _, (n, _, _) in weights), rule, reason)
    rows = [row_of(k) for k, _ in weights]
    factors, d, e = common([(n, d, e + row[-1]) for row, (_, (n, d, e)) in zip(rows, weights)])
    return [dot(factors, column) for column in list(zip(*rows))[:-1]], d, e


def mean_of(steps, rule, weights, body, row_of):
    """Of points of a body, whose rows end in 1, and of ways, whose rows end in 0: integers / d * 2^e, and d, e."""
    (*mean, total), d, e = weighted_sum(steps, weights, row_of, 0, rule, "a weight of %s is negative" % body.name)
    total, one = aligned(total, e, d, 0)
    require(total == one, rule, "the weights of %s do not sum to 1" % body.name)
    return mean, d, e


def way_between(p, q):
    """From one point x, .., w to another, times both w."""
    return [y * p[-1] - x * q[-1] for x, y in zip(p[:-1], q)]


def sum_of(rows):
    return [sum(axis) for axis in zip(*rows)]


def from_mean(rows, named):
    """All rows, from the mean of the named ones, as many times as far as there are of these."""
    mean = sum_of(rows[k] for k in named)
    return [[len(named) * x - y for x, y in zip(row, mean)] for row in rows]


# ---- Signs of roots.

def sign(n):
    return (n > 0) - (n < 0)


def product(x, y, roots):
    """Of numbers p + q sqrt(r), r the last of the roots, as pairs p, q; these are such numbers of the other roots."""
    if not roots:
        return x * y
    (p, q), (s, t), (*others, r) = x, y, roots
    across = product(p, t, others), product(q, s, others)
    return (added(product(p, s, others), product(q, t, others), r), added(*across, 1))


def added(x, y, times):
    return x + times * y if isinstance(x, int) else tuple(added(a, b, times) for a, b in zip(x, y))


def sign_of(x, *roots):
    """The sign of such a number. No number under a root is negative."""
    if not roots:
        return sign(x)
    (p, q), (*others, r) = x, roots
    a, b = sign_of(p, *others), sign_of(q, *others) if r else 0
    if a * b >= 0:
        return a or b
    return a * sign_of(added(product(p, p, others), product(q, q, others), -r), *others)


# ---- Elimination.

class Basis:
    """Rows that are independent in their first columns, as combinations of them: each has `unit` in a column of its own,
    and 0 in those of the others (Bareiss, Jordan)."""

    def __init__(self, columns, rows=()):
        self.columns, self.pivots, self.rows, self.unit = columns, [], [], 1
        self.are_all = all([self.take(row) for row in rows])

    def rest(self, row):
        """`unit` times a row, less what makes it 0 in all columns of rows."""
        left = [self.unit * x for x in row]
        for column, other in zip(self.pivots, self.rows):
            if row[column]:
                left = [x - row[column] * y for x, y in zip(left, other)]
        return left

    def take(self, row):
        """Is it independent of those before? If so, it is one more."""
        left = self.rest(row)
        column = next((c for c in range(self.columns) if left[c]), None)
        if column is None:
            return False
        pivot = left[column]
        self.rows = [[(pivot * x - other[column] * y) // self.unit for x, y in zip(other, left)] for other in self.rows]
        self.rows.append(left)
        self.pivots.append(column)
        self.unit = pivot
        return True

    def is_positive(self):
        """Of as many rows as columns: is their determinant?"""
        return is_odd(self.pivots) != (self.unit > 0)


def is_odd(order):
    """Does it take an odd number of exchanges to sort different numbers?"""
    return sum(i > j for k, i in enumerate(order) for j in order[k + 1:]) % 2 == 1


# ---- Closed surfaces: simplices, each on one side of its ridges, which are their corners but one.

class Surface:
    def __init__(self, rule):
        self.rule, self.owners = rule, {}

    def take(self, simplex, i, owner, reason):
        """The ridge of a simplex without corner i, seen from the side on which the simplex is. It has one owner."""
        key = self.key(simplex, i)
        require(key not in self.owners, self.rule, reason)
        self.owners[key] = owner

    @staticmethod
    def key(simplex, i, other_side=False):
        ridge = [*simplex[:i], *simplex[i + 1:]]
        return (*sorted(ridge), (is_odd(ridge) == (i % 2 == 1)) != other_side)

    def beyond(self, simplex, i, reason):
        """The owner of the ridge seen from its other side; there is one."""
        key = self.key(simplex, i, True)
        require(key in self.owners, self.rule, reason)
        return self.owners[key]
