// All front doors of the library: objects, questions about pairs, sets and regions, scenes, and certificates.
#pragma once

// Errors, and what a query cost.
#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/version.h>

// Certificates.
#include <sunder/certificate/asked_pair.h>
#include <sunder/certificate/check.h>
#include <sunder/certificate/claims.h>
#include <sunder/certificate/optimum.h>
#include <sunder/certificate/pair_answer.h>
#include <sunder/certificate/pair_claims.h>

// The plane: objects.
#include <sunder/planar/object/constraints.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/discs.h>
#include <sunder/planar/object/line.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/object/pose.h>
#include <sunder/planar/object/segments.h>

// The plane: two objects.
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/disc_disc.h>
#include <sunder/planar/pair/extreme_vertex.h>
#include <sunder/planar/pair/polygon_half_plane.h>
#include <sunder/planar/pair/polygon_line.h>
#include <sunder/planar/pair/polygon_point.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_boundary.h>
#include <sunder/planar/pair/polygon_polygon_depth.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>
#include <sunder/planar/pair/polygon_polygon_intersection.h>
#include <sunder/planar/pair/polygon_ray.h>
#include <sunder/planar/pair/polygon_segment.h>
#include <sunder/planar/pair/polygon_unbounded.h>
#include <sunder/planar/pair/segment_segment.h>

// The plane: sets.
#include <sunder/planar/boxes/boxes.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/discs/discs_any.h>
#include <sunder/planar/discs/discs_any_claims.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/planar/polygons/convex_polygons_any_claims.h>
#include <sunder/planar/polygons/polygon_mend.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/planar/polygons/polygon_valid_claims.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_any.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/planar/segments/drawing_plane.h>
#include <sunder/planar/segments/intervals_any.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_any.h>
#include <sunder/planar/segments/segments_claims.h>

// The plane: regions.
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/disc_intersection_claims.h>
#include <sunder/planar/region/discs_deepest.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/kernel.h>
#include <sunder/planar/region/linear_program.h>
#include <sunder/planar/region/linear_program_claims.h>
#include <sunder/planar/region/regions_claims.h>

// Space: bodies, two of them, and scenes of many.
#include <sunder/scene/clearance.h>
#include <sunder/scene/clearance_follower.h>
#include <sunder/scene/follower.h>
#include <sunder/scene/scene.h>
#include <sunder/scene/scene_claims.h>
#include <sunder/scene/sweep.h>
#include <sunder/scene/timeline.h>
#include <sunder/solid/hull/convex_hull.h>
#include <sunder/solid/line/flat_flat.h>
#include <sunder/solid/line/line_line.h>
#include <sunder/solid/line/plane_line.h>
#include <sunder/solid/line/plane_plane.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/line/polyhedron_line_support.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_claims.h>
#include <sunder/solid/mesh/mesh_convexity.h>
#include <sunder/solid/mesh/mesh_cover.h>
#include <sunder/solid/mesh/mesh_crossings.h>
#include <sunder/solid/mesh/mesh_departure.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_flat_claims.h>
#include <sunder/solid/mesh/mesh_line.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_motion.h>
#include <sunder/solid/mesh/mesh_overlap.h>
#include <sunder/solid/mesh/mesh_partition.h>
#include <sunder/solid/mesh/mesh_plane.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/mesh_relation.h>
#include <sunder/solid/mesh/mesh_round.h>
#include <sunder/solid/mesh/mesh_round_claims.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/frame.h>
#include <sunder/solid/object/hull_claims.h>
#include <sunder/solid/object/line.h>
#include <sunder/solid/object/plane.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polygon.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_batch.h>
#include <sunder/solid/pair/polyhedron_polyhedron_boundary.h>
#include <sunder/solid/pair/polyhedron_polyhedron_depth.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/pair/polyhedron_polyhedron_sweep.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>
#include <sunder/solid/round/round_claims.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_closer.h>
#include <sunder/solid/round/round_contact.h>
#include <sunder/solid/round/round_depth.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/round/round_round_sweep.h>
#include <sunder/solid/round/round_round_warm.h>
#include <sunder/solid/section/polyhedron_plane.h>
#include <sunder/solid/section/polyhedron_plane_claims.h>
#include <sunder/solid/section/polyhedron_plane_section.h>
#include <sunder/solid/section/section_area.h>

// Any dimension.
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/hull/vertices.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>
#include <sunder/polytope/pair/polytope_claims.h>
#include <sunder/polytope/pair/polytope_point.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/region/half_space_region.h>
#include <sunder/polytope/region/linear_program.h>
#include <sunder/polytope/region/region_vertices.h>
#include <sunder/polytope/represent/hierarchical_tree.h>
#include <sunder/polytope/tree/face_trees.h>
#include <sunder/polytope/tree/polytope_polytope_by_tree.h>
