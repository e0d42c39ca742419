/* Mesh: the topology of the moving objects, made once. */
#ifndef TAMIS_C_MESH_H
#define TAMIS_C_MESH_H
#include "tamis/c/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tamis_mesh tamis_mesh;

typedef struct tamis_mesh_input {
  size_t size;
  int32_t vertex_count;        /**< number of rows of the positions of every step, >= 0 */
  const int32_t* faces;        /**< face_count x 3 vertex indices, any winding */
  size_t face_count;           /**< may be 0 */
  const int32_t* loose_edges;  /**< loose_edge_count x 2: rods */
  size_t loose_edge_count;     /**< may be 0 */
  const int32_t* loose_points; /**< vertices of no face and no edge that still take part in contacts */
  size_t loose_point_count;    /**< may be 0 */
} tamis_mesh_input;

/** TAMIS_INVALID_MESH: an index is outside [0, vertex_count), or there is no feature at all. */
TAMIS_API tamis_status tamis_mesh_create(const tamis_mesh_input* input, tamis_mesh** mesh);
TAMIS_API void tamis_mesh_free(tamis_mesh* mesh);
/** The message of the last call with this mesh; "" after TAMIS_OK. */
TAMIS_API const char* tamis_mesh_message(const tamis_mesh* mesh);
/** Every edge of a triangle and every loose edge, once: count x 2, vertices ascending, sorted. Another library's list
 * of the same edges need not have this order: see tamis_mesh_find_edges(). The array lives as long as the mesh. NULL,
 * and count 0, for a mesh that could not be made. */
TAMIS_API const int32_t* tamis_mesh_edges(const tamis_mesh* mesh, size_t* count);
/** The vertices that take part in contacts, ascending; otherwise the same. */
TAMIS_API const int32_t* tamis_mesh_points(const tamis_mesh* mesh, size_t* count);
/** Writes both features of a contact or a near pair: of a face its place among the faces that the mesh was made with,
 * of an edge its place in tamis_mesh_edges(), of a vertex its index. For callers who keep data by feature.
 * TAMIS_INVALID_ARGUMENT: there is no such kind. TAMIS_INVALID_MESH: the mesh has no such vertex, edge or face (a face
 * with its vertices in another order is not found). */
TAMIS_API tamis_status tamis_mesh_features_of(tamis_mesh* mesh, int32_t kind, const int32_t* vertices, int32_t* first,
                                              int32_t* second);
/** Finds edges by their vertices: `edges` is count x 2, in either order. Writes for each its place in
 * tamis_mesh_edges(), or -1 if the mesh has no such edge. For data that follows another list of the same edges. */
TAMIS_API tamis_status tamis_mesh_find_edges(tamis_mesh* mesh, const int32_t* edges, size_t count, int32_t* places);
/** Finds faces by their vertices, count x 3 in the mesh's order: writes for each its place among the faces that the
 * mesh was made with, or -1. */
TAMIS_API tamis_status tamis_mesh_find_faces(tamis_mesh* mesh, const int32_t* faces, size_t count, int32_t* places);

#ifdef __cplusplus
}
#endif
#endif
