"""What is given as an array, for the bindings: exactly the same numbers as doubles, or an Error."""
import numpy

from sunder._error import Error

MOST = 2**53  # up to here every whole number is a double


def _words(shapes):
    return " or ".join("(%s)" % ", ".join("N" if n < 0 else str(n) for n in shape) + (" " if len(shape) == 1 else "")
                       for shape in shapes).strip()


def _array(given, place):
    if isinstance(given, numpy.ma.MaskedArray):
        raise Error("bad-value", place, "the array is masked, and what is masked would count; give .compressed() or .data")
    try:
        return numpy.asarray(given)
    except Error:
        raise
    except Exception as error:
        raise Error("bad-shape", place, "this is no array: %s" % error) from None


def _is_rounded(array, doubles):
    kind = array.dtype.kind
    if kind == "f":
        return array.dtype.itemsize > 8 and not numpy.array_equal(array, doubles, equal_nan=True)
    return array.dtype.itemsize > 4 and bool(numpy.any(array > MOST) or kind == "i" and numpy.any(array < -MOST))


def doubles(given, place, shapes):
    """A C-contiguous array of doubles of one of the shapes, where -1 is any length."""
    array = _array(given, place)
    if array.shape == (0,) and any(shape[0] < 0 for shape in shapes):
        return numpy.empty([max(n, 0) for n in shapes[0]])
    if array.dtype.kind not in "fiu":
        raise Error("bad-value", place, "its type is %s; give float64, or numbers that are doubles" % array.dtype)
    if not any(len(shape) == array.ndim and all(n in (-1, m) for n, m in zip(shape, array.shape)) for shape in shapes):
        raise Error("bad-shape", place, "its shape is %s; give %s" % (array.shape, _words(shapes)))
    with numpy.errstate(all="ignore"):
        result = numpy.ascontiguousarray(array, dtype=numpy.float64)
    if _is_rounded(array, result):
        raise Error("bad-value", place, "a number of it is no double, and would be rounded; give float64")
    return result


def numbers_of_groups(given, size, place):
    """For each member the number of its group. Groups may be told by whole numbers or by texts."""
    array = _array(given, place)
    if array.dtype.kind not in "biuSU" and array.size:
        raise Error("bad-value", place, "its type is %s; give whole numbers or texts" % array.dtype)
    if array.shape != (size,):
        raise Error("bad-shape", place, "its shape is %s; give one group for each of the %d members" % (array.shape, size))
    return numpy.ascontiguousarray(numpy.unique(array, return_inverse=True)[1].reshape(size), dtype=numpy.uint32)
