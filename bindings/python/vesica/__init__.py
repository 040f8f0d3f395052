# SPDX-License-Identifier: Apache-2.0
"""Vesica: exact overlap queries between plain 2D shapes, for numpy.

    import vesica

    cars = vesica.rects([[0, 0, 4, 2, 30], [9, 1, 4, 2, 0]], degrees=True)  # x, y, width, height, angle
    people = vesica.circles([[1.4, 1.5, 0.5], [8, 1, 0.5]])                  # x, y, radius

    vesica.overlap(cars, people)         # array([ True,  True])
    vesica.iou_matrix(cars, cars)        # 2 x 2
    vesica.overlap(cars[0], people[0])   # True

Shapes are closed and solid, and touching is overlap. Answers that are yes or no are exact for every valid input. Arrays
are used where they lie, whatever their strides; float64 and float32 are equals. The interpreter's lock is released
during every call, and more than 100,000 answers are divided among threads (`threads=1`: not). An invalid shape is a VesicaError, whose `result` has the
answers of all others. `vesica.c` is the C library itself, and help(vesica.c.vesica_nearest_f64) has its text.
"""
from ._library import VesicaError, isa_name
from ._library import library as c
from .construct import (
    aabbs_from_corners,
    capsules_from_angle,
    capsules_from_width,
    ellipses_from_matrix,
    ellipses_from_radius_vector,
)
from .coverage import coverage, coverage_cells
from .detection import Outcome, Truth, assign_greedy, average_precision, fuse, match_truths
from .hull import convex_hull, min_area_rects, min_perimeter_rects
from .index import Index
from .motion import Cast, Impact, Manifold, Turn, cast, cast_first, impact_time, manifold, sweep_bounds
from .paths import polygons, polylines
from .polygon import Facts, PolygonBoxes, polygon_facts
from .queries import (
    ClosestPoints,
    Crossings,
    Gaussian,
    Penetration,
    Ratio,
    Relation,
    Within,
    area,
    area_matrix,
    boundary_distance,
    boundary_distance_matrix,
    bounds,
    contains,
    contains_matrix,
    corners,
    crossings,
    depth,
    depth_matrix,
    gaussian_distance,
    gaussian_distance_matrix,
    interiors_overlap,
    interiors_overlap_matrix,
    interiors_overlap_select,
    iou,
    iou_matrix,
    nearest,
    nearest_matrix,
    nms,
    nms_soft,
    overlap,
    overlap_matrix,
    overlap_select,
    ratio,
    ratio_matrix,
    relation,
    relation_matrix,
    shape_area,
    signed_distance,
    signed_distance_matrix,
    within,
    within_matrix,
)
from .shapes import (
    FIELDS,
    Kind,
    Shapes,
    aabbs,
    boxes,
    capsules,
    check,
    circles,
    ellipses,
    ellipses_from_covariance,
    ellipses_in_boxes,
    points,
    rect_corners_misfit,
    rects,
    rects_from_corners,
    round_rects,
    segments,
    shapes,
)
from .topology import de9im, de9im_match, intersection
from .volume import volume_ratio, volume_ratio_matrix

__version__ = "{}.{}.{}".format(c.vesica_version_major(), c.vesica_version_minor(), c.vesica_version_patch())
_MODULES = "detection", "hull", "queries", "index", "paths", "motion", "topology", "volume", "construct", "polygon", "arrow"
__all__ = [name for name in dir() if not name.startswith("_") and name not in _MODULES]
