// What each format of meshes allows. Readers of any of them ask mesh.h. Errors: see read_mesh.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>

#include <filesystem>
#include <functional>
#include <string>

namespace sunder::io {

// Wavefront OBJ.
// Read: "v x y z" (a weight, or a colour with or without its opacity, may follow and is left out), "f" with corners v,
// v/vt, v//vn and v/vt/vn, numbered from 1, or from -1 backwards; "o NAME" begins a part, and where groups are asked
// for "g NAME", too (the names after its first are left out). A corner may name a vertex that comes later in the file.
// Comments, and lines continued by a backslash. No part of a mesh, and not told: texture coordinates, normals, groups,
// materials. Told in left_out, where there are faces: points, lines. Refused: free-form curves and surfaces, any other
// statement, a face with fewer than 3 corners. Errors: see read_mesh. Cost: linear.
Mesh parse_obj(std::string_view bytes, std::string_view place, PartsOf parts = PartsOf::objects);

// STL, ASCII and binary.
// True when the size is exactly that of the binary STL which the bytes 80 to 83 promise: 84 + 50 times the number of
// triangles, which is not zero. It may begin with "solid" all the same.
bool is_binary_stl(std::string_view bytes);

// ASCII: any number of solids, each a part; keywords in any case, words parted by any blanks and line breaks; numbers
// in full double precision. Binary: single precision, exactly as stored; the size must match the count.
// Equal points become one vertex. Left out: normals (which may be NaN), and the attribute bytes of a binary triangle.
// Errors: see read_mesh; a file without a triangle is refused. Cost: n log n.
Mesh parse_stl(std::string_view bytes, std::string_view place);

// PLY (Stanford polygon format), ASCII and binary of both byte orders.
// Read: the properties x, y, z of the element "vertex", of any plain type; the list "vertex_indices" or "vertex_index"
// of the element "face", of any integer type. Type names of both generations (float, float32, ...). No part of a mesh,
// and not told: all other properties, plain or lists, comments, the elements "camera", "material", "texture". Other
// elements are told in left_out. In ASCII files each row stands on its own line. Without faces the mesh is a set of
// points. Refused: faces without that list, a face with fewer than 3 corners, anything after the last row. Errors: see
// read_mesh. Cost: linear.
Mesh parse_ply(std::string_view bytes, std::string_view place);

// Is it the first word of OFF, the text format of Geomview: with any of the prefixes ST, C, N, 4, n, in this order?
bool is_off_header(std::string_view word);

// Read: the header, the counts of vertices, faces and (left out) edges on its line or the next, then one vertex and one
// face per line. After x y z, normals, colours and texture coordinates may follow where the header announces them
// (NOFF, COFF, STOFF); after a face, a colour. They are left out. Comments from '#'.
// Refused: binary OFF, points of four or n dimensions, a face with fewer than 3 corners, lines beyond the counts.
// Errors: see read_mesh. Cost: linear.
Mesh parse_off(std::string_view bytes, std::string_view place);

// The formats of scenes: COLLADA, glTF, VRML. Each instance of a mesh in a node is a part, with the node's name, else
// the mesh's. Its points are moved by the nodes above it, in doubles (exact where these move nothing, or only turn by
// quarters about the axes). The up axis is told in `format`, and nothing is turned by it, as RViz, MoveIt, Gazebo and
// coal have it. What is made of instances is bounded by the size of the file (32 vertices, corners and nodes a byte).
// No part of a mesh, and not told: materials, lights, cameras, normals, animations; in COLLADA and VRML, where points
// are stores beside the faces, those that no face names.

// COLLADA 1.4 and 1.5.
// Read: geometry with triangles, polylist, polygons, trifans, tristrips; nodes with matrix, translate, rotate, scale;
// instances of geometry and of nodes; the scene that <scene> names, or the only one, or without one each geometry once.
// Coordinates are multiplied by the unit's metres, and this is told in `format`.
// Told in left_out: lines, polygons with holes, splines, skinned meshes.
// Refused: lookat, skew, maps that are not affine, instances out of other files, a face with fewer than 3 corners.
// Errors: see read_mesh. Cost: linear.
Mesh parse_collada(std::string_view bytes, std::string_view place);

// Reads a file that another names, relative to its folder. Throws Error.
using FileReader = std::function<std::string(const std::filesystem::path& relative)>;

// glTF 2.0, as JSON or binary (.glb), told by the first bytes. Metres. Equal points become one vertex.
// Read: triangles, strips and fans with positions of single precision (exactly as stored), indices of 8, 16, 32 bits;
// buffers in the file, as data: URIs in base64, and as files within the mesh's folder, by `read`, where given; nodes
// with matrix, or translation, rotation and scale; the default scene, else the first, else all nodes.
// Told in left_out: points, lines, skinned meshes.
// Refused: sparse accessors, morphs, extensions that the file requires, but for those of materials, textures, lights.
// Errors: see read_mesh. Cost: n log n.
Mesh parse_gltf(std::string_view bytes, std::string_view place, const FileReader& read = {});

// VRML 2 (VRML97) as text. Read: IndexedFaceSet in Shape, Group, Transform, Anchor, Collision; DEF and USE.
// Told in left_out: the other kinds of geometry; Switch, LOD, Inline, Billboard.
// Refused: PROTO, nodes that are not of VRML 2, a face with fewer than 3 corners. Errors: see read_mesh. Cost: linear.
Mesh parse_vrml(std::string_view bytes, std::string_view place);

// Is it a ZIP archive with the name of a model in it?
bool is_3mf(std::string_view bytes);

// 3MF, of its core specification (1.4): a ZIP archive whose _rels/.rels names a model in XML. The mesh is what its build
// items make together: each object with a mesh that they name, by components or not, is a part, with its name, else
// that of the object above it.
// Coordinates are in millimetres, which is the format's unit where it names none; so nothing is rounded there, and one
// question may be about files of different units. `format` names the unit of the file. Transforms are composed and
// applied in exact numbers; then each coordinate is rounded once, to the nearest double. A remark says how many are. A
// triangle that a transform turns over, by a negative determinant, is turned back. What no triangle names of <vertices>
// is no part of the mesh, and neither are objects that no item names.
// Read, too: other models of the package that the root's items and components name (production extension).
// Told in left_out: supports (objects of the types support and solidsupport); what extensions say of shapes, such as
// beam lattices, slices and boolean shapes. Told in remarks: materials, colours and textures.
// Refused: extensions that the file requires, but for those of models in several parts, of materials and of sets of
// triangles; transforms that make an object flat; a build without items; objects of other types; more than 64 bytes of
// models a byte of the file; archives that are encrypted, damaged, or compressed otherwise than by Deflate.
// Errors: see read_mesh; within the package they name the model, too. Cost: linear.
Mesh parse_3mf(std::string_view bytes, std::string_view place);

}  // namespace sunder::io
