"""Arrays of every shape, type and layout: taken with exactly their numbers, or refused with kind, place and text."""
import gc
import pickle
import sys

import numpy as np
import pytest
import sunder
from sunder import planar, solid

from helpers import refused

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
TAKES = [  # what takes an array: a name for the place, the call, an array it takes
    ("segments", planar.Segments, np.arange(12.0).reshape(3, 4)),
    ("discs", planar.Discs, np.arange(12.0).reshape(4, 3)),
    ("constraints", planar.Constraints, np.arange(1.0, 13.0).reshape(4, 3)),
    ("vertices", planar.ConvexPolygon.from_vertices, SQUARE),
    ("vertices", planar.ConvexPolygon.mended, SQUARE),
    ("points", planar.ConvexPolygon.hull_of, SQUARE),
    ("points", solid.ConvexPolyhedron, CUBE),
    ("points", solid.hull_certificate, CUBE),
    ("linear", lambda a: planar.Pose.from_matrix(a, [0, 0]), np.array([[1.0, 2], [3, 4]])),
    ("translation", lambda a: planar.Pose.from_angle(1, a), np.array([1.0, 2])),
    ("linear", lambda a: solid.Pose.from_matrix(a, [0, 0, 0]), 2 * np.eye(3)),
    ("rows", solid.Pose.from_matrix4, np.eye(4)),
    ("objective", lambda a: planar.linear_program(planar.Constraints([[1, 0, 1]]), a), np.array([1.0, 0])),
    ("ring", planar.kernel, SQUARE),
    ("parts", planar.polygon_defects, SQUARE),
    ("polygons[0]", lambda a: planar.Polygons([a]), SQUARE),
    ("poses_a", lambda a: sunder.intersect_many(BODY, a, BODY, None), np.eye(3, 4).reshape(1, 3, 4)),
    ("poses_b", lambda a: sunder.intersect_many(PLATE, None, PLATE, a), np.eye(2, 3).reshape(1, 2, 3)),
]
BODY, PLATE = solid.ConvexPolyhedron(CUBE), planar.ConvexPolygon.from_vertices(SQUARE)
each = pytest.mark.parametrize("place, call, array", TAKES)


@each
def test_every_layout_that_holds_the_same_doubles(place, call, array):
    spread = np.zeros([2 * n for n in array.shape])
    spread[tuple(slice(None, None, 2) for _ in array.shape)] = array
    call(array)
    call(array.tolist())
    call(np.asfortranarray(array))
    call(spread[tuple(slice(None, None, 2) for _ in array.shape)])
    call(array[::-1][::-1])
    call(array.astype(">f8"))
    call(array.astype(np.float32))
    call(array.astype(np.int16))
    call(array.astype(np.uint64))
    call(array.astype(np.longdouble))
    read_only = array.copy()
    read_only.flags.writeable = False
    call(read_only)


@each
def test_wrong_shapes(place, call, array):
    scalar = array[(0,) * array.ndim]
    for wrong in (scalar, array.reshape(1, 1, 1, *array.shape), np.arange(1.0, 6.0), np.zeros((7, 5)),
                  np.zeros((0, 5)), np.zeros((3, 0)), np.zeros((2, 7, 3))):
        with pytest.raises(sunder.Error) as caught:
            call(wrong)
        assert caught.value.kind == "bad-shape" and place.split("[")[0] in caught.value.place, (wrong, caught.value)


@each
def test_wrong_types(place, call, array):
    masked = np.ma.array(array, mask=False)
    masked[(0,) * array.ndim] = np.ma.masked
    for wrong in (array.astype(complex), array.astype(str), array.astype(object), array.astype(bool), masked,
                  array.astype("datetime64[s]")):
        with pytest.raises(sunder.Error) as caught:
            call(wrong)
        assert caught.value.kind == "bad-value" and caught.value.place, (wrong.dtype, caught.value)
    for wrong in ("text", b"bytes", {}, {1, 2}, object(), [[1, 2], [3]], iter([]), 5, [None], [[]], [[[[[[[[]]]]]]]]):
        with pytest.raises(sunder.Error):
            call(wrong)


@each
def test_numbers_that_no_double_holds_are_refused(place, call, array):
    large = array.astype(np.int64)
    large[(0,) * array.ndim] = 2**53 + 1
    with pytest.raises(sunder.Error, match="no double"):
        call(large)
    for least in (np.iinfo(np.int64).min, np.iinfo(np.int64).max):
        large[(0,) * array.ndim] = least
        with pytest.raises(sunder.Error, match="no double"):
            call(large)
    with pytest.raises(sunder.Error, match="no double"):
        call(np.full(array.shape, 2**64 - 1, dtype=np.uint64))
    if np.finfo(np.longdouble).nmant > 52:
        with pytest.raises(sunder.Error, match="no double"):
            call(array.astype(np.longdouble) + np.longdouble(2) ** -60)
    with pytest.raises(sunder.Error):
        call([[2**70, 1], [2, 3]])


@each
def test_numbers_that_are_not_finite(place, call, array):
    for value in (np.nan, np.inf, -np.inf):
        wrong = array.copy()
        wrong[(0,) * array.ndim] = value
        with pytest.raises(sunder.Error) as caught:
            call(wrong)
        assert caught.value.kind in ("bad-value", "bad-pose") and caught.value.place


def test_a_list_that_holds_itself():
    ring = []
    ring.append(ring)
    for call in (planar.polygon_defects, planar.kernel, planar.Polygons, planar.Segments):
        with pytest.raises(sunder.Error):
            call(ring)


def test_what_raises_while_it_is_read():
    class Broken:
        def __array__(self, *_, **__):
            raise RuntimeError("broken on purpose")

    assert "broken on purpose" in refused("bad-shape", "segments", planar.Segments, Broken())


def test_objects_keep_what_they_were_made_of():
    points = CUBE.copy()
    body = solid.ConvexPolyhedron(points)
    points[:] = np.nan
    assert np.array_equal(body.vertices[np.argsort(body.source)], CUBE)
    body.vertices[:] = 7  # a copy
    assert np.array_equal(body.vertices[np.argsort(body.source)], CUBE)


def test_arrays_outlive_their_objects():
    vertices = solid.ConvexPolyhedron(CUBE).vertices
    corners = planar.half_plane_intersection(planar.Constraints([[1, 0, 1], [-1, 0, 0], [0, 1, 1], [0, -1, 0]])).corners
    gc.collect()
    assert len(np.unique(vertices, axis=0)) == 8 and sorted(map(tuple, corners)) == [(0, 0), (0, 1), (1, 0), (1, 1)]


def test_certificates_outlive_their_objects():
    answer = planar.segments_any(planar.Segments([[0, 0, 1, 1]]))
    other = sunder.intersect(planar.ConvexPolygon.hull_of(SQUARE), planar.ConvexPolygon.hull_of(SQUARE + 5))
    gc.collect()
    assert answer.certificate() and other.certificate()


def test_nothing_leaks():
    def once():
        body = solid.ConvexPolyhedron(CUBE)
        sunder.intersect_many([body] * 3, np.tile(np.eye(3, 4), (3, 1, 1)), body, None)
        sunder.intersect(body, body).certificate()
        with pytest.raises(sunder.Error):
            planar.Segments([[1]])
        return sys.getrefcount(body)

    before = once()
    assert all(once() == before for _ in range(50))


def test_messages():
    assert refused("bad-shape", "segments", planar.Segments, np.zeros((3, 5))) == \
        "its shape is (3, 5); give (N, 4) or (N, 2, 2)"
    assert refused("bad-value", "segment 1", planar.Segments, [[0, 0, 1, 1], [0, 0, np.nan, 1]])
    assert refused("bad-value", "point 2", solid.ConvexPolyhedron, [[0, 0, 0], [1, 0, 0], [0, np.inf, 0]])
    assert refused("bad-shape", "", solid.ConvexPolyhedron, np.zeros((0, 3)))
    error = pytest.raises(sunder.Error, planar.Segments, [[1]]).value
    again = pickle.loads(pickle.dumps(error))
    assert (again.kind, again.place, again.text, str(again)) == (error.kind, error.place, error.text, str(error))


def test_wrong_objects_are_type_errors():
    for call in (lambda: sunder.intersect(BODY, PLATE), lambda: sunder.intersect(None, None),
                 lambda: planar.segments_any([[0, 0, 1, 1]]), lambda: planar.discs_any(planar.Segments([])),
                 lambda: planar.half_plane_intersection(None), lambda: planar.Segments(None),
                 lambda: planar.convex_polygons_any([BODY]), lambda: planar.convex_polygons_any([None])):
        with pytest.raises(TypeError):
            call()


def test_empty_sets():
    assert not planar.segments_any(planar.Segments([]))
    assert planar.discs_count(planar.Discs(np.zeros((0, 3)))).count == 0
    assert planar.polygons_all(planar.Polygons([])).pairs.shape == (0, 2)
    assert not planar.convex_polygons_any([])
    assert planar.half_plane_intersection(planar.Constraints([])).kind == "plane"
    assert planar.linear_program(planar.Constraints([]), (1, 0)).outcome == "unbounded"
    assert planar.disc_intersection(planar.Discs([])).kind == planar.convex_polygon_intersection([]).kind == "plane"
