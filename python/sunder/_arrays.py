"""What is given, for the bindings: arrays with exactly the same numbers as doubles, or an Error."""
import numpy

from sunder._error import Error

MOST = 2**53  # up to here every whole number is a double


def _array(given, place):
    if isinstance(given, numpy.ma.MaskedArray):
        raise Error("bad-value", place, "it is masked, and what is masked would count; give .compressed() or .data")
    try:
        return numpy.asarray(given)
    except Exception as error:
        raise Error("bad-shape", place, "this is no array: %s" % error) from None


def _is_rounded(array, doubles):
    if array.dtype.kind == "f":
        return array.dtype.itemsize > 8 and not numpy.array_equal(array, doubles, equal_nan=True)
    return array.dtype.itemsize > 4 and bool(numpy.any(array > MOST) or numpy.any(array < -MOST))


def doubles(given, place, *shapes):
    """A C-contiguous array of doubles of one of the shapes, where -1 is any length."""
    array = _array(given, place)
    if array.shape == (0,) and any(shape[0] < 0 for shape in shapes):
        return numpy.empty([max(n, 0) for n in shapes[0]])
    if array.dtype.kind not in "fiu":
        raise Error("bad-value", place, "its type is %s; give float64, or numbers that are doubles" % array.dtype)
    if not any(len(shape) == array.ndim and all(n in (-1, m) for n, m in zip(shape, array.shape)) for shape in shapes):
        words = " or ".join(str(tuple(shape)).replace("-1", "N") for shape in shapes)
        raise Error("bad-shape", place, "its shape is %s; give %s" % (array.shape, words))
    with numpy.errstate(all="ignore"):
        result = numpy.ascontiguousarray(array, dtype=numpy.float64)
    if _is_rounded(array, result):
        raise Error("bad-value", place, "a number of it is no double, and would be rounded; give float64")
    return result


def numbers_of_groups(given, size):
    """For each member the number of its group. Groups may be told by whole numbers or by texts."""
    array = _array(given, "groups")
    if array.dtype.kind not in "biuSU" and array.size:
        raise Error("bad-value", "groups", "its type is %s; give whole numbers or texts" % array.dtype)
    if array.shape != (size,):
        raise Error("bad-shape", "groups", "its shape is %s; give one for each of the %d members" % (array.shape, size))
    return numpy.unique(array, return_inverse=True)[1].reshape(size).astype(numpy.uint32)


def _depth(given, most=5):
    """0 for a number, 1 for a point, 2 for a ring, 3 for a list of rings, 4 for a list of such, by what comes first."""
    if not isinstance(given, (list, tuple)) or most == 0:
        return getattr(given, "ndim", 0)
    return 1 + _depth(given[0], most - 1) if given else 1


def rings(given, place):
    """A list of rings, or one ring: each an array of points."""
    if _depth(given) == 2:
        return [doubles(given, place, (-1, 2))]
    if _depth(given) != 3:
        raise Error("bad-shape", place, "give a list of rings, each an array of (N, 2) numbers; or one such ring")
    return [doubles(ring, "%s[%d]" % (place, k), (-1, 2)) for k, ring in enumerate(given)]


def parts(given, place):
    """A list of lists of rings, or one such."""
    if _depth(given) != 4:
        return [rings(given, place)]
    return polygons(given, place)


def polygons(given, place):
    if not isinstance(given, (list, tuple)) and getattr(given, "ndim", 0) < 3:
        raise Error("bad-shape", place, "give a list of polygons")
    return [rings(one, "%s[%d]" % (place, k)) for k, one in enumerate(given)]


def side(objects, poses, dimension, name):
    """One side of many pairs: objects, one or N; poses, an array of one or N; and N, or None where all are one."""
    many = isinstance(objects, (list, tuple))
    place, shape = "poses_" + name, (dimension, dimension + 1)
    if poses is None:
        rows = numpy.eye(*shape)
    elif hasattr(poses, "translation"):
        rows = numpy.column_stack([poses.linear, poses.translation])
    else:
        rows = doubles(poses, place, (-1, *shape), (-1, shape[0] * shape[1]), shape)
    each = rows.shape != shape
    if many and each and len(rows) != len(objects):
        raise Error("bad-shape", place, "%d poses for %d objects; give as many, or one" % (len(rows), len(objects)))
    count = len(rows) if each else len(objects) if many else None
    return list(objects) if many else [objects], numpy.ascontiguousarray(rows).reshape(-1, *shape), count
